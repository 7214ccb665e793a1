// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/surface/surface_ball.h"

#include <algorithm>
#include <cmath>

#include "distance/search/boundary_search.h"
#include "distance/surface/surface_ball_name.h"
#include "distance/surface/surface_field.h"
#include "exact/margins/space_distance.h"
#include "plane/base/subdivide.h"
#include "space/polytope/extent.h"

namespace findspace::distance {

using exact::Real;
using space::RealVector;
using space::Vector;

namespace {

constexpr int kMostBallBoxes = 200000;

struct BallBox {
  space::Extent of;
  double key = 0;  // nothing in it is nearer; or minus that nothing is farther
  bool operator<(const BallBox& other) const { return key > other.key; }
  void draw(plane::ObservedCells& seen) const {
    seen.add_box({of.low.x, of.low.y, of.low.z}, {of.high.x, of.high.y, of.high.z});
  }
};

/// Triangles whose distances are searched in a box of that share of the radius.
std::size_t few(double share) { return share > margin::kLargeShare ? 64 : 400; }

class BallSearch {
 public:
  BallSearch(const SurfaceBall& ball, const RealVector& x, bool farthest)
      : ball_(ball),
        radius_(ball.radius.to_double()),
        x_(x),
        near_(space::rounded(x)),
        farthest_(farthest),
        field_(*ball.surface, {}) {
    const space::RayBody& body = ball.surface->sheets()[0]->body;
    const Vector low = exact::approx(body.low), high = exact::approx(body.high);
    const double tolerance = ball.side == space::TouchSide::kOutside ? radius_ : 0;
    const Vector by{tolerance, tolerance, tolerance};
    const auto complete = askew(low - by, space::plus(high, by));
    size_ = std::max(space::length(complete.first), space::length(complete.second)) + space::length(near_);
    push({complete.first, complete.second});
  }

  BallPlace run() {
    const auto end = queue_.run(
        kMostBallBoxes, [&](const BallBox& top) { return lost_ || !(top.key < best_ - margin::kNearerAtAll * size_); },
        [&](const BallBox& top) {
          if (!settled(top)) divide(top);
        });
    if (lost_ || end == plane::SubdivisionEnd::kSpent) return {};
    if (!found_) return {!(bound_ < exact::kInfinity), std::nullopt};
    const double off = std::max(best_ - bound_, 0.0);
    if (off > margin::kMostFoundError * size_) return {};
    return {true, value(off)};
  }

 private:
  void push(const space::Extent& of) {
    const double key = farthest_ ? -of.farthest(near_) : of.distance(near_);
    if (key < best_ - margin::kNearerAtAll * size_) queue_.push({of, key});
  }

  void divide(const BallBox& box) {
    for (int k = 0; k < 8; ++k) push(box.of.eighth(k));
  }

  double key_of(const Vector& y) const {
    const double d = space::length(y - near_);
    return farthest_ ? -d : d;
  }
  void offer(const Vector& y) {
    const double key = key_of(y);
    if (key < best_) {
      best_ = key;
      place_ = y;
      found_ = true;
    }
  }

  /// The corner of the box, or the place in it, that is best.
  Vector best_of(const BallBox& box) const {
    const auto pick = [&](double c, double lo, double hi) {
      return farthest_ ? (c - lo > hi - c ? lo : hi) : std::clamp(c, lo, hi);
    };
    return {pick(near_.x, box.of.low.x, box.of.high.x), pick(near_.y, box.of.low.y, box.of.high.y),
            pick(near_.z, box.of.low.z, box.of.high.z)};
  }

  /// Whether nothing is left to look for in the box.
  bool settled(const BallBox& box) {
    const Vector middle = box.of.middle();
    const double half = space::length(box.of.high - box.of.low) / 2, noise = margin::kPlaceNoise * size_;
    const SurfaceField::Signed at = field_.at(middle);
    const double clear = (ball_.side == space::TouchSide::kOutside ? at.value : -at.value) - radius_;
    const bool decided = at.certain || at.distance + half < radius_;
    if (decided && clear + half < -noise) return true;
    if (at.certain && clear - half > noise) {
      offer(best_of(box));
      return true;
    }
    if (at.certain && clear > noise) offer(middle);
    if (!(half < radius_ / 4)) return false;
    const auto triangles = field_.near(middle, at.distance + 2 * half + noise, few(half / radius_));
    if (!triangles) {
      lost_ = half < noise;
      return false;
    }
    search(box, *triangles);
    return true;
  }

  /// All of the box is on the right side.
  void search(const BallBox& box, const std::vector<int>& triangles) {
    Constraints constraints;
    for (const int t : triangles)
      constraints.reverse_convex.push_back([this, t](const Vector& y) { return field_.distance(t, y) - radius_; });
    const TouchingConstraint away = [&](const Vector& y) {
      const double d = space::length(y - near_);
      return Touching{d, d > 0 ? space::scaled(1 / d, y - near_) : Vector{}};
    };
    const double most = best_ - margin::kNearerAtAll * size_;  // what is not better need not be looked at
    const auto domain = tetrahedra_of_box(box.of.low, box.of.high);
    BoundaryPlace found;
    if (farthest_) {
      if (found_) constraints.reverse_convex.push_back([&](const Vector& y) { return away(y).value + most; });
      const ConvexDistance distance = [&](const Vector& y) { return away(y).value; };
      found = farthest_allowed(domain, constraints, {&distance, 1}, size_);
      found.value = -found.value;
      found.bound = -found.bound;
    } else {
      if (found_)
        constraints.convex.push_back([&](const Vector& y) {
          const Touching at = away(y);
          return Touching{at.value - most, at.slope};
        });
      found = nearest_allowed(domain, constraints, away, size_, box.key);
    }
    if (found.found && found.value < best_) {
      best_ = found.value;
      place_ = found.place;
      found_ = true;
    }
    if (found.found || found.unresolved || !found.complete) bound_ = std::min(bound_, found.bound);
  }

  Answer value(double off) const {
    Answer out;
    if (const auto named = named_for_ball(ball_, x_, place_, farthest_, (margin::kFoundError * size_ + off) * 64)) {
      const RealVector way = space::minus(*named, x_);
      out.value = sqrt(space::dot(way, way));
      out.nearest = *named;
      return out;
    }
    out.value = Real::from_double(std::fabs(best_));
    out.nearest = {Real::from_double(place_.x), Real::from_double(place_.y), Real::from_double(place_.z)};
    out.set_unproven();
    out.error = margin::kFoundError * size_ + off;
    return out;
  }

  const SurfaceBall& ball_;
  double radius_;
  RealVector x_;
  Vector near_;
  bool farthest_;
  SurfaceField field_;
  double size_ = 0;
  plane::Subdivision<BallBox> queue_{"boxes of the nearest or farthest place of a ball"};
  bool found_ = false, lost_ = false;
  double best_ = exact::kInfinity, bound_ = exact::kInfinity;
  Vector place_;
};

}  // namespace

BallPlace nearest_for_ball(const SurfaceBall& ball, const RealVector& x) { return BallSearch(ball, x, false).run(); }
BallPlace farthest_for_ball(const SurfaceBall& ball, const RealVector& x) { return BallSearch(ball, x, true).run(); }

}  // namespace findspace::distance
