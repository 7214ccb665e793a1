// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Our side: from the integer vertices to the marked complex, nothing prepared beforehand; where all pairs of parts are
// summed, each part is checked, made a region and prepared once, within the measured time.
#include <array>
#include <deque>
#include <functional>

#include "contenders.h"
#include "plane/complex/overlay.h"
#include "plane/complex/primitives.h"
#include "plane/contour/contour.h"
#include "plane/offset/level.h"
#include "plane/sum/minkowski.h"
#include "plane/walk/unite.h"

namespace bench {
namespace {

using namespace findspace::plane;

std::vector<Contour> rings(const Polygon& polygon) {
  std::vector<Contour> rings(1);
  rings[0].reserve(polygon.size());
  for (const Point& p : polygon) rings[0].push_back({.start = {p.x, p.y}});
  return make_rings(std::move(rings), 1).contours;
}

Region region(const Polygon& polygon) { return region_of_rings(rings(polygon)); }

std::size_t sum(const Polygon& a, const Polygon& b) { return contact_map(region(a), region(b)).vertices.size(); }

std::function<std::size_t()> sum_alone(const Polygon& a, const Polygon& b) {
  return [p = region(a), q = region(b)] { return contact_map(p, q).vertices.size(); };
}

std::size_t pairs(const std::vector<Polygon>& parts, std::size_t step) {
  std::vector<Region> regions;
  regions.reserve(parts.size());
  for (const Polygon& p : parts) regions.push_back(region(p));
  std::deque<SumOperand> operands;
  for (const Region& r : regions) operands.emplace_back(r);
  std::size_t total = 0, n = parts.size();
  for (std::size_t k = 0; k < n * n; k += step) total += contact_map(operands[k / n], operands[k % n]).vertices.size();
  return total;
}

std::size_t offset(const Polygon& a, double r) {
  SignMap base = remark(region(a), [](Mark m) { return Mark(m > 0 ? -1 : 1); });
  for (Vertex& v : base.vertices) v.mark = 0;
  for (Edge& e : base.edges) e.mark = 0;
  return level_map(base, findspace::exact::Real::from_double(r)).vertices.size();
}

std::size_t unite_all(const std::vector<Polygon>& all) {
  std::vector<std::vector<Contour>> sets;
  std::vector<std::span<const Contour>> operands;
  sets.reserve(all.size());
  for (const Polygon& p : all) sets.push_back(rings(p));
  for (const auto& r : sets) operands.emplace_back(r);
  return unite_rings(operands).vertices.size();
}

}  // namespace

std::vector<Contender> ours() {
  return {Contender{.name = "findspace", .sum = sum, .pairs = pairs, .offset = offset, .unite = unite_all},
          Contender{.name = "findspace, of regions", .sum_alone = sum_alone}};
}

}  // namespace bench
