// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/search/convex_distance.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <memory>
#include <optional>

#include "exact/margins/space_distance.h"
#include "plane/base/lazy.h"
#include "space/body/open_union.h"

namespace findspace::distance {

using space::dot;
using space::HalfSpace;
using space::Vector;

namespace {

Vector nearest_on_segment(const Vector& x, const Vector& a, const Vector& b) {
  const Vector e = b - a;
  const double square = dot(e, e), part = square > 0 ? std::clamp(dot(x - a, e) / square, 0.0, 1.0) : 0;
  return space::plus(a, space::scaled(part, e));
}

/// A convex polygon, segment or point.
class FlatSet {
 public:
  explicit FlatSet(const space::ConvexRegion& set) {
    const std::size_t count = set.vertices().size();
    for (const auto& v : set.vertices()) corners_.push_back(v.near);
    if (count < 3) return;
    for (const int f : set.facets()) {
      if (set.circuit(f).size() != count) continue;
      take_facet(set, f);
      return;
    }
  }
  /// A facet of a set with interior.
  FlatSet(const space::ConvexRegion& set, int facet) { take_facet(set, facet); }

  /// How far x is beyond its plane.
  double beyond(const Vector& x) const { return dot(normal_, x - corners_[0]); }
  Vector nearest(const Vector& x) const {
    const std::size_t count = corners_.size();
    bool inside = count > 2;
    Vector best = corners_[0];
    double least = space::length(x - best);
    for (std::size_t k = 0; k < count && count > 1; ++k) {
      const Vector &a = corners_[k], &b = corners_[(k + 1) % count];
      inside = inside && dot(space::cross(normal_, b - a), x - a) >= 0;
      const Vector on = nearest_on_segment(x, a, b);
      const double d = space::length(x - on);
      if (!(d < least)) continue;
      least = d;
      best = on;
    }
    return inside ? x - space::scaled(beyond(x), normal_) : best;
  }

 private:
  void take_facet(const space::ConvexRegion& set, int facet) {
    corners_.clear();
    for (const int v : set.circuit(facet)) corners_.push_back(set.vertices()[std::size_t(v)].near);
    normal_ = set.planes()[std::size_t(facet)].unit;
  }

  std::vector<Vector> corners_;
  Vector normal_;
};

/// At most three planes.
struct Basis {
  std::array<int, 3> plane{};
  std::size_t count = 0;

  void push(int k) { plane[count++] = k; }
  std::span<const int> all() const { return {plane.data(), count}; }
  bool holds(int k) const { return std::find(all().begin(), all().end(), k) != all().end(); }
};

/// The dual simplex of projection_search.h for a single set, in doubles. Where these do not come to a place of the set,
/// as of parts as thin as a rounding, its facets say it.
class PlanesDistance {
 public:
  explicit PlanesDistance(std::span<const HalfSpace> planes) : exact_(planes.begin(), planes.end()) {
    for (const HalfSpace& h : planes) planes_.push_back({h.unit, h.shift});
    sharp_ = sharp(planes_);
  }
  explicit PlanesDistance(std::vector<NearPlane> planes) : planes_(std::move(planes)) {
    for (const NearPlane& h : planes_) exact_.emplace_back(space::real(h.unit), exact::Real::from_double(h.shift));
    sharp_ = sharp(planes_);
  }
  double operator()(const Vector& x) const { return space::length(way(x)); }
  Vector way(const Vector& x) const {
    if (sharp_) return way_by_facets(x);
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
      if (worst < 0) return y;
      if (!exchange(basis, worst, x, y)) break;
    }
    return way_by_facets(x);
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

