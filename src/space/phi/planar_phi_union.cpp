// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/phi/planar_phi_union.h"

#include <algorithm>
#include <cmath>

#include "space/phi/phi_level.h"
#include "space/polytope/closed_forms.h"

namespace findspace::space {
namespace {

using exact::Real;
using exact::RealPoint;

Real dot(const RealPoint& a, const RealPoint& b) { return a.x * b.x + a.y * b.y; }
RealPoint minus(const RealPoint& a, const RealPoint& b) { return {a.x - b.x, a.y - b.y}; }
RealPoint real(const Point2& p) { return {Real(p.x), Real(p.y)}; }
Vector2 rounded(const RealPoint& p) { return {p.x.to_double(), p.y.to_double()}; }

Level level(const PlanarEdge& edge, const RealPoint& u) {
  const RealPoint n = real(edge.normal);
  return {dot(n, u) + Real(edge.offset), dot(n, n)};
}

/// The highest edges at u.
struct Top {
  Level level;
  std::vector<int> edges;
};

Top top_of(const PlanarPhi& phi, const RealPoint& u) {
  const Vector2 near = rounded(u);
  const double threshold = phi.max_form(near) - 4 * phi.error_bound(near);
  Top top;
  for (int e = 0; e < static_cast<int>(phi.edges().size()); ++e) {
    if (phi.value(e, near) < threshold) continue;
    const Level here = level(phi.edges()[e], u);
    const int order = top.edges.empty() ? 1 : compare_levels(here, top.level);
    if (order > 0) {
      top.level = here;
      top.edges.clear();
    }
    if (order >= 0) top.edges.push_back(e);
  }
  return top;
}

/// From the nearest point of the cores' difference, which does not hold u inside, to u.
struct Gap {
  RealPoint way;
  Real square;
};

Gap gap(const PlanarPair& pair, const RealPoint& u) {
  if (!pair.phi) {
    const RealPoint way = minus(u, real(pair.apex));
    return {way, dot(way, way)};
  }
  std::optional<Gap> best;
  const auto edges = pair.phi->edges();
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (level(edges[i], u).value.sign() < 0) continue;
    const RealPoint start = real(edges[i].start), along = minus(real(edges[(i + 1) % edges.size()].start), start);
    RealPoint way = minus(u, start);
    const Real t = dot(way, along), size = dot(along, along);
    if (t >= size) {
      way = minus(way, along);
    } else if (t.sign() > 0) {
      way = {way.x - t / size * along.x, way.y - t / size * along.y};
    }
    const Real square = dot(way, way);
    if (!best || square < best->square) best = Gap{way, square};
  }
  return *best;
}

Away<Vector2> away(const Gap& g) {
  const double length = root(g.square);
  if (length == 0) return {0, {1, 0}};
  return {length, {g.way.x.to_double() / length, g.way.y.to_double() / length}};
}

PlanarAt outside(const PlanarPair& pair, const RealPoint& u) {
  const Gap g = gap(pair, u);
  return at_distance(g.square, pair.radius, away(g).direction);
}

PlanarAt value_at(const PlanarPair& pair, const RealPoint& u) {
  if (!pair.phi) return outside(pair, u);
  Top top = top_of(*pair.phi, u);
  const int side = top.level.value.sign();
  const double height = side == 0 ? 0 : top.level.value.to_double() / std::sqrt(top.level.square.to_double());
  const Vector2 normal = pair.phi->unit_normal(top.edges[0]);
  return at_cores(
      CoreAt<Vector2>{state_of(side), height, normal, std::move(top.edges)}, pair.radius,
      [&] { return outside(pair, u); }, [&] { return away(gap(pair, u)); });
}

bool is_along_axes(std::span<const PlanarEdge> edges) {
  return edges.size() == 4 && std::all_of(edges.begin(), edges.end(),
                                          [](const PlanarEdge& e) { return e.normal.x == 0 || e.normal.y == 0; });
}

}  // namespace

OtherForms other_forms(const PlanarPair& pair, const RealPoint& u) {
  OtherForms forms;
  if (!pair.phi) {
    forms.square = gap(pair, u).square - pair.radius * pair.radius;
  } else if (pair.radius.sign() > 0 && is_along_axes(pair.edges())) {
    const Point2 &p = pair.edges()[0].start, &q = pair.edges()[2].start;
    const Real half = Real::ratio(1, 2);
    const RealPoint from{u.x - Real(p.x + q.x) * half, u.y - Real(p.y + q.y) * half};
    const Rectangle sides{std::fabs(static_cast<double>(p.x - q.x)) / 2, std::fabs(static_cast<double>(p.y - q.y)) / 2};
    forms.case_free =
        phi_rectangle_disc_case_free(from.x.to_double(), from.y.to_double(), sides, pair.radius.to_double());
  }
  return forms;
}

PlanarPhiUnion::PlanarPhiUnion(std::span<const PlanarPart> a, std::span<const PlanarPart> b)
    : pairs_(all_pairs<PlanarPair>(a, b, [](PlanarPair& pair, const PlanarPart& p, const PlanarPart& q) {
        if (!p.core.is_point() || !q.core.is_point()) {
          pair.phi.emplace(p.core, q.core);
          return;
        }
        const Point2 &v = p.core.vertices()[0], &w = q.core.vertices()[0];
        pair.apex = {v.x - w.x, v.y - w.y};
      })) {}

PlanarPhiUnion::At PlanarPhiUnion::at(const RealPoint& u) const {
  check_position({u.x.to_double(), u.y.to_double()});
  return least_at<Vector2>(pairs_, [&](const PlanarPair& pair) { return value_at(pair, u); });
}

int PlanarPhiUnion::compare_distance(const RealPoint& u, const Real& rho) const {
  check_position({u.x.to_double(), u.y.to_double()});
  return least_sign(pairs_, [&](const PlanarPair& pair) {
    const int side = pair.phi ? top_of(*pair.phi, u).level.value.sign() : 1;
    return compare_to(rho, pair.radius, side, [&] { return gap(pair, u).square; });
  });
}

}  // namespace findspace::space
