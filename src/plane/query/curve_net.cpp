// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/query/curve_net.h"

#include <algorithm>

namespace findspace::plane {

CurveNet::CurveNet(const CellComplex& c, const exact::Real& step) : c_(c), step_(step), measures_(c) {
  find_joints();
  curve_of_edge_.assign(c.edges.size(), kNone);
  curves_.reserve(c.edges.size());  // at most; a list that grows is copied, and both are there
  for (Index e = 0; e < c.edges.size(); ++e) {
    if (!joint_[c.origin(preferred(e))]) add_curve(preferred(e));
  }
  // What is left are whole circles. They start at their leftmost point, where the lower half does.
  for (Index e = 0; e < c.edges.size(); ++e) {
    if (curve_of_edge_[e] != kNone || c.edges[e].half > 0) continue;
    const Index before = c.clockwise(2 * e) / 2;
    if (c.edges[before].half > 0) add_curve(2 * e);
  }
  std::vector<char> used(c.vertices.size(), 0);
  for (const Curve& k : curves_) used[k.from] = used[k.to] = 1;
  number_.assign(c.vertices.size(), kNone);
  for (Index v = 0; v < c.vertices.size(); ++v) {
    if (!used[v] && c.vertices[v].out != kNone) continue;
    number_[v] = Index(vertices_.size());
    vertices_.push_back(v);
  }
}

/// Vertices that only join two pieces of one circle.
void CurveNet::find_joints() {
  joint_.assign(c_.vertices.size(), 0);
  for (Index v = 0; v < c_.vertices.size(); ++v) {
    const Index h = c_.vertices[v].out;
    if (h == kNone) continue;
    const Index k = c_.clockwise(h);
    if (k == h || c_.clockwise(k) != h || !c_.is_arc(h / 2) || !c_.is_arc(k / 2)) continue;
    const bool same_mark = c_.edges[h / 2].mark == c_.edges[k / 2].mark && c_.edges[h / 2].mark == c_.vertices[v].mark;
    joint_[v] = same_mark && (c_.edges[h / 2].supporting_curve == c_.edges[k / 2].supporting_curve ||
                              exact::same_supporting_curve(c_.supporting_curve(h / 2), c_.supporting_curve(k / 2)));
  }
}

/// The direction in which an edge is written: arcs counter-clockwise, segments from left to right.
Index CurveNet::preferred(Index edge) const {
  return c_.is_arc(edge) && c_.edges[edge].half > 0 ? 2 * edge + 1 : 2 * edge;
}

void CurveNet::add_curve(Index first) {
  Curve k;
  k.first = first;
  k.from = c_.origin(first);
  k.mark = c_.edges[first / 2].mark;
  k.arc = c_.is_arc(first / 2);
  if (k.arc) {
    const auto& circle = measures_.circle(first / 2);
    k.center = {scaled(circle.x), scaled(circle.y)};
    k.radius = scaled(circle.radius);
  }
  Index h = first;
  do {
    k.last = h;
    curve_of_edge_[h / 2] = Index(curves_.size());
    k.to = c_.target(h);
    h = c_.next(h);
  } while (joint_[k.to] && h != first);
  curves_.push_back(k);
}

std::vector<Index> CurveNet::half_edges(const Curve& curve) const {
  std::vector<Index> out{curve.first};
  while (out.back() != curve.last) out.push_back(c_.next(out.back()));
  return out;
}

double CurveNet::angle(const Curve& arc) const {
  double angle = 0;
  for (const Index h : half_edges(arc)) angle += measures_.angle(h / 2).value();
  return angle;
}

/// Whether a curve begins, or begins to be travelled backwards, with this half-edge.
bool CurveNet::is_start(Index half_edge) const {
  const Curve& k = curve_of(half_edge / 2);
  return half_edge == k.first || half_edge == CellComplex::twin(k.last);
}

CurveNet::Ring CurveNet::ring(std::span<const Index> half_edges) const {
  const auto first = std::find_if(half_edges.begin(), half_edges.end(), [this](Index h) { return is_start(h); });
  Ring ring;
  auto add = [&](Index h) {
    if (!is_start(h)) return;
    const Index curve = curve_of_edge_[h / 2];
    ring.push_back({curve, h == curves_[curve].first});
  };
  std::for_each(first, half_edges.end(), add);
  std::for_each(half_edges.begin(), first, add);
  return ring;
}

CurveNet::Ring CurveNet::ring(Index half_edge) const {
  std::vector<Index> cycle{half_edge};
  for (Index h = c_.next(half_edge); h != half_edge; h = c_.next(h)) cycle.push_back(h);
  return ring(cycle);
}

std::vector<Place> CurveNet::extremes(const Curve& arc) const {
  std::vector<Place> out;
  for (const Index h : half_edges(arc)) {
    const Edge& e = c_.edges[h / 2];
    // The rest of the pieces' ends are leftmost or rightmost points.
    if (h != arc.first) out.push_back(at(c_.origin(h)));
    if (at(e.v0)[0] < arc.center[0] && arc.center[0] < at(e.v1)[0]) {
      out.push_back({arc.center[0], arc.center[1] + e.half * arc.radius});
    }
  }
  return out;
}

Bounds CurveNet::bounds(const Curve& curve) const {
  Bounds b{at(curve.from), at(curve.from)};
  auto see = [&b](const Place& p) {
    for (int i : {0, 1}) {
      b.low[i] = std::min(b.low[i], p[i]);
      b.high[i] = std::max(b.high[i], p[i]);
    }
  };
  see(at(curve.to));
  if (curve.arc) {
    for (const Place& p : extremes(curve)) see(p);
  }
  return b;
}

}  // namespace findspace::plane
