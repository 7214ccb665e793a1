// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/outside_cells.h"

#include <algorithm>

#include "space/convex_region.h"

namespace findspace::space {

using exact::Real;

namespace {

OutsideCell cell_of(const ConvexRegion& region) {
  OutsideCell cell;
  for (const int f : region.facets()) cell.planes.push_back(region.planes()[f]);
  for (const ConvexRegion::Vertex& v : region.vertices()) cell.vertices.push_back(v.at);
  for (const auto& [v, w] : region.edges()) {
    cell.directions.push_back(minus(region.vertices()[w].at, region.vertices()[v].at));
  }
  return cell;
}

bool overlaps(const ConvexRegion& region, const Polytope& part) {
  return std::all_of(part.planes().begin(), part.planes().end(),
                     [&](const Plane& p) { return region.sides(HalfSpace(p)).inside; });
}

/// Adds the closures of the pieces of region \ part that have interior; they do not overlap.
void subtract(ConvexRegion region, const Polytope& part, std::vector<ConvexRegion>& out) {
  if (!overlaps(region, part)) {
    out.push_back(std::move(region));
    return;
  }
  for (const Plane& p : part.planes()) {
    const HalfSpace inside(p);
    if (!region.sides(inside).outside) continue;
    ConvexRegion beyond = region;
    beyond.cut(inside.opposite());
    out.push_back(std::move(beyond));
    region.cut(inside);
    if (region.empty()) return;
  }
}

}  // namespace

std::vector<OutsideCell> outside_cells(const Body& body) {
  std::vector<OutsideCell> cells;
  if (body.parts.size() == 1) {
    for (const HalfSpace& h : body.parts[0].planes()) cells.push_back({{h.opposite()}, {}, {}});
    return cells;
  }
  const Bounds3 box = bounds(body);
  for (int k = 0; k < 3; ++k) {
    RealVector n;
    n[k] = Real(1);
    cells.push_back({{HalfSpace(n, -box.low[k])}, {}, {}});
    n[k] = Real(-1);
    cells.push_back({{HalfSpace(n, box.high[k])}, {}, {}});
  }
  std::vector<ConvexRegion> regions{ConvexRegion(box.low, box.high)};
  for (const BodyPart& part : body.parts) {
    std::vector<ConvexRegion> next;
    for (ConvexRegion& r : regions) subtract(std::move(r), *part.core, next);
    regions = std::move(next);
  }
  for (const ConvexRegion& r : regions) cells.push_back(cell_of(r));
  return cells;
}

}  // namespace findspace::space
