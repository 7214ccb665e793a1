// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/search/least_in_box.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "distance/search/lp_bound.h"
#include "exact/margins/space_distance.h"
#include "plane/base/parallel.h"
#include "plane/base/subdivide.h"

namespace findspace::distance {

using exact::Real;
using exact::Tried;
using space::RealVector;
using space::Vector;

namespace {

constexpr std::size_t kAtOnce = 16;

struct Box {
  Vector center, half;
  double bound = 0;
  bool operator<(const Box& other) const { return bound > other.bound; }  // the least is on top
  void draw(plane::ObservedCells& seen) const {
    const Vector low = center - half, high = space::plus(center, half);
    seen.add_box({low.x, low.y, low.z}, {high.x, high.y, high.z});
  }
};

using Value = std::function<Tried<Real>(const RealVector&)>;

class BoxSearch {
 public:
  explicit BoxSearch(const Value& value, double floor) : value_(value), floor_(floor) {}

  Tried<Answer> run(const Vector& low, const Vector& high) {
    const Vector half = space::scaled(0.5, high - low);
    tolerance_ = margin::kLeastInBox * (space::length(half) + 1);
    take({{space::plus(low, half), half, 0}});
    std::vector<Box> parts;
    queue_.run(
        kMostValues, kAtOnce,
        [&](const Box& top) {
          return refused_ || count_ >= kMostValues || least_ - top.bound <= tolerance_ || least_ <= floor_;
        },
        [&](const Box& top) { divide(top, parts); }, [&] { take(std::exchange(parts, {})); });
    if (refused_) return *refused_;
    const double bound = std::max(floor_, queue_.empty() ? least_ : std::min(queue_.best().bound, least_));
    // Roundings: of the centres and of the values.
    const double noise = floor_ >= bound ? 0 : margin::kPlaceNoise * (std::fabs(bound) + space::length(half));
    const Real least = std::min(value_at_best_, Real::from_double((floor_ >= bound ? floor_ : bound) - noise));
    return least_answer(value_at_best_, least, least == value_at_best_, best_);
  }

 private:
  static void divide(const Box& box, std::vector<Box>& parts) {
    const Vector h = space::scaled(0.5, box.half);
    for (int k = 0; k < 8; ++k) {
      const Vector by{k & 1 ? h.x : -h.x, k & 2 ? h.y : -h.y, k & 4 ? h.z : -h.z};
      parts.push_back({space::plus(box.center, by), h, 0});
    }
  }

  void take(std::vector<Box> boxes) {
    std::vector<Tried<Real>> values(boxes.size(), Real());
    plane::parallel_for(boxes.size(), [&](std::size_t k) { values[k] = value_(space::real(boxes[k].center)); });
    for (const Tried<Real>& v : values) {
      if (v) continue;
      refused_ = v.refusal();
      return;
    }
    count_ += static_cast<int>(boxes.size());
    for (std::size_t k = 0; k < boxes.size(); ++k) {
      const double value = values[k]->to_double();
      if (value < least_ || count_ == 1) {
        least_ = value;
        value_at_best_ = *std::move(values[k]);
        best_ = space::real(boxes[k].center);
      }
      boxes[k].bound = value - space::length(boxes[k].half);
      queue_.push(boxes[k]);
    }
  }

  const Value& value_;
  double floor_, tolerance_ = 0, least_ = exact::kInfinity;
  int count_ = 0;
  plane::Subdivision<Box> queue_{"boxes of the position with the least value"};
  std::optional<exact::Refusal> refused_;
  Real value_at_best_;
  RealVector best_{};
};

}  // namespace

Tried<Answer> least_in_box(const Value& value, const Vector& low, const Vector& high, double floor) {
  return BoxSearch(value, floor).run(low, high);
}

namespace {

/// The unit vector along which the distance grows.
std::optional<Vector> direction(const Answer& v) {
  if (v.witness.empty()) return std::nullopt;
  const Vector w = space::rounded(space::minus(v.witness[0].at, v.witness[1].at));
  const double length = space::length(w), value = v.value.to_double();
  // The points of a signed value may be others.
  if (!(length > 0) || std::fabs(length - std::fabs(value)) > margin::kWitnessAgrees * length) return std::nullopt;
  return space::scaled(1 / (value < 0 ? -length : length), w);
}

using ConvexValue = std::function<exact::Tried<Answer>(const RealVector&)>;

class TangentSearch {
 public:
  TangentSearch(const ConvexValue& value, const Vector& low, const Vector& high)
      : value_(value), size_(space::length(high - low) + space::size_of(low) + space::size_of(high) + 1) {
    const Vector by = space::scaled(3, high - low);
    corners_ = {low, space::plus(low, {by.x, 0, 0}), space::plus(low, {0, by.y, 0}), space::plus(low, {0, 0, by.z})};
    next_ = space::scaled(0.5, space::plus(low, high));
  }

  TriedAnswer run() {
    double bound = -exact::kInfinity;
    for (int k = 0; k < kMostTangents && !(least_ - bound <= margin::kTangentsMeet * size_); ++k) {
      if (!add_tangent()) break;
      const LpBound lowest = bounding_lp(columns_, std::nullopt);
      bound = -lowest.value - margin::kTangentNoise * size_;
      Vector to{};
      for (std::size_t c = 0; c < 4; ++c) to = space::plus(to, space::scaled(lowest.rows[c], corners_[c]));
      // Between the best and the lowest: where tangents are nearly level the lowest is anywhere.
      const Vector best = space::rounded(out_.at);
      next_ = space::plus(best, space::scaled(k % 4 == 3 ? 1.0 : 0.3, to - best));
    }
    if (refused_) return *refused_;
    if (least_ - bound > margin::kTangentsApart * size_) return std::nullopt;
    offer_near();
    if (refused_) return *refused_;
    return least_answer(out_.value, std::min(out_.value, Real::from_double(bound)), false, out_.at);
  }

 private:
  bool add_tangent() {
    const RealVector p = space::real(next_);
    const exact::Tried<Answer> found = value_(p);
    if (!found) {
      refused_ = found.refusal();
      return false;
    }
    const Answer& v = *found;
    const double value = v.value.to_double();
    if (value < least_) {
      least_ = value;
      out_.value = v.value;
      out_.at = p;
    }
    const auto along = direction(v);
    if (!along) return false;
    std::array<double, 4> column{};
    for (std::size_t c = 0; c < 4; ++c) column[c] = -(value + space::dot(*along, corners_[c] - next_));
    columns_.push_back(column);
    return true;
  }

  /// A position in whole steps may well be the true one.
  void offer_near() {
    RealVector even = out_.at;
    for (Real& c : even) c = Real(exact::round(c));
    const exact::Tried<Answer> v = value_(even);
    if (!v) {
      refused_ = v.refusal();
    } else if (v->value <= out_.value + Real::from_double(margin::kNoBetter * size_)) {
      out_.value = v->value;
      out_.at = even;
    }
  }

  const ConvexValue& value_;
  double size_, least_ = exact::kInfinity;
  std::array<Vector, 4> corners_;  // of a tetrahedron about the box
  Vector next_;
  std::vector<std::array<double, 4>> columns_;
  std::optional<exact::Refusal> refused_;
  Answer out_ = least_answer({}, {}, false, {});
};

}  // namespace

TriedAnswer convex_least(const ConvexValue& value, const Vector& low, const Vector& high) {
  return TangentSearch(value, low, high).run();
}

}  // namespace findspace::distance
