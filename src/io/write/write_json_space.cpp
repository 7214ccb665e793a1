// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "io/write/write_json_space.h"

#include <fmt/format.h>

#include <array>

#include "io/mesh/space_surface.h"
#include "io/write/json_text.h"

namespace findspace::io {
namespace {

using exact::Real;
using space::Place3;
using space::PlaceBox;

std::string triple(const Place3& p) {
  return fmt::format("[{}, {}, {}]", json_number(p[0]), json_number(p[1]), json_number(p[2]));
}
std::string box(const std::optional<PlaceBox>& b) {
  return b ? fmt::format("[{}, {}]", triple(b->low), triple(b->high)) : "null";
}

std::string solid_component_text(const space::SpaceComponent& c) {
  return fmt::format(
      R"({{"dimension": {}, "volume": {}, "dangling_area": {}, "dangling_length": {}, "holes": {}, "sample": {}, "bbox": {}}})",
      c.dimension, number(c.volume), json_number(c.dangling_area), json_number(c.dangling_length), c.holes,
      triple(c.sample), box(c.bbox));
}

std::string box_text(const space::IntervalBox& b, const Real& step) {
  std::array<std::string, 4> rows;
  for (const space::Interval& i : b) {
    const char* separator = rows[0].empty() ? "" : ", ";
    put(rows[0], "{}{}", separator, i.from ? json_number((*i.from * step).to_double()) : "null");
    put(rows[1], "{}{}", separator, i.to ? json_number((*i.to * step).to_double()) : "null");
    put(rows[2], "{}{}", separator, truth(i.from_in));
    put(rows[3], "{}{}", separator, truth(i.to_in));
  }
  return fmt::format(R"({{"from": [{}], "to": [{}], "from_in": [{}], "to_in": [{}]}})", rows[0], rows[1], rows[2],
                     rows[3]);
}

void put_summary(std::string& out, const space::SpaceSummary& s, std::string_view unit) {
  const std::string measures = fmt::format(
      "  \"volume\": {}, \"dangling_area\": {}, \"dangling_length\": {},\n  \"crack_area\": {}, \"crack_length\": {}",
      number(s.volume), json_number(s.dangling_area), json_number(s.dangling_length), json_number(s.crack_area),
      json_number(s.crack_length));
  put_set(
      out, 3, s, unit, measures, [](const Place3& p) { return triple(p); },
      [](const std::optional<PlaceBox>& b) { return box(b); },
      [](const space::SpaceComponent& c) { return solid_component_text(c); });
}

}  // namespace

std::string space_json(const space::BoxComplex& set, const space::SpaceSummary& s, const Real& step,
                       std::string_view unit, const distance::OptimalValue* best) {
  std::string out = "{\n";
  put_summary(out, s, unit);
  if (best != nullptr) put_optimum(out, *best);
  put(out, "  \"boxes\": {}\n",
      list(
          set.boxes(), [&](const space::IntervalBox& b) { return box_text(b, step); }, true));
  return out + "}\n";
}

std::string space_json(const space::ConvexSet& set, const space::SpaceSummary& s, const Real& step,
                       std::string_view unit, const distance::OptimalValue* best) {
  std::string out = "{\n";
  put_summary(out, s, unit);
  if (best != nullptr) put_optimum(out, *best);
  const Surface surface = convex_surface(set, step);
  const auto corners = [](const std::vector<int>& face) { return fmt::format("[{}]", fmt::join(face, ", ")); };
  put(out, "  \"polytope\": {{\"inside\": {}, \"frontier\": {}, \"outside\": {},\n    \"vertices\": {},\n",
      truth(set.inside), truth(set.frontier), truth(set.outside), list(surface.vertices, triple, true));
  if (set.radius.sign() > 0) put(out, "    \"radius\": {},\n", number((set.radius * step).to_double()));
  put(out, "    \"facets\": {}}}\n", list(surface.faces, corners));
  return out + "}\n";
}

}  // namespace findspace::io
