// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/search/plane_projections.h"

#include <cmath>

#include "exact/margins/space_distance.h"
#include "space/body/name_place.h"

namespace findspace::distance {

using space::HalfSpace;
using space::RealVector;
using space::Vector;

PlaneProjections::PlaneProjections(const std::vector<HalfSpace>& planes, const RealVector& p, double size)
    : p_(p), planes_(planes), size_(size) {
  const Vector near = space::rounded(p);
  for (const HalfSpace& h : planes_) seen_.push_back({h.unit, h.approx_value(near)});
}

class PlaneProjections::Collector {
 public:
  Collector(const PlaneProjections& of, const Vector& middle, const Vector& reach, const std::vector<bool>& through)
      : of_(of), middle_(middle), reach_(reach), through_(through), size_(of.size_) {}

  std::vector<Projection> some_corners() {
    const int n = static_cast<int>(of_.seen_.size());
    for (int i = 0; i + 2 < n; ++i) on_line(i, i + 1, true, i + 2, i + 3);
    return std::move(out_);
  }

  std::vector<Projection> run(bool corners_only) {
    const int n = static_cast<int>(of_.seen_.size());
    for (int i = 0; i < n; ++i) {
      const Seen& s = of_.seen_[static_cast<std::size_t>(i)];
      if (!corners_only) put({{i, -1, -1}, space::scaled(-s.gap, s.unit), 0, 0}, 0);
      for (int j = i + 1; j < n; ++j) on_line(i, j, corners_only, j + 1, n);
    }
    return std::move(out_);
  }

 private:
  bool is_through(int i) const { return !through_.empty() && through_[static_cast<std::size_t>(i)]; }

  void on_line(int i, int j, bool corners_only, int from, int to) {
    const Seen &s = of_.seen_[static_cast<std::size_t>(i)], &t = of_.seen_[static_cast<std::size_t>(j)];
    const Vector way = space::cross(s.unit, t.unit);
    const double square = space::dot(way, way);
    if (square < margin::kParallelPlanes) return;
    // The projection is u s + v t with the values of both planes.
    const double c = space::dot(s.unit, t.unit), u = (c * t.gap - s.gap) / square, v = (c * s.gap - t.gap) / square;
    const Vector projection = space::plus(space::scaled(u, s.unit), space::scaled(v, t.unit));
    const double error = margin::kDistanceNoise * (size_ + space::length(projection)) / square;
    if (!corners_only) put({{i, j, -1}, projection, 0, 0}, error);
    if (!line_meets(projection, way, error)) return;
    const bool both = is_through(i) && is_through(j);
    for (int k = from; k < to; ++k) {
      if (both && is_through(k)) continue;
      const Seen& w = of_.seen_[static_cast<std::size_t>(k)];
      const double rise = space::dot(way, w.unit);
      if (rise * rise < margin::kParallelPlanes) continue;
      const double t_at = -(space::dot(w.unit, projection) + w.gap) / rise;
      const Vector corner = space::plus(projection, space::scaled(t_at, way));
      put({{i, j, k}, corner, 0, 0},
          (error + margin::kDistanceNoise * (size_ + space::length(corner))) / std::fabs(rise));
    }
  }

  /// Whether the line may meet the box: its distance from the middle.
  bool line_meets(const Vector& projection, const Vector& way, double error) const {
    const Vector off = space::cross(way, projection - middle_);
    return space::length(off) <= (space::length(reach_) + error) * space::length(way) * margin::kLineReach;
  }

  void put(Projection projection, double error) {
    const Vector d = projection.at - middle_;
    if (std::fabs(d.x) > reach_.x + error || std::fabs(d.y) > reach_.y + error || std::fabs(d.z) > reach_.z + error)
      return;
    projection.error = error + margin::kProjectionNoise * size_;
    projection.key = space::length(projection.at);
    out_.push_back(projection);
  }

  const PlaneProjections& of_;
  Vector middle_, reach_;
  const std::vector<bool>& through_;
  double size_;
  std::vector<Projection> out_;
};

std::vector<PlaneProjections::Projection> PlaneProjections::all(const Vector& middle, const Vector& reach,
                                                                bool corners_only,
                                                                const std::vector<bool>& through) const {
  return Collector(*this, middle, reach, through).run(corners_only);
}

std::vector<PlaneProjections::Projection> PlaneProjections::some_corners(const Vector& middle,
                                                                         const Vector& reach) const {
  return Collector(*this, middle, reach, {}).some_corners();
}

std::vector<bool> PlaneProjections::through(const RealVector& place) const {
  std::vector<bool> out;
  const Vector near = space::rounded(place);
  for (const HalfSpace& h : planes_) out.push_back(h.sign(place, near) == 0);
  return out;
}

RealVector PlaneProjections::exact(const Projection& projection) const {
  std::vector<HalfSpace> on;
  for (const int k : projection.planes) {
    if (k >= 0) on.push_back(planes_[static_cast<std::size_t>(k)]);
  }
  return space::name_places(on, {}, p_)[0];
}

}  // namespace findspace::distance
