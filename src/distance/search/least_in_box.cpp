// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/search/least_in_box.h"

#include <algorithm>
#include <utility>

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

}  // namespace findspace::distance