  /// By an orthonormal basis of the normals: what is off in it grows with one over the sine of their angle, of the
  /// projection's length by much less where they do not look away from each other.
  std::optional<Vector> projection_on(std::span<const int> on, const Vector& x) const {
    const std::size_t n = on.size();
    std::array<Vector, 3> base;
    std::array<std::array<double, 3>, 3> part{};  // of normal k along base j
    std::array<double, 3> along{}, multiplier{};
    for (std::size_t k = 0; k < n; ++k) {
      Vector rest = unit(on[k]);
      for (int twice = 0; twice < 2; ++twice) {
        for (std::size_t j = 0; j < k; ++j) rest = rest - space::scaled(dot(rest, base[j]), base[j]);
      }
      const double sine = space::length(rest);
      if (sine < margin::kDependentNormals) return std::nullopt;
      base[k] = space::scaled(1 / sine, rest);
      for (std::size_t j = 0; j <= k; ++j) part[k][j] = dot(unit(on[k]), base[j]);
      along[k] = -gap(on[k], x);
      for (std::size_t j = 0; j < k; ++j) along[k] -= part[k][j] * along[j];
      along[k] /= part[k][k];
    }
    Vector y;
    for (std::size_t k = n; k-- > 0;) {
      multiplier[k] = along[k];
      for (std::size_t i = k + 1; i < n; ++i) multiplier[k] -= part[i][k] * multiplier[i];
      multiplier[k] /= part[k][k];
      if (multiplier[k] > 0) return std::nullopt;
      y = space::plus(y, space::scaled(along[k], base[k]));
    }
    return y;
  }

  /// Whether two planes look away from each other and are nearly parallel: doubles do not tell where their edge is.
  static bool sharp(const std::vector<NearPlane>& planes) {
    for (std::size_t k = 1; k < planes.size(); ++k) {
      for (std::size_t j = 0; j < k; ++j) {
        if (!(dot(planes[k].unit, planes[j].unit) < 0)) continue;
        const double sine = space::length(space::cross(planes[k].unit, planes[j].unit));
        if (sine < margin::kSharpEdge && sine > margin::kParallelSine) return true;
      }
    }
    return false;
  }

  /// By the facets between exact corners, or exactly where the set goes on for ever.
  Vector way_by_facets(const Vector& x) const {
    const std::vector<FlatSet>& facets = facets_.of([this] { return made_facets(); });
    Vector best;
    double least = exact::kInfinity;
    bool outside = false;
    for (const FlatSet& facet : facets) {
      if (!(facet.beyond(x) > 0)) continue;
      outside = true;
      const Vector way = facet.nearest(x) - x;
      const double d = space::length(way);
      if (!(d < least)) continue;
      least = d;
      best = way;
    }
    if (outside || !facets.empty()) return best;
    const space::RealVector p = space::real(x);
    const auto nearest = nearest_in(exact_, p);
    assert(nearest);  // the sets are not empty
    return space::rounded(space::minus(*nearest, p));
  }

  std::vector<FlatSet> made_facets() const {
    std::vector<FlatSet> out;
    const exact::Real far(kFarCoordinate);
    space::ConvexRegion region({-far, -far, -far}, {far, far, far});
    for (const HalfSpace& h : exact_) region.cut(h);
    const auto bounded = [](const auto& v) { return space::size_of(v.near) < static_cast<double>(kFarCoordinate) / 2; };
    if (region.dimension() < 3 || !std::all_of(region.vertices().begin(), region.vertices().end(), bounded)) return out;
    for (const int f : region.facets()) out.emplace_back(region, f);
    return out;
  }

  static constexpr std::int64_t kFarCoordinate = std::int64_t{1} << 50;
  std::vector<HalfSpace> exact_;
  bool sharp_ = false;
  plane::Lazy<std::vector<FlatSet>> facets_;
  std::vector<NearPlane> planes_;
};

}  // namespace

ConvexDistance distance_to(std::span<const HalfSpace> planes) {
  return [d = std::make_shared<const PlanesDistance>(planes)](const Vector& x) { return (*d)(x); };
}

std::function<Vector(const Vector&)> way_to(std::span<const HalfSpace> planes) {
  return [d = std::make_shared<const PlanesDistance>(planes)](const Vector& x) { return d->way(x); };
}

std::function<Vector(const Vector&)> way_to(std::vector<NearPlane> planes) {
  return [d = std::make_shared<const PlanesDistance>(std::move(planes))](const Vector& x) { return d->way(x); };
}

ConvexDistance distance_to_flat(const space::ConvexRegion& set) {
  return [flat = std::make_shared<const FlatSet>(set)](const Vector& x) { return space::length(x - flat->nearest(x)); };
}

}  // namespace findspace::distance
