// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/solid/convex_least.h"

#include <cmath>
#include <vector>

#include "distance/search/lp_bound.h"
#include "exact/margins/space_distance.h"

namespace findspace::distance {

using exact::Real;
using space::RealVector;
using space::Vector;

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

using Value = std::function<exact::Tried<Answer>(const RealVector&)>;

class Search {
 public:
  Search(const Value& value, const Vector& low, const Vector& high)
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

  const Value& value_;
  double size_, least_ = exact::kInfinity;
  std::array<Vector, 4> corners_;  // of a tetrahedron about the box
  Vector next_;
  std::vector<std::array<double, 4>> columns_;
  std::optional<exact::Refusal> refused_;
  Answer out_ = least_answer({}, {}, false, {});
};

}  // namespace

TriedAnswer convex_least(const Value& value, const Vector& low, const Vector& high) {
  return Search(value, low, high).run();
}

}  // namespace findspace::distance
