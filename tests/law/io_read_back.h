// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Random regions written in every format of drawings and read back. On a lattice, where corners and centres are grid
// points, the very same set comes back. Elsewhere each point is rounded once, so nothing may be off by more than two
// steps, and nothing is refused: discs touch each other and the holes that they leave at points off the grid.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "io/export/write_drawing.h"
#include "io/export/write_wkt.h"
#include "io/read/read_file.h"
#include "io/write/write_svg.h"
#include "law/plane_random.h"
#include "plane/complex/primitives.h"
#include "plane/query/measure_cells.h"
#include "plane/walk/unite.h"

namespace findspace::io {

inline plane::Region triangle(plane::GridPoint a, plane::GridPoint b, plane::GridPoint c) {
  return plane::region_of_rings(std::array{plane::contour_of({a, b, c})});
}

inline plane::Region square(plane::GridPoint low, std::int64_t width, std::int64_t height) {
  const plane::GridPoint high{low.x + width, low.y + height};
  return plane::region_of_rings(std::array{plane::contour_of({low, {high.x, low.y}, high, {low.x, high.y}})});
}

/// What is left of `set` with one more part, or without its inside.
inline plane::Region combined(const plane::Region& set, const plane::Region& part, bool add) {
  const plane::Region open = plane::interior(part);
  const std::vector<const plane::Region*> both{&set, add ? &part : &open};
  return plane::regularize(add ? plane::unite(both) : plane::subtract(both));
}

/// Discs, boxes and triangles of 800 to 5,000 steps in any place, and discs that touch the last one.
inline plane::Region random_region(plane::Random& random, bool straight) {
  plane::Region set = plane::Region::uniform(0);
  plane::GridPoint at{};
  std::int64_t radius = 0;
  const std::int64_t parts = random.pick(3, 6);
  for (std::int64_t k = 0; k < parts; ++k) {
    const bool add = k < 2 || random.pick(0, 2) > 0;
    const std::int64_t kind = straight ? random.pick(0, 1) : random.pick(0, 4);
    const plane::GridPoint p = random.point(20000);
    if (kind == 0) {
      set = combined(set, square(p, random.pick(800, 5000), random.pick(800, 5000)), add);
    } else if (kind == 1) {
      const std::int64_t x = random.pick(1000, 5000), y = random.pick(1000, 5000);
      set = combined(set, triangle(p, {p.x + x, p.y + random.pick(-300, 300)}, {p.x + random.pick(-300, 300), p.y + y}),
                     add);
    } else if (kind == 2 || radius == 0) {
      at = p;
      radius = random.pick(2000, 5000);
      set = combined(set, plane::region_of_disc(at.x, at.y, radius), add);
    } else {
      // Along (3, 4) or (4, 3): beside the last one, or as a hole that touches it from inside.
      const bool outside = kind == 3;
      const std::int64_t fifth = outside ? (radius + 1500) / 5 : radius / 10, apart = 5 * fifth;
      const plane::GridPoint next = random.pick(0, 1) == 1 ? plane::GridPoint{at.x + 3 * fifth, at.y + 4 * fifth}
                                                           : plane::GridPoint{at.x + 4 * fifth, at.y - 3 * fifth};
      const std::int64_t other = outside ? apart - radius : radius - apart;
      if (outside && other < 800) continue;
      set = combined(set, plane::region_of_disc(next.x, next.y, other), outside);
    }
  }
  return set;
}

/// Squares, halves of squares and discs in the squares of a lattice.
inline plane::Region random_lattice_region(plane::Random& random, bool straight) {
  constexpr std::int64_t kSide = 200;  // arcs rise more than a step over their chords
  std::vector<plane::Region> parts;
  for (std::int64_t x = 0; x < 4 * kSide; x += kSide)
    for (std::int64_t y = 0; y < 4 * kSide; y += kSide) {
      const std::int64_t kind = random.pick(straight ? 1 : 0, 4);
      if (kind == 0) parts.push_back(plane::region_of_disc(x + kSide / 2, y + kSide / 2, kSide / 2));
      if (kind == 1) parts.push_back(triangle({x, y}, {x + kSide, y}, {x, y + kSide}));
      if (kind == 2) parts.push_back(square({x, y}, kSide, kSide));
    }
  if (parts.empty()) parts.push_back(square({0, 0}, kSide, kSide));
  std::vector<const plane::Region*> all;
  for (const plane::Region& r : parts) all.push_back(&r);
  return plane::regularize(plane::unite(all));
}

/// The area in which the sets differ, as a share of what moving the boundary by two steps may change.
inline double off_by(const plane::Region& a, const plane::Region& b) {
  const plane::Region differs =
      plane::overlay(std::array<const plane::CellComplex*, 2>{&a, &b},
                     [](std::span<const plane::Mark> m) { return plane::Mark(m[0] != m[1]); });
  double area = 0, boundary = 0;
  const std::vector<plane::Twofold> areas = plane::CellMeasures(differs).face_areas();
  for (std::size_t f = 0; f < areas.size(); ++f)
    if (differs.faces[f].mark != 0) area += areas[f].value();
  const plane::CellMeasures measures(a);
  for (plane::Index e = 0; e < a.edges.size(); ++e) boundary += measures.length(e).value();
  return area / (2 * boundary);
}

struct DrawingFormat {
  const char* name;
  bool arcs;        // it has any
  bool exact_arcs;  // by their centres, so that they come back as they were
  std::string (*write)(const plane::Region&);
  plane::ShapePtr (*read)(std::string_view, const std::string&, const FileChoice&, ReadContext&);
};

inline const std::vector<DrawingFormat>& drawing_formats() {
  using formula::Unit;
  static const std::vector<DrawingFormat> all{
      {"SVG", true, true, [](const plane::Region& r) { return shape_svg(r, 1, "s", Unit::kMillimetre).text; },
       read_svg},
      {"DXF R12", true, true,
       [](const plane::Region& r) {
         const NamedRegion named{"s", &r};
         return shapes_dxf({&named, 1}, 1, Unit::kMillimetre).text;
       },
       read_dxf},
      {"DXF 2000", true, true,
       [](const plane::Region& r) {
         const NamedRegion named{"s", &r};
         return shapes_dxf({&named, 1}, 1, Unit::kMillimetre, DxfVersion::k2000).text;
       },
       read_dxf},
      {"WKT", true, false, [](const plane::Region& r) { return region_wkt(r, 1).text; }, read_wkt},
      {"GeoJSON", false, false,
       [](const plane::Region& r) {
         const NamedRegion named{"s", &r};
         return shapes_geojson({&named, 1}, 1).text;
       },
       read_geojson}};
  return all;
}

/// Rounds [first, last) of a thousand: a region each, in turn on a lattice or not, of segments alone or not.
inline void expect_read_back(int first, int last) {
  for (int round = first; round < last; ++round) {
    plane::Random random(std::uint64_t(round) + 1);
    const bool straight = round % 4 < 2, lattice = round % 2 == 0;
    const plane::Region set = lattice ? random_lattice_region(random, straight) : random_region(random, straight);
    for (const DrawingFormat& format : drawing_formats()) {
      if (!straight && !format.arcs) continue;
      ReadContext context;
      context.grid = Grid(exact::Real(1));
      context.unit = formula::Unit::kMillimetre;
      const std::string text = format.write(set);
      plane::Region back = plane::Region::uniform(0);
      ASSERT_NO_THROW(back = plane::build(*format.read(text, "f", {}, context)).region)
          << format.name << ' ' << round << '\n'
          << text;
      if (straight ? lattice : lattice && format.exact_arcs) {
        ASSERT_TRUE(plane::same_set(back, set)) << format.name << ' ' << round << '\n' << text;
      } else {
        ASSERT_LT(off_by(set, back), 1) << format.name << ' ' << round << '\n' << text;
      }
    }
  }
}

}  // namespace findspace::io
