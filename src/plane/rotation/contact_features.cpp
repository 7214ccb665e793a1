// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/rotation/contact_features.h"

#include <algorithm>
#include <cmath>

#include "exact/margins/plane.h"

namespace findspace::plane {
namespace {

double positive(double angle) {
  const double r = std::fmod(angle, 2 * kPi);
  return r < 0 ? r + 2 * kPi : r;
}

/// An edge that leaves a vertex, as seen from there.
struct Leaving {
  double direction;
  bool left, right;  // material on that side
  bool arc;
};

class FeatureCollector {
 public:
  FeatureCollector(const CellComplex& c, const exact::RealPoint& about, const std::function<bool(Mark)>& material)
      : c_(c), material_(material), net_(RotatedNet::of(c, about)), leaving_(c.vertices.size()) {}

  ContactFeatures run() {
    for (const RotatedEdge& e : net_.edges) add_edge(e);
    for (Index v = 0; v < net_.vertices.size(); ++v) add_vertex(v);
    return std::move(out_);
  }

 private:
  bool material_left_of(Index half_edge) const { return material_(c_.faces[c_.face(half_edge)].mark); }

  void add_edge(const RotatedEdge& e) {
    const Index half_edge = 2 * e.cell + (c_.edges[e.cell].half > 0 ? 1 : 0);
    const bool left = material_left_of(half_edge), right = material_left_of(half_edge ^ 1u);
    const double x0 = rough(e.p.x), y0 = rough(e.p.y), x1 = rough(e.q.x), y1 = rough(e.q.y);
    const Outside beside = left == right ? Outside::kSeveral : Outside::kOneSide;
    double start = std::atan2(y1 - y0, x1 - x0), end = start + kPi;  // the tangents that leave the ends
    if (e.arc) {
      const double cx = rough(e.center.x), cy = rough(e.center.y), r = rough(e.radius);
      const double from = std::atan2(y0 - cy, x0 - cx), to = std::atan2(y1 - cy, x1 - cx);
      const double width = positive(to - from);
      start = from + kPi / 2;
      end = to - kPi / 2;
      if (left || !right) out_.rounds.push_back({e.center, e.radius, cx, cy, r, {from, width}, beside});
      if (right || !left) out_.rounds.push_back({e.center, -e.radius, cx, cy, -r, {from + kPi, width}, beside});
    } else {
      const double length = std::hypot(x1 - x0, y1 - y0);
      for (int side : {1, -1}) {
        const bool inside = side > 0 ? left : right, outside = side > 0 ? right : left;
        if (inside && !outside) continue;
        const double nx = side * (y0 - y1) / length, ny = side * (x1 - x0) / length;
        out_.edges.push_back({e.p, e.q, side, x0, y0, x1, y1, nx, ny, std::atan2(ny, nx), beside});
      }
    }
    leaving_[e.v0].push_back({positive(start), left, right, e.arc});
    leaving_[e.v1].push_back({positive(end), right, left, e.arc});
  }

  void add_corner(Index v, Cone normals, Outside outside = Outside::kOneSide) {
    const RealVector& p = net_.vertices[v];
    out_.rounds.push_back({p, exact::Real(), rough(p.x), rough(p.y), 0, normals, outside});
  }

  void add_vertex(Index v) {
    std::vector<Leaving>& around = leaving_[v];
    if (around.empty()) return add_corner(v, {0, 2 * kPi});
    std::sort(around.begin(), around.end(), [](const auto& p, const auto& q) { return p.direction < q.direction; });
    const bool smooth = around.size() == 2 && (around[0].arc || around[1].arc);
    bool found = false, thin = false;
    int gaps = 0;
    for (std::size_t k = 0; k < around.size(); ++k) {
      const Leaving &e = around[k], &next = around[(k + 1) % around.size()];
      thin |= e.left == e.right;
      double gap = around.size() == 1 ? 2 * kPi : positive(next.direction - e.direction);
      // Two that leave with one tangent: the order of their directions is chance, and one side may be a cusp.
      if (!e.left && gap < margin::kOneDirection) gap = 2 * kPi;
      if (e.left) continue;
      ++gaps;
      if (gap < kPi - margin::kOneDirection) continue;
      found = true;
      // Where two curves join smoothly their own normals are enough.
      if (!smooth || gap > kPi + margin::kOneDirection)
        add_corner(v, {e.direction + kPi / 2, std::max(0.0, gap - kPi)});
    }
    if (thin || gaps > 1) add_corner(v, {0, 2 * kPi}, found || !thin ? Outside::kOnlySeveral : Outside::kSeveral);
  }

  const CellComplex& c_;
  const std::function<bool(Mark)>& material_;
  RotatedNet net_;
  std::vector<std::vector<Leaving>> leaving_;
  ContactFeatures out_;
};

}  // namespace

ContactFeatures contact_features(const CellComplex& complex, const exact::RealPoint& about,
                                 const std::function<bool(Mark)>& material) {
  return FeatureCollector(complex, about, material).run();
}

bool cones_meet(const Cone& a, const Cone& b, double tolerance) {
  const double gap = positive(b.from - a.from);  // b begins that far after a
  return gap <= a.width + tolerance || gap + b.width >= 2 * kPi - tolerance;
}

}  // namespace findspace::plane
