// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/body/outside_cells.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <numeric>
#include <span>

#include "space/body/body_boxes.h"
#include "space/polytope/convex_region.h"

namespace findspace::space {

using exact::Real;

namespace {

/// The cell with the planes of its facets only, as it lies in the body.
OutsideCell cell_of(const ConvexRegion& region, const PlacedSurroundings& place) {
  OutsideCell cell;
  std::vector<int> number(region.planes().size(), -1);
  const std::vector<int> facets = region.facets();
  cell.planes.reserve(facets.size());
  cell.vertices.reserve(region.vertices().size());
  cell.tight.reserve(region.vertices().size());
  for (const int f : facets) {
    number[static_cast<std::size_t>(f)] = static_cast<int>(cell.planes.size());
    cell.planes.push_back(place.at(region.planes()[static_cast<std::size_t>(f)]));
  }
  for (const ConvexRegion::Vertex& v : region.vertices()) {
    cell.vertices.push_back(place.at(v.at));
    std::vector<int>& tight = cell.tight.emplace_back();
    for (const int k : v.tight) {
      if (number[static_cast<std::size_t>(k)] >= 0) tight.push_back(number[static_cast<std::size_t>(k)]);
    }
  }
  return cell;
}

/// At most two planes, the opposite sides of one, hold three corners of a set without interior.
bool has_interior(const OutsideCell& cell) { return cell.planes.size() > 3; }

Extent extent_of(const ConvexRegion& region) {
  std::vector<Vector> points;
  for (const ConvexRegion::Vertex& v : region.vertices()) points.push_back(v.near);
  return space::extent_of(points);
}

/// A convex set that is cut out, with a box around it.
struct Convex {
  Extent extent;
  std::vector<HalfSpace> planes;
};

/// Of sets whose boxes meet.
bool overlaps(const ConvexRegion& region, const Convex& set) {
  return std::all_of(set.planes.begin(), set.planes.end(), [&](const HalfSpace& h) { return region.sides(h).inside; });
}

/// Adds the closures of the pieces of region \ set that have interior; they do not overlap. What is left of the region
/// lies in the set.
void subtract(ConvexRegion& region, const Convex& set, std::vector<ConvexRegion>& out) {
  for (const HalfSpace& inside : set.planes) {
    if (!region.sides(inside).outside) continue;
    ConvexRegion beyond = region;
    beyond.cut(inside.opposite());
    out.push_back(std::move(beyond));
    region.cut(inside);
    if (!region.sides(inside).inside) return;  // what is left has no interior, and would not leave any
  }
}

/// A mesh as the box about it less cells.
struct Carved {
  Convex box;
  std::vector<Convex> cells;
};

Bounds3 bounds(const PlacedSurroundings& place) {
  const auto& corners = place.of->surface.vertices;
  Bounds3 box{real(place.at(corners[0])), real(place.at(corners[0]))};
  for (const Point& corner : corners) {
    const RealVector at = real(place.at(corner));
    for (std::size_t k = 0; k < 3; ++k) {
      box.low[k] = std::min(box.low[k], at[k]);
      box.high[k] = std::max(box.high[k], at[k]);
    }
  }
  return box;
}

Carved carved(const PlacedSurroundings& place) {
  const Bounds3 around = bounds(place);
  const ConvexRegion box(around.low, around.high);
  Carved out{{extent_of(box), {box.planes().begin(), box.planes().end()}}, {}};
  for (const ConvexRegion& region : place.of->cells) {
    const OutsideCell cell = cell_of(region, place);
    if (has_interior(cell)) out.cells.push_back({space::extent_of(cell), cell.planes});
  }
  return out;
}

void subtract(ConvexRegion region, const Carved& mesh, std::vector<ConvexRegion>& out) {
  const auto overlap = [&](const Convex& set) { return extent_of(region).meets(set.extent) && overlaps(region, set); };
  if (!overlap(mesh.box)) {
    out.push_back(std::move(region));
    return;
  }
  subtract(region, mesh.box, out);
  for (const Convex& cell : mesh.cells) {
    if (!overlap(cell)) continue;
    ConvexRegion kept = region;
    for (const HalfSpace& h : cell.planes) kept.cut(h);
    if (kept.dimension() == 3) out.push_back(std::move(kept));
  }
}

/// A region, and the sets that are not yet taken away from it.
struct Piece {
  ConvexRegion region;
  std::shared_ptr<const std::vector<std::size_t>> sets;
  std::size_t from;
};

/// Takes away the next set that overlaps the piece, which then is what to do with the pieces left; false where none
/// does.
bool subtract_next(Piece& piece, std::span<const Convex> sets, std::vector<ConvexRegion>& left) {
  const Extent extent = extent_of(piece.region);
  auto near = std::make_shared<std::vector<std::size_t>>();
  std::copy_if(piece.sets->begin() + static_cast<std::ptrdiff_t>(piece.from), piece.sets->end(),
               std::back_inserter(*near), [&](std::size_t k) { return extent.meets(sets[k].extent); });
  const auto next =
      std::find_if(near->begin(), near->end(), [&](std::size_t k) { return overlaps(piece.region, sets[k]); });
  if (next == near->end()) return false;
  piece.from = static_cast<std::size_t>(next - near->begin()) + 1;
  piece.sets = near;
  left.clear();
  subtract(piece.region, sets[*next], left);
  return true;
}

/// take(region) for all that the sets leave of the regions, in their order. A piece is asked only of the sets whose
/// boxes it meets.
template <class Take>
void take_away(std::vector<ConvexRegion> regions, std::span<const Convex> sets, Take&& take) {
  auto all = std::make_shared<std::vector<std::size_t>>(sets.size());
  std::iota(all->begin(), all->end(), std::size_t{0});
  std::vector<Piece> open;
  std::for_each(regions.rbegin(), regions.rend(), [&](ConvexRegion& r) { open.push_back({std::move(r), all, 0}); });
  while (!open.empty()) {
    Piece piece = std::move(open.back());
    open.pop_back();
    if (!subtract_next(piece, sets, regions)) {
      take(std::move(piece.region));
      continue;
    }
    std::for_each(regions.rbegin(), regions.rend(), [&](ConvexRegion& r) {
      open.push_back({std::move(r), piece.sets, piece.from});
    });
  }
}

Convex convex_of(const BodyPart& part) {
  std::vector<Vector> points;
  for (const Point& v : part.vertices()) points.push_back(exact::approx(v));
  return {space::extent_of(points), part.planes()};
}

HalfSpace moved_out(const HalfSpace& h, const Real& by) {
  return HalfSpace(h.normal, h.offset - by * (abs(h.normal[0]) + abs(h.normal[1]) + abs(h.normal[2])));
}

/// With all points at most `by` away, and no more than that beyond the box about it.
Convex grown(const BodyPart& part, const Real& by) {
  Bounds3 about = bounds(part);
  for (std::size_t k = 0; k < 3; ++k) {
    about.low[k] -= by;
    about.high[k] += by;
  }
  const ConvexRegion box(about.low, about.high);
  Convex out{extent_of(box), {box.planes().begin(), box.planes().end()}};
  for (const HalfSpace& h : part.planes()) out.planes.push_back(moved_out(h, by));
  return out;
}

/// Whether along one of its facets no point is farther from it than about `width`.
bool thin(const ConvexRegion& region, const Real& width) {
  const std::vector<int> facets = region.facets();
  return std::any_of(facets.begin(), facets.end(), [&](int f) {
    return !region.sides(moved_out(region.planes()[static_cast<std::size_t>(f)], -width)).inside;
  });
}

/// Twice the farthest move of a corner: parts that touched before these were rounded may be as far apart.
Real width_of_cracks(const Body& body) {
  const double most = 2 * body.moved * static_cast<double>(body.scale);
  return Real(std::max<std::int64_t>(1, static_cast<std::int64_t>(std::ceil(most))));
}

/// Of what is thin only that is left which is farther from parts than cracks are wide. Meshes, whose parts are skipped,
/// have no cracks.
void add_cells(std::vector<ConvexRegion> regions, const Body& body, const std::vector<bool>& skipped,
               std::vector<OutsideCell>& cells) {
  const auto sets_of = [&](const auto& make) {
    std::vector<Convex> sets;
    for (std::size_t k = 0; k < body.parts.size(); ++k) {
      if (!skipped[k]) sets.push_back(make(body.parts[k]));
    }
    return sets;
  };
  const auto add = [&](const ConvexRegion& r) { cells.push_back(cell_of(r, {})); };
  const std::vector<Convex> parts = sets_of(convex_of);
  if (body.rounded == 0) {
    take_away(std::move(regions), parts, add);
    return;
  }
  const Real width = width_of_cracks(body);
  std::vector<ConvexRegion> cracks;
  take_away(std::move(regions), parts, [&](ConvexRegion r) {
    if (thin(r, width + width))
      cracks.push_back(std::move(r));
    else
      add(r);
  });
  if (cracks.empty()) return;
  take_away(std::move(cracks), sets_of([&](const BodyPart& part) { return grown(part, width); }), add);
}

void add_bounded(const Body& body, const Bounds3& box, std::vector<OutsideCell>& cells) {
  std::vector<ConvexRegion> regions{ConvexRegion(box.low, box.high)}, next;
  if (regions[0].dimension() < 3) return;  // of points
  std::vector<bool> done(body.parts.size());
  for (const PlacedSurroundings& place : body.around) {
    next.clear();
    const Carved mesh = carved(place);
    for (ConvexRegion& r : regions) subtract(std::move(r), mesh, next);
    regions.swap(next);
    std::fill_n(done.begin() + static_cast<std::ptrdiff_t>(place.first), place.count, true);
  }
  for (std::size_t k = 0; k < body.parts.size(); ++k)
    done[k] = done[k] || body.parts[k].point();  // a point leaves the same closure
  add_cells(std::move(regions), body, done, cells);
}

}  // namespace

std::vector<OutsideCell> outside_cells(const Body& body) {
  std::vector<OutsideCell> cells;
  if (body.parts.size() == 1) {
    const BodyPart& part = body.parts[0];
    for (const HalfSpace& h : part.point() ? walls_about(part.center) : part.planes())
      cells.push_back({{h.opposite()}, {}, {}});
    return cells;
  }
  const bool one_mesh = body.around.size() == 1 && body.around[0].count == body.parts.size();
  Bounds3 box = bounds(body);
  for (const PlacedSurroundings& place : body.around) {  // the corners of a part may have been rounded inward
    const Bounds3 mesh = bounds(place);
    for (std::size_t k = 0; k < 3; ++k) {
      box.low[k] = std::min(box.low[k], mesh.low[k]);
      box.high[k] = std::max(box.high[k], mesh.high[k]);
    }
  }
  for (int k = 0; k < 3; ++k) {
    RealVector n;
    n[k] = Real(1);
    cells.push_back({{HalfSpace(n, -box.low[k])}, {}, {}});
    n[k] = Real(-1);
    cells.push_back({{HalfSpace(n, box.high[k])}, {}, {}});
  }
  if (one_mesh) {
    for (const ConvexRegion& r : body.around[0].of->cells) {
      OutsideCell cell = cell_of(r, body.around[0]);
      if (has_interior(cell)) cells.push_back(std::move(cell));
    }
    return cells;
  }
  add_bounded(body, box, cells);
  return cells;
}

Extent extent_of(const OutsideCell& bounded) {
  std::vector<Vector> points;
  for (const RealVector& v : bounded.vertices) points.push_back(space::rounded(v));
  return extent_of(points);
}

bool share_edge(const OutsideCell& cell, std::size_t v, std::size_t w) {
  std::vector<int> both;
  std::set_intersection(cell.tight[v].begin(), cell.tight[v].end(), cell.tight[w].begin(), cell.tight[w].end(),
                        std::back_inserter(both));
  return both.size() >= 2;
}

std::vector<RealVector> edge_directions(const OutsideCell& cell) {
  std::vector<RealVector> out;
  const std::size_t n = cell.vertices.size();
  for (std::size_t v = 0; v < n; ++v) {
    for (std::size_t w = v + 1; w < n; ++w) {
      if (share_edge(cell, v, w)) out.push_back(minus(cell.vertices[w], cell.vertices[v]));
    }
  }
  return out;
}

}  // namespace findspace::space
