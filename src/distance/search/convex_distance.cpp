// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/search/convex_distance.h"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>

#include "exact/margins/space_distance.h"

namespace findspace::distance {

using space::dot;
using space::HalfSpace;
using space::Vector;

namespace {

/// At most three planes.
struct Basis {
  std::array<int, 3> plane{};
  std::size_t count = 0;

  void push(int k) { plane[count++] = k; }
  std::span<const int> all() const { return {plane.data(), count}; }
  bool holds(int k) const { return std::find(all().begin(), all().end(), k) != all().end(); }
};

/// The dual simplex of projection_search.h for a single set, in doubles.
class PlanesDistance {
 public:
  explicit PlanesDistance(std::vector<NearPlane> planes) : planes_(std::move(planes)) {}
  double operator()(const Vector& x) const { return space::length(way(x)); }
  Vector way(const Vector& x) const {
    Vector y;
    Basis basis;
    const double slack = margin::kDistanceNoise * (space::size_of(x) + 1);
    for (int step = 0; step < 100; ++step) {
      int worst = -1;
      double most = slack;
      for (int i = 0; i < static_cast<int>(planes_.size()); ++i) {
        const double out = gap(i, x) + dot(unit(i), y);
        if (out > most && !basis.holds(i)) {
          most = out;
          worst = i;
        }
      }
      if (worst < 0 || !exchange(basis, worst, x, y)) break;
    }
    return y;
  }

 private:
  const Vector& unit(int i) const { return planes_[static_cast<std::size_t>(i)].unit; }
  double gap(int i, const Vector& x) const { return dot(unit(i), x) + planes_[static_cast<std::size_t>(i)].shift; }

  /// The projection of x on plane `fresh` and some of the basis that keeps below all of them.
  bool exchange(Basis& basis, int fresh, const Vector& x, Vector& y) const {
    for (int kept = 0; kept < (1 << basis.count); ++kept) {
      if (kept == 7) break;  // four planes
      Basis on;
      on.push(fresh);
      for (std::size_t i = 0; i < basis.count; ++i) {
        if (kept >> i & 1) on.push(basis.plane[i]);
      }
      const auto projection = projection_on(on.all(), x);
      if (!projection) continue;
      const auto planes = basis.all();
      const bool below = std::all_of(planes.begin(), planes.end(), [&](int i) {
        return gap(i, x) + dot(unit(i), *projection) <= margin::kPlaceNoise * (space::size_of(x) + 1);
      });
      if (!below) continue;
      basis = on;
      y = *projection;
      return true;
    }
    return false;
  }

  std::optional<Vector> projection_on(std::span<const int> on, const Vector& x) const {
    // Gram-Schmidt on the normals, then back substitution for the multipliers.
    const std::size_t n = on.size();
    std::array<std::array<double, 4>, 3> g{};
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) g[i][j] = dot(unit(on[i]), unit(on[j]));
      g[i][3] = -gap(on[i], x);
    }
    for (std::size_t k = 0; k < n; ++k) {
      if (g[k][k] < margin::kDependentNormals) return std::nullopt;
      for (std::size_t i = 0; i < n; ++i) {
        if (i == k) continue;
        const double factor = g[i][k] / g[k][k];
        for (std::size_t j = 0; j < 4; ++j) g[i][j] -= factor * g[k][j];
      }
    }
    Vector y;
    for (std::size_t i = 0; i < n; ++i) {
      const double multiplier = g[i][3] / g[i][i];
      if (multiplier > 0) return std::nullopt;
      y = space::plus(y, space::scaled(multiplier, unit(on[i])));
    }
    return y;
  }

  std::vector<NearPlane> planes_;
};

std::vector<NearPlane> near_planes(std::span<const HalfSpace> planes) {
  std::vector<NearPlane> out;
  for (const HalfSpace& h : planes) out.push_back({h.unit, h.shift});
  return out;
}

double to_segment(const Vector& x, const Vector& a, const Vector& b) {
  const Vector e = b - a, from = x - a;
  const double square = dot(e, e), part = square > 0 ? std::clamp(dot(from, e) / square, 0.0, 1.0) : 0;
  return space::length(from - space::scaled(part, e));
}

/// A convex polygon, segment or point.
class FlatDistance {
 public:
  explicit FlatDistance(const space::ConvexRegion& set) {
    const std::size_t count = set.vertices().size();
    for (const auto& v : set.vertices()) corners_.push_back(v.near);
    if (count < 3) return;
    for (const int f : set.facets()) {
      const std::vector<int> ring = set.circuit(f);
      if (ring.size() != count) continue;
      for (std::size_t k = 0; k < count; ++k) corners_[k] = set.vertices()[std::size_t(ring[k])].near;
      normal_ = set.planes()[std::size_t(f)].unit;
      return;
    }
  }
  double operator()(const Vector& x) const {
    const std::size_t count = corners_.size();
    bool inside = count > 2;
    double least = space::length(x - corners_[0]);
    for (std::size_t k = 0; k < count && count > 1; ++k) {
      const Vector &a = corners_[k], &b = corners_[(k + 1) % count];
      inside = inside && space::dot(space::cross(normal_, b - a), x - a) >= 0;
      least = std::min(least, to_segment(x, a, b));
    }
    return inside ? std::fabs(dot(normal_, x - corners_[0])) : least;
  }

 private:
  std::vector<Vector> corners_;
  Vector normal_;
};

}  // namespace

ConvexDistance distance_to(std::span<const HalfSpace> planes) {
  return [d = std::make_shared<const PlanesDistance>(near_planes(planes))](const Vector& x) { return (*d)(x); };
}

std::function<Vector(const Vector&)> way_to(std::span<const HalfSpace> planes) {
  return [d = std::make_shared<const PlanesDistance>(near_planes(planes))](const Vector& x) { return d->way(x); };
}

std::function<Vector(const Vector&)> way_to(std::vector<NearPlane> planes) {
  return [d = std::make_shared<const PlanesDistance>(std::move(planes))](const Vector& x) { return d->way(x); };
}

ConvexDistance distance_to_flat(const space::ConvexRegion& set) {
  return [d = std::make_shared<const FlatDistance>(set)](const Vector& x) { return (*d)(x); };
}

}  // namespace findspace::distance
