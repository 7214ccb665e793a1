// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/body/position_covers.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "exact/margins/rounding.h"
#include "exact/margins/space.h"
#include "plane/base/lazy.h"
#include "space/body/body_boxes.h"
#include "space/body/observe_body.h"
#include "space/phi/contact_surface.h"

namespace findspace::space {

using exact::Real;

namespace {

Extent extent_of(const BodyPart& part) {
  std::vector<Vector> points;
  for (const Point& v : part.vertices()) points.push_back(exact::approx(v));
  return space::extent_of(points);
}

/// Points, also as numbers.
struct RoundedPoints {
  std::vector<RealVector> exact;
  std::vector<Vector> near;

  explicit RoundedPoints(std::vector<RealVector> points) : exact(std::move(points)) {
    for (const RealVector& v : exact) near.push_back(space::rounded(v));
  }
};

/// Of those that numbers do not tell to be lower.
Real highest(const RoundedPoints& points, const RealVector& n) {
  const Vector near_n = space::rounded(n);
  double top = -exact::kInfinity, size = 0;
  for (const Vector& v : points.near) {
    top = std::max(top, dot(near_n, v));
    size = std::max(size, size_of(v));
  }
  const double lowest = top - margin::kRoundings32 * size_of(near_n) * size;
  std::optional<Real> best;
  for (std::size_t k = 0; k < points.exact.size(); ++k) {
    if (dot(near_n, points.near[k]) < lowest) continue;
    const Real value = dot(n, points.exact[k]);
    if (!best || *best < value) best = value;
  }
  return *best;
}

/// Whether the face of the points in direction n has an edge, or may have one: else n belongs to no facet of a sum.
bool selects_edge(const Vector& n, std::span<const Vector> points) {
  double top = -exact::kInfinity, size = 0;
  for (const Vector& v : points) {
    top = std::max(top, dot(n, v));
    size = std::max(size, size_of(v));
  }
  return std::count_if(points.begin(), points.end(),
                       [&](const Vector& v) { return dot(n, v) >= top - margin::kAsHigh * size; }) > 1;
}

/// Whether, by doubles, neither normal to the two edges selects an edge of both: so of most pairs.
bool selects_no_edges(const Vector& d, const Vector& e, std::span<const Vector> a, std::span<const Vector> b) {
  const Vector n{d.y * e.z - d.z * e.y, d.z * e.x - d.x * e.z, d.x * e.y - d.y * e.x};
  const double size = length(n);
  // Else the direction of n is not known well enough for the tolerance that selects_edge() leaves.
  if (!(size > margin::kKnownDirection * length(d) * length(e))) return false;
  const Vector unit = scaled(1 / size, n), back = scaled(-1 / size, n);
  return !(selects_edge(unit, a) && selects_edge(unit, b)) && !(selects_edge(back, a) && selects_edge(back, b));
}

/// {p : p + c in the cell}.
std::vector<HalfSpace> moved_planes(const OutsideCell& cell, const Point& c) {
  std::vector<HalfSpace> planes;
  for (const HalfSpace& h : cell.planes) planes.emplace_back(h.normal, h.offset + dot(h.normal, real(c)));
  return planes;
}

/// Of the core; of a polygon or segment from corner to corner.
std::vector<RealVector> edge_directions(const BodyPart& part) {
  std::vector<RealVector> out;
  for (std::size_t k = 0; k < part.flat.size(); ++k)
    out.push_back(real(part.flat[(k + 1) % part.flat.size()] - part.flat[k]));
  if (!part.core) return out;
  for (int h = 0; h < static_cast<int>(part.core->half_edges().size()); ++h) {
    if (part.core->half_edges()[static_cast<std::size_t>(h)].twin > h) out.push_back(real(part.core->edge(h)));
  }
  return out;
}

}  // namespace

Extent difference_extent(const BodyPart& a, const BodyPart& b) { return difference(extent_of(a), extent_of(b)); }

std::vector<HalfSpace> difference_planes(const BodyPart& a, const BodyPart& b) {
  std::vector<HalfSpace> planes;
  if (!a.flat.empty() || !b.flat.empty()) {
    std::vector<Point> points;
    for (const Point& v : a.vertices()) {
      for (const Point& w : b.vertices()) points.push_back(v - w);
    }
    return part_of(points, Real(1)).planes();
  }
  if (a.core && b.core) {
    const ContactSurface surface(*a.core, *b.core);
    for (int f = 0; f < surface.facet_count(); ++f) planes.emplace_back(surface.plane(f));
  } else if (a.core) {
    for (const Plane& p : a.core->planes())
      planes.emplace_back(Plane{p.normal, p.offset + exact::dot(p.normal, b.center)});
  } else if (b.core) {
    // c - s: the reflected polytope, moved by c.
    for (const Plane& p : b.core->planes())
      planes.emplace_back(Plane{-p.normal, p.offset + exact::dot(p.normal, a.center)});
  }
  return planes;
}

std::vector<HalfSpace> difference_planes(const OutsideCell& a, const BodyPart& b) {
  if (b.point()) return moved_planes(a, b.center);
  std::vector<HalfSpace> planes;
  std::vector<RealVector> reflected;
  for (const Point& v : b.vertices()) reflected.push_back(real(-v));
  const RoundedPoints of_a(a.vertices), of_b(std::move(reflected));
  const auto add = [&](const RealVector& n) { planes.emplace_back(n, -(highest(of_a, n) + highest(of_b, n))); };
  for (const HalfSpace& h : a.planes) add(h.normal);
  for (const HalfSpace& p : b.planes()) add(negated(p.normal));
  const std::vector<Vector>&points_a = of_a.near, &points_b = of_b.near;
  const std::vector<RealVector> edges = edge_directions(b);
  std::vector<Vector> near_edges;
  for (const RealVector& e : edges) near_edges.push_back(space::rounded(e));
  for (const RealVector& d : edge_directions(a)) {
    const Vector near_d = space::rounded(d);
    for (std::size_t k = 0; k < edges.size(); ++k) {
      if (selects_no_edges(near_d, near_edges[k], points_a, points_b)) continue;
      const RealVector& e = edges[k];
      const RealVector n = cross(d, e);
      if (is_zero(n)) continue;
      for (const RealVector& m : {n, negated(n)}) {
        const Vector near = space::rounded(m), unit = scaled(1 / length(near), near);
        const bool listed = std::any_of(planes.begin(), planes.end(), [&](const HalfSpace& g) {
          return dot(g.unit, unit) > 1 - margin::kSameDirection && is_zero(cross(g.normal, m));
        });
        if (!listed && selects_edge(unit, points_a) && selects_edge(unit, points_b)) add(m);
      }
    }
  }
  return planes;
}

OpenUnion overlap_cover(const Body& b, const Body& a) {
  OpenUnion cover;
  for (const BodyPart& t : a.parts) {
    for (const BodyPart& s : b.parts) {
      cover.add(difference_extent(t, s), [&t, &s] {
        return t.point() && s.point() ? walls_about(t.center - s.center) : difference_planes(t, s);
      });
    }
  }
  observe_union("positions at which interiors meet", cover);
  return cover;
}

namespace {

/// A convex set by doubles: corners, directions of edges, unit normals, the size of its coordinates.
struct RoundedHull {
  std::vector<Vector> points, edges, normals;
  double size = 0;
};

RoundedHull rounded_hull(const OutsideCell& cell) {
  RoundedHull out;
  for (const RealVector& v : cell.vertices) out.points.push_back(space::rounded(v));
  for (const Vector& v : out.points) out.size = std::max(out.size, size_of(v));
  for (std::size_t v = 0; v < out.points.size(); ++v) {
    for (std::size_t w = v + 1; w < out.points.size(); ++w) {
      if (share_edge(cell, v, w)) out.edges.push_back(out.points[w] - out.points[v]);
    }
  }
  for (const HalfSpace& h : cell.planes) out.normals.push_back(h.unit);
  return out;
}

/// Of -S.
RoundedHull reflected_hull(const BodyPart& part) {
  RoundedHull out;
  for (const Point& v : part.vertices()) out.points.push_back(exact::approx(-v));
  for (const Vector& v : out.points) out.size = std::max(out.size, size_of(v));
  if (part.point()) return out;
  for (const RealVector& e : edge_directions(part)) out.edges.push_back(space::rounded(e));
  for (const HalfSpace& h : part.planes()) out.normals.push_back(scaled(-1, h.unit));
  return out;
}

/// How far the hull reaches along the unit vector, and whether more than one of its points may do so, where the vector
/// is off by that share.
struct Reach {
  double height = -exact::kInfinity;
  bool edge = false;
};
Reach reach_along(const Vector& unit, const RoundedHull& hull, double off) {
  Reach out;
  double next = -exact::kInfinity;
  for (const Vector& v : hull.points) {
    const double at = dot(unit, v);
    next = std::max(next, std::min(at, out.height));
    out.height = std::max(out.height, at);
  }
  out.edge = next >= out.height - (margin::kAsHigh + 4 * off) * hull.size;
  return out;
}

/// The planes of difference_planes(), those along pairs of edges where a face of both may have these. Nothing where
/// edges are so nearly parallel that doubles do not know their common normal.
std::optional<OpenUnion::RoundedPlanes> rounded_sum(const RoundedHull& a, const RoundedHull& b) {
  OpenUnion::RoundedPlanes out;
  const auto add = [&](const Vector& unit, double height, double share) {
    out.push_back({unit, -height, share, share * (a.size + b.size)});
  };
  for (const RoundedHull* hull : {&a, &b}) {
    for (const Vector& n : hull->normals)
      add(n, reach_along(n, a, 0).height + reach_along(n, b, 0).height, margin::kRoundings32);
  }
  for (const Vector& d : a.edges) {
    for (const Vector& e : b.edges) {
      const Vector n = cross(d, e);
      // The corners that the edges join are known to an ulp of their size.
      const double size = length(n), blur = a.size * length(e) + b.size * length(d);
      const double off = margin::kRoundings32 * (1 + blur / size);
      if (!(off < margin::kUnknownNormal)) return std::nullopt;
      for (const Vector& unit : {scaled(1 / size, n), scaled(-1 / size, n)}) {
        const Reach of_a = reach_along(unit, a, off);
        if (!of_a.edge) continue;
        const Reach of_b = reach_along(unit, b, off);
        if (of_b.edge) add(unit, of_a.height + of_b.height, off);
      }
    }
  }
  return out;
}

/// Of the cells of a cover and of the parts that move, each made when first needed.
struct RoundedHulls {
  std::span<const OutsideCell> cells;
  const Body& b;
  std::vector<plane::Lazy<RoundedHull>> of_cells{cells.size()}, of_parts{b.parts.size()};

