// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/solid_search/solid_mover.h"

#include <algorithm>
#include <limits>

#include "exact/margins/packing.h"

namespace findspace::packing {
namespace {

constexpr int kSolidSpread = 20, kSolidAbout = 10;  // positions at random
constexpr double kAboutReach = 0.3;                 // of the solid's box
constexpr int kMostRounds = 8;                      // over the axes
constexpr int kMostSlides = 4;
constexpr std::size_t kMostTouches = 3;
constexpr double kSolidFar = std::numeric_limits<double>::infinity();
constexpr std::array<Vector, 3> kAxes{Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}};

}  // namespace

/// Keeps the best few.
void SolidMover::offer(std::size_t item, const SolidPose& pose) {
  const double bound = count_ < kKept ? kSolidFar : kept_[count_ - 1].cost;
  const double cost = a_.cost(item, pose, bound);
  if (!(cost < bound)) return;
  std::size_t k = count_ < kKept ? count_++ : count_ - 1;
  for (; k > 0 && cost < kept_[k - 1].cost; --k) kept_[k] = kept_[k - 1];
  kept_[k] = {pose, cost};
}

void SolidMover::sample(std::size_t item, const Candidate& here) {
  kept_[0] = here;
  count_ = 1;
  const SolidPose now = here.pose;
  for (int k = 0; k < kSolidSpread; ++k) {
    const std::size_t v = random_variant(item);
    offer(item, {v, a_.random_position(v, random_)});
  }
  const SolidVariant& shape = a_.table().variants()[now.variant];
  const Vector middle = now.at + 0.5 * (shape.low + shape.high), reach = kAboutReach * (shape.high - shape.low);
  for (int k = 0; k < kSolidAbout; ++k) {
    const std::size_t v = random_variant(item);
    const SolidVariant& w = a_.table().variants()[v];
    const double x = random_.between(-reach.x, reach.x), y = random_.between(-reach.y, reach.y);
    const Vector off{x, y, random_.between(-reach.z, reach.z)};
    offer(item, {v, a_.inside(v, middle - 0.5 * (w.low + w.high) + off)});
  }
}

std::size_t SolidMover::random_variant(std::size_t item) {
  const auto& variants = a_.table().variants_of(a_.table().variants()[a_.pose(item).variant].part);
  return variants[variants.size() == 1 ? 0 : random_.below(variants.size())];
}

bool SolidMover::go_along(std::size_t item, Candidate& c, const Vector& way) {
  const SolidArrangement::LinePlace place = a_.best_on_line(item, c.pose, way, c.cost, random_.below(2) == 1);
  if (!(place.cost < c.cost)) return false;
  c = {{c.pose.variant, a_.inside(c.pose.variant, c.pose.at + place.t * way)}, place.cost};
  return true;
}

void SolidMover::descend(std::size_t item, Candidate& c) {
  std::size_t axis = random_.below(3);
  const std::size_t turn = 1 + random_.below(2);
  int idle = 0;
  for (int k = 0; k < 3 * kMostRounds && idle < 3 && c.cost > 0; ++k) {
    idle = go_along(item, c, kAxes[axis]) ? 0 : idle + 1;
    axis = (axis + turn) % 3;
  }
}

bool SolidMover::slide(std::size_t item, Candidate& c) {
  a_.touches(item, c.pose, touches_);
  const auto dearer = [](const auto& a, const auto& b) { return a.cost > b.cost; };
  std::stable_sort(touches_.begin(), touches_.end(), dearer);
  touches_.resize(std::min(touches_.size(), kMostTouches));
  const std::vector<SolidArrangement::Touch> touches = touches_;
  bool better = false;
  for (std::size_t k = 0; k < touches.size() && c.cost > 0; ++k) {
    if (touches[k].cost > 0) better |= go_along(item, c, touches[k].normal);
    for (std::size_t l = 0; l < k && c.cost > 0; ++l) {
      const Vector way = space::cross(touches[k].normal, touches[l].normal);
      const double size = space::length(way);
      if (size > margin::kSolidContact) better |= go_along(item, c, (1 / size) * way);
    }
  }
  return better;
}

void SolidMover::improve(std::size_t item) {
  const Candidate now{a_.pose(item), a_.cost(item, a_.pose(item), kSolidFar)};
  if (now.cost <= 0) return;
  sample(item, now);
  Candidate best = now;
  for (std::size_t k = 0; k < count_; ++k) {
    descend(item, kept_[k]);
    if (kept_[k].cost < best.cost) best = kept_[k];
    if (best.cost <= 0) break;
  }
  if (!(best.cost < now.cost))
    for (int k = 0; k < kMostSlides && best.cost > 0 && slide(item, best); ++k) descend(item, best);
  if (best.cost < now.cost) a_.move(item, best.pose);
}

}  // namespace findspace::packing
