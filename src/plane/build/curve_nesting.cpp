// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/build/curve_nesting.h"

#include <cmath>

#include "plane/contour/contour.h"
#include "plane/contour/contour_boxes.h"
#include "plane/contour/nesting_depths.h"

namespace findspace::plane {
namespace {

constexpr double kLost = 1;  // grid steps: more than doubles lose of a distance

/// Twice what a curve so near can make of the area of the ring.
double doubtful_area(const RingSketch& ring, std::size_t edges, double bound) {
  return 4 * bound * (ring.length() + 2 * bound * double(edges));
}

Box grown_box(const PieceBox& b, double by) {
  const auto below = [](double v) { return std::int64_t(std::floor(v)); };
  return {below(b.x0 - by), below(b.y0 - by), -below(-b.x1 - by), -below(-b.y1 - by)};
}

}  // namespace

CurveNesting::CurveNesting(std::vector<NearRing> rings, std::function<NearRing(std::size_t)> nearer)
    : nearer_(std::move(nearer)) {
  for (NearRing& near : rings) {
    RingSketch sketch(near.ring);
    const bool exact = near.bound == 0;
    rings_.push_back({std::move(near), std::move(sketch), exact});
  }
}

bool CurveNesting::refine(std::size_t k) {
  if (rings_[k].refined) return false;
  NearRing near = nearer_(k);
  RingSketch sketch(near.ring);
  rings_[k] = {std::move(near), std::move(sketch), true};
  return true;
}

std::optional<int> CurveNesting::orientation(std::size_t k) {
  do {
    const auto& [near, sketch, refined] = rings_[k];
    const double area = sketch.area();
    if (std::abs(area) > doubtful_area(sketch, near.ring.size(), near.bound)) return area > 0 ? 1 : -1;
  } while (refine(k));
  return std::nullopt;
}

std::optional<bool> CurveNesting::goes_round(std::size_t outer, std::size_t inner) const {
  constexpr std::size_t kTries = 16;  // of a ring that can come nearer to its curve
  const auto& [a, sketch, a_refined] = rings_[outer];
  const auto& [b, b_sketch, b_refined] = rings_[inner];
  const double reach = a.bound + b.bound + kLost;
  const PieceBox& box = sketch.box();
  const std::size_t step = a_refined && b_refined ? 1 : b.ring.size() / kTries + 1;
  for (std::size_t k = 0; k < b.ring.size(); k += step) {
    const double x = double(b.ring[k].start.x), y = double(b.ring[k].start.y);
    if (x < box.x0 - reach || x > box.x1 + reach || y < box.y0 - reach || y > box.y1 + reach) return false;
    if (sketch.apart(x, y) > reach) return encloses(a.ring, b.ring[k].start);
  }
  if (a.bound == 0 && b.bound == 0) return !rings_around({a.ring, b.ring})[1].empty();
  return std::nullopt;
}

std::optional<std::vector<std::vector<std::size_t>>> CurveNesting::around() {
  std::vector<Box> boxes;
  for (const Known& ring : rings_) boxes.push_back(grown_box(ring.sketch.box(), ring.near.bound + kLost));
  bool told = true;
  auto all = meeting_others(boxes, [&](std::size_t i, std::size_t j) {
    std::optional<bool> answer = goes_round(j, i);
    if (!answer) {
      const bool inner = refine(i), outer = refine(j);
      if (inner || outer) answer = goes_round(j, i);
    }
    told = told && answer;
    return answer.value_or(false);
  });
  if (!told) return std::nullopt;
  return all;
}

}  // namespace findspace::plane