  std::optional<OpenUnion::RoundedPlanes> sum(std::uint32_t cell, std::uint32_t part) const {
    return rounded_sum(of_cells[cell].of([&] { return rounded_hull(cells[cell]); }),
                       of_parts[part].of([&] { return reflected_hull(b.parts[part]); }));
  }
};

}  // namespace

OpenUnion outside_cover(const Body& b, std::span<const OutsideCell> outside_a) {
  OpenUnion cover;
  const auto hulls = std::shared_ptr<const RoundedHulls>(new RoundedHulls{outside_a, b});
  cover.keep(hulls);
  for (const OutsideCell& cell : outside_a) {
    if (!cell.bounded()) {
      const HalfSpace& h = cell.planes[0];
      cover.add(everywhere(), OpenUnion::Planes{HalfSpace(h.normal, h.offset - support(b, negated(h.normal)))});
      continue;
    }
    const Extent extent = extent_of(cell);
    const auto k = static_cast<std::uint32_t>(&cell - outside_a.data());
    for (std::uint32_t n = 0; n < b.parts.size(); ++n) {
      const BodyPart& s = b.parts[n];
      cover.add(
          difference(extent, extent_of(s)), [&cell, &s] { return difference_planes(cell, s); },
          [of = hulls.get(), k, n] { return of->sum(k, n); });
    }
  }
  observe_union("positions at which one body is not inside the other", cover);
  return cover;
}

}  // namespace findspace::space
