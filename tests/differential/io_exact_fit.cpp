// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Exact fits on real shapes: every part P of the nesting data against its exact negative, a sheet with P cut out. P
// fits in at the one position where it was cut, and nowhere near; the same rotated by 90 degrees, and, with a
// clearance, against the negative of P grown by it, where arcs arise. No sampling, no tolerance could find these
// positions.

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "plane/complex/overlay.h"
#include "plane/complex/primitives.h"
#include "plane/contour/contour.h"
#include "plane/offset/level.h"
#include "plane/query/locate.h"
#include "plane/query/topology.h"
#include "plane/sum/minkowski.h"

namespace findspace::plane {
namespace io_exact_fit {

using exact::Real;

/// Parts of all instances with at most `vertices` vertices, in steps of a millionth of the data's unit.
std::vector<std::pair<std::string, Contour>> parts(std::size_t vertices) {
  std::vector<std::pair<std::string, Contour>> all;
  std::vector<std::filesystem::path> files;
  for (auto& f : std::filesystem::directory_iterator(FINDSPACE_SOURCE "/tests/data/nesting"))
    if (f.path().extension() == ".json") files.push_back(f.path());
  std::sort(files.begin(), files.end());
  for (auto& file : files) {
    std::ifstream in(file);
    nlohmann::json data_set = nlohmann::json::parse(in);
    for (auto& item : data_set.at("items")) {
      auto& shape = item.at("shape");
      auto& data = shape.at("type") == "polygon" ? shape.at("data").at("outer") : shape.at("data");
      if (data.size() > vertices) continue;
      Contour ring;
      for (auto& p : data)
        ring.push_back(
            {.start = {std::llround(p[0].get<double>() * 1000000), std::llround(p[1].get<double>() * 1000000)}});
      if (ring.front().start == ring.back().start) ring.pop_back();
      all.emplace_back(file.stem().string() + " part " + item.at("id").dump(), make_rings({ring}, 1e-6).contours[0]);
    }
  }
  return all;
}

Contour rotated(const Contour& ring) {
  Contour out = ring;
  for (ContourEdge& e : out) e.start = {-e.start.y, e.start.x};
  return out;
}

Region sheet_around(const Contour& ring, std::int64_t margin) {
  std::int64_t x0 = INT64_MAX, y0 = INT64_MAX, x1 = INT64_MIN, y1 = INT64_MIN;
  for (auto& e : ring) {
    x0 = std::min(x0, e.start.x);
    x1 = std::max(x1, e.start.x);
    y0 = std::min(y0, e.start.y);
    y1 = std::max(y1, e.start.y);
  }
  Contour box{{.start = {x0 - margin, y0 - margin}},
              {.start = {x1 + margin, y0 - margin}},
              {.start = {x1 + margin, y1 + margin}},
              {.start = {x0 - margin, y1 + margin}}};
  return region_of_rings(std::array{box});
}

/// The sheet with the interior of the hole taken out: a closed set.
Region negative(const Region& sheet, const Region& hole) {
  Region inside = interior(hole);
  std::array<const Region*, 2> both{&sheet, &inside};
  return subtract(both);
}

/// Is the origin an isolated 0 in the midst of -, or (for a part that just touches itself elsewhere) a 0 at all?
void expect_single_fit(const SignMap& map, const std::string& what) {
  Cell at = locate(map, exact::RealPoint{});
  ASSERT_EQ(at.dimension, 0) << what;
  const Vertex& v = map.vertices[at.index];
  EXPECT_EQ(v.mark, 0) << what;
  EXPECT_EQ(v.out, kNone) << what << ": not isolated";
  if (v.out == kNone) {
    EXPECT_EQ(map.faces[v.face].mark, -1) << what;
  }
}

TEST(ExactFit, EveryPartInItsNegative) {
  auto all = parts(500);
  ASSERT_GT(all.size(), 100u);
  for (auto& [name, ring] : all)
    for (const Contour& r : {ring, rotated(ring)}) {
      Region part = region_of_rings(std::array{r});
      expect_single_fit(contact_map(negative(sheet_around(r, 1000000), part), part), name);
    }
}

TEST(ExactFit, EveryPartInTheNegativeOfItsOffset) {
  auto all = parts(500);
  for (auto& [name, ring] : all) {
    Region part = region_of_rings(std::array{ring});
    Region grown = remark(distance_map(part, Real(2500000)), [](Mark m) { return Mark(m <= 0); });
    SignMap base = contact_map(negative(sheet_around(ring, 5000000), grown), part);
    expect_single_fit(level_map(base, Real(2500000)), name + ", clearance 2.5");
  }
}

}  // namespace io_exact_fit
}  // namespace findspace::plane
