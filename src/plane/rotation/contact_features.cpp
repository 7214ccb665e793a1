// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/rotation/contact_features.h"

#include <algorithm>
#include <cmath>
#include <span>

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
  FeatureCollector(const CellComplex& c, const exact::RealPoint& about, const std::function<bool(Mark)>& material,
                   const ChosenFeatures& chosen)
      : c_(c), material_(material), chosen_(chosen), net_(c, about) {
    points_.reserve(net_.vertex_count());
    for (Index v = 0; v < net_.vertex_count(); ++v) points_.push_back(rough(net_.vertex(v)));
    make_room();
  }

  ContactFeatures run() {
    for (const Index e : net_.edges()) add_edge(e);
    for (Index v = 0; v < net_.vertex_count(); ++v) add_vertex(v);
    return std::move(out_);
  }

 private:
  bool material_left_of(Index half_edge) const { return material_(c_.faces[c_.face(half_edge)].mark); }

  /// For the edges that leave each vertex.
  void make_room() {
    leaving_start_.assign(net_.vertex_count() + 1, 0);
    for (const Edge& e : c_.edges)
      for (const Index v : {e.v0, e.v1}) ++leaving_start_[v + 1];
    for (Index v = 0; v < net_.vertex_count(); ++v) leaving_start_[v + 1] += leaving_start_[v];
    leaving_.resize(leaving_start_.back());
    leaving_end_.assign(leaving_start_.begin(), leaving_start_.end() - 1);
  }

  bool is_chosen(bool edge, const Cone& normals, Outside outside) {
    const Index number = edge ? edges_++ : rounds_++;
    return !chosen_ || chosen_({edge, number, normals, outside});
  }

  void add_edge(Index k) {
    const bool arc = c_.edges[k].half != 0, swapped = c_.edges[k].half > 0;
    const Index v0 = swapped ? c_.edges[k].v1 : c_.edges[k].v0, v1 = swapped ? c_.edges[k].v0 : c_.edges[k].v1;
    const Index half_edge = 2 * k + (swapped ? 1 : 0);
    const bool left = material_left_of(half_edge), right = material_left_of(half_edge ^ 1u);
    const double x0 = points_[v0].real(), y0 = points_[v0].imag(), x1 = points_[v1].real(), y1 = points_[v1].imag();
    const Outside beside = left == right ? Outside::kSeveral : Outside::kOneSide;
    double start = std::atan2(y1 - y0, x1 - x0), end = start + kPi;  // the tangents that leave the ends
    if (arc) {
      const RotatedEdge e = net_.edge(k);
      const double cx = rough(e.center.x), cy = rough(e.center.y), r = rough(e.radius);
      const double from = std::atan2(y0 - cy, x0 - cx), to = std::atan2(y1 - cy, x1 - cx);
      const double width = positive(to - from);
      start = from + kPi / 2;
      end = to - kPi / 2;
      const Cone outwards{from, width}, inwards{from + kPi, width};
      if ((left || !right) && is_chosen(false, outwards, beside))
        out_.rounds.push_back({e.center, e.radius, cx, cy, r, outwards, beside});
      if ((right || !left) && is_chosen(false, inwards, beside))
        out_.rounds.push_back({e.center, -e.radius, cx, cy, -r, inwards, beside});
    } else {
      const double length = std::hypot(x1 - x0, y1 - y0);
      for (int side : {1, -1}) {
        const bool inside = side > 0 ? left : right, outside = side > 0 ? right : left;
        if (inside && !outside) continue;
        const double nx = side * (y0 - y1) / length, ny = side * (x1 - x0) / length, normal = std::atan2(ny, nx);
        if (is_chosen(true, {normal, 0}, beside))
          out_.edges.push_back({net_.vertex(v0), net_.vertex(v1), side, x0, y0, x1, y1, nx, ny, normal, beside});
      }
    }
    leaving_[leaving_end_[v0]++] = {positive(start), left, right, arc};
    leaving_[leaving_end_[v1]++] = {positive(end), right, left, arc};
  }

  void add_corner(Index v, Cone normals, Outside outside = Outside::kOneSide) {
    if (!is_chosen(false, normals, outside)) return;
    out_.rounds.push_back({net_.vertex(v), exact::Real(), points_[v].real(), points_[v].imag(), 0, normals, outside});
  }

  void add_vertex(Index v) {
    const std::span<Leaving> around =
        std::span(leaving_).subspan(leaving_start_[v], leaving_start_[v + 1] - leaving_start_[v]);
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
  const ChosenFeatures& chosen_;
  RotatedNet net_;
  std::vector<RoughPoint> points_;                  // the vertices
  std::vector<Index> leaving_start_, leaving_end_;  // of each vertex: its edges so far
  std::vector<Leaving> leaving_;
  Index rounds_ = 0, edges_ = 0;  // so far, chosen or not
  ContactFeatures out_;
};

}  // namespace

ContactFeatures contact_features(const CellComplex& complex, const exact::RealPoint& about,
                                 const std::function<bool(Mark)>& material, const ChosenFeatures& chosen) {
  return FeatureCollector(complex, about, material, chosen).run();
}

bool cones_meet(const Cone& a, const Cone& b, double tolerance) {
  const double gap = positive(b.from - a.from);  // b begins that far after a
  return gap <= a.width + tolerance || gap + b.width >= 2 * kPi - tolerance;
}

}  // namespace findspace::plane
