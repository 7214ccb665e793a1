// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/search/least_in_box.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "distance/search/lp_bound.h"
#include "exact/margins/space_distance.h"
#include "plane/base/parallel.h"
#include "plane/base/search_work.h"
#include "plane/base/subdivide.h"
#include "space/polytope/extent.h"

namespace findspace::distance {

using exact::Real;
using exact::Tried;
using space::RealVector;
using space::Vector;

namespace {

constexpr std::size_t kAtOnce = 16;

struct Box {
  space::Extent of;
  double bound = 0;
  bool operator<(const Box& other) const { return bound > other.bound; }  // the least is on top
  void draw(plane::ObservedCells& seen) const {
    seen.add_box({of.low.x, of.low.y, of.low.z}, {of.high.x, of.high.y, of.high.z});
  }
};

using Value = std::function<Tried<Answer>(const RealVector&)>;

class BoxSearch {
 public:
  BoxSearch(const Value& value, double floor, int most) : value_(value), floor_(floor), most_(plane::allowed(most)) {}

  Tried<Answer> run(const Vector& low, const Vector& high) {
    const plane::SearchQuestion question;
    work_ = &question.work();
    const Vector half = space::scaled(0.5, high - low);
    tolerance_ = margin::kLeastInBox * (space::length(half) + 1);
    take({{{low, high}, 0}});
    std::vector<Box> parts;
    queue_.run(
        most_, kAtOnce,
        [&](const Box& top) {
          return refused_ || count_ >= most_ || work_->spent() || least_ - top.bound <= tolerance_ + best_.slack() ||
                 least_ <= floor_;
        },
        [&](const Box& top) { divide(top, parts); }, [&] { take(std::exchange(parts, {})); });
    if (refused_) return *refused_;
    const double bound = std::max(floor_, queue_.empty() ? least_ : std::min(queue_.best().bound, least_));
    // Roundings: of the centres and of the values.
    const double noise = floor_ >= bound ? 0 : margin::kPlaceNoise * (std::fabs(bound) + space::length(half));
    return least_taken(best_.at, best_, Real::from_double((floor_ >= bound ? floor_ : bound) - noise));
  }

 private:
  static void divide(const Box& box, std::vector<Box>& parts) {
    for (int k = 0; k < 8; ++k) parts.push_back({box.of.eighth(k), box.bound});
  }

  void take(const std::vector<Box>& boxes) {
    for (std::size_t k = 0; k < boxes.size() && !refused_;) k += take_some(std::span(boxes).subspan(k));
  }

  /// The first ones, as many as the cells that are left allow by what one value took so far. What is not looked at any
  /// more keeps the bound of the box that it is a part of.
  std::size_t take_some(std::span<const Box> boxes) {
    if (work_->spent()) {
      for (const Box& box : boxes) queue_.push(box);
      return boxes.size();
    }
    at_once_ = std::clamp(work_->left / (2 * dearest_), 1L, 2 * at_once_);
    boxes = boxes.first(std::min(boxes.size(), static_cast<std::size_t>(at_once_)));
    const long share = count_ == 0 ? work_->left : std::max(work_->left / plane::kShareOfSearch, 1L);
    std::vector<Tried<Answer>> values(boxes.size(), Answer());
    std::vector<plane::SearchWork> works(boxes.size(), {share});
    plane::parallel_for(boxes.size(), [&](std::size_t k) {
      const plane::ScopedSearchWork here(&works[k]);
      values[k] = value_(space::real(boxes[k].of.middle()));
    });
    for (std::size_t k = 0; k < boxes.size() && !refused_; ++k) {
      const long cells = share - works[k].left;
      work_->left -= cells;
      dearest_ = std::max(dearest_, cells);
      add(boxes[k], std::move(values[k]), works[k].spent());
    }
    return boxes.size();
  }

  /// `spent`: it took all cells that it had. Without the first value nothing is known; another leaves its box as it is.
  void add(Box box, Tried<Answer> found, bool spent) {
    ++count_;
    if (!found && (count_ == 1 || !spent)) {
      refused_ = found.refusal();
      return;
    }
    if (found) {
      const bool taken = found->error < exact::kInfinity;  // else it may be nowhere, or greater
      const double value = taken ? found->value.to_double() : exact::kInfinity;
      const double low = taken ? value - found->slack() : found->value.to_double();
      box.bound = low - space::length(box.of.high - box.of.low) / 2;
      if (value < least_ || count_ == 1) {
        least_ = value;
        best_ = *std::move(found);
        best_.at = space::real(box.of.middle());
      }
    }
    queue_.push(box);
  }

  const Value& value_;
  double floor_, tolerance_ = 0, least_ = exact::kInfinity;
  long most_, count_ = 0;
  plane::SearchWork* work_ = nullptr;
  long dearest_ = 1, at_once_ = static_cast<long>(kAtOnce);
  plane::Subdivision<Box> queue_{"boxes of the position with the least value"};
  std::optional<exact::Refusal> refused_;
  Answer best_;
};

}  // namespace

Answer least_taken(const RealVector& at, const Answer& value, const Real& bound) {
  if (value.proven) {
    const Real least = std::min(value.value, bound);
    return least_answer(value.value, least, least == value.value, at);
  }
  Answer out = least_answer(value.value, bound, false, at);
  out.enclosed->upper = value.bounds().upper;
  return out;
}

Tried<Answer> least_in_box(const Value& value, const Vector& low, const Vector& high, double floor, int most) {
  return BoxSearch(value, floor, most).run(low, high);
}

namespace {

/// The unit vector along which the distance at p grows: from what p, or a point of B, is so far from.
std::optional<Vector> direction(const Answer& v, const RealVector& p) {
  RealVector way;
  if (!v.witness.empty())
    way = space::minus(v.witness[0].at, v.witness[1].at);
  else if (v.farthest || v.nearest)
    way = space::minus(p, v.farthest ? *v.farthest : *v.nearest);
  const Vector w = space::rounded(way);
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
    const plane::SearchQuestion question;
    double bound = -exact::kInfinity;
    for (long k = 0; k < plane::allowed(kMostTangents) && !question.work().spent() &&
                     !(least_ - bound <= margin::kTangentsMeet * size_ + off());
         ++k) {
      if (!add_tangent()) break;
      const LpBound lowest = bounding_lp(columns_, std::nullopt);
      bound = -lowest.value - margin::kTangentNoise * size_;
      Vector to{};
      for (std::size_t c = 0; c < 4; ++c) to = space::plus(to, space::scaled(lowest.rows[c], corners_[c]));
      // Between the best and the lowest: where tangents are nearly level the lowest is anywhere.
      const Vector best = space::rounded(best_.at);
      next_ = space::plus(best, space::scaled(k % 4 == 3 ? 1.0 : 0.3, to - best));
    }
    if (refused_) return *refused_;
    if (least_ - bound > margin::kTangentsApart * size_ + off()) return std::nullopt;
    offer_near();
    if (refused_) return *refused_;
    return least_taken(best_.at, best_, Real::from_double(bound));
  }

 private:
  /// What the best value, and tangents like its own, may be off.
  double off() const { return best_.proven ? 0 : 2 * best_.error; }

  bool add_tangent() {
    const RealVector p = space::real(next_);
    const exact::Tried<Answer> found = value_(p);
    if (!found) {
      refused_ = found.refusal();
      return false;
    }
    const Answer& v = *found;
    if (!(v.error < exact::kInfinity)) return false;
    const double value = v.value.to_double();
    if (value < least_) {
      least_ = value;
      take(v, p);
    }
    const auto along = direction(v, p);
    if (!along) return false;
    std::array<double, 4> column{};
    for (std::size_t c = 0; c < 4; ++c) column[c] = v.error - value - space::dot(*along, corners_[c] - next_);
    columns_.push_back(column);
    return true;
  }

  /// A position in whole steps may well be the true one.
  void offer_near() {
    RealVector even = best_.at;
    for (Real& c : even) c = Real(exact::round(c));
    const exact::Tried<Answer> v = value_(even);
    if (!v) {
      refused_ = v.refusal();
    } else if (v->value <= best_.value + Real::from_double(margin::kNoBetter * size_)) {
      take(*v, even);
    }
  }

  void take(const Answer& v, const RealVector& at) {
    best_ = v;
    best_.at = at;
  }

  const ConvexValue& value_;
  double size_, least_ = exact::kInfinity;
  std::array<Vector, 4> corners_;  // of a tetrahedron about the box
  Vector next_;
  std::vector<std::array<double, 4>> columns_;
  std::optional<exact::Refusal> refused_;
  Answer best_;
};

}  // namespace

TriedAnswer convex_least(const ConvexValue& value, const Vector& low, const Vector& high) {
  return TangentSearch(value, low, high).run();
}

}  // namespace findspace::distance
