// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/surface/contact_boxes.h"

#include "distance/search/boundary_cells.h"
#include "exact/margins/space_distance.h"

namespace findspace::distance {

using space::HalfSpace;
using space::Plane;
using space::Vector;

namespace {

/// Planes of a box, and pairs of triangles looked through for them.
constexpr std::size_t kFewPlanes = 40, kFewPairs = 1000;
/// The same where they may pass through one place, as in an exact fit, which is tried every so many divisions.
constexpr std::size_t kManyPlanes = 2000, kManyPairs = 400000, kPairsEarly = 20000;
constexpr int kOften = 7, kEarly = 12;

std::vector<HalfSpace> half_spaces(const std::vector<Plane>& planes) { return {planes.begin(), planes.end()}; }

}  // namespace

ContactBoxes::ContactBoxes(const space::SurfaceSet& b, const space::SurfaceSet& a, space::TouchSide side)
    : overlap_(*a.sheets()[0], *b.sheets()[0], side == space::TouchSide::kInside),
      planes_(overlap_.a(), a.sheets()[0]->tree, overlap_.b(), b.sheets()[0]->tree),
      depths_(b, a, side) {
  const auto approx = [](const space::Point& v) { return exact::approx(v); };
  const bool inside = side == space::TouchSide::kInside;
  const space::RayBody &of_a = overlap_.a(), &of_b = overlap_.b();
  const Vector low = approx(inside ? of_a.low - of_b.low : of_a.low - of_b.high),
               high = approx(inside ? of_a.high - of_b.high : of_a.high - of_b.low);
  // The bodies may be as large as each other: some more room for rounding.
  const double tolerance = margin::kAroundContacts * space::length(approx(of_b.high - of_b.low));
  const auto complete =
      askew(low - Vector{tolerance, tolerance, tolerance}, space::plus(high, {tolerance, tolerance, tolerance}));
  size_ = space::length(complete.first) + space::length(complete.second) + depths_.size();
  // B's box may be larger than A's: then B lies in A nowhere.
  const Vector wide = complete.second - complete.first;
  const bool none = wide.x < 0 || wide.y < 0 || wide.z < 0;
  boxes_.push_back({{complete.first, complete.second}, 0, none ? State::kOverlap : State::kNew, -1, {}});
}

const ContactBoxes::Box& ContactBoxes::look(int k) {
  Box& box = boxes_[static_cast<std::size_t>(k)];
  if (box.state != State::kNew) return box;
  const Vector middle = box.of.middle();
  const double half = space::length(box.half());
  if (depths_.deeper(middle, half + margin::kDepthNoise * size_, likely_)) {
    box.state = State::kOverlap;
  } else if (const auto planes = planes_.near(middle, half, kFewPlanes, kFewPairs)) {
    box.state = State::kPlanes;
    box.planes = half_spaces(*planes);
  } else if (tiny(box) || box.level % kOften == kOften - 1) {
    box.state = State::kMany;
  } else {
    divide(k);
  }
  return box;
}

std::optional<std::vector<HalfSpace>> ContactBoxes::many_planes(int k) const {
  const Box& box = boxes_[static_cast<std::size_t>(k)];
  const std::size_t pairs = box.level > kEarly ? kManyPairs : kPairsEarly;
  const auto planes = planes_.near(box.of.middle(), space::length(box.half()), kManyPlanes, pairs);
  if (!planes) return std::nullopt;
  return half_spaces(*planes);
}

void ContactBoxes::divide(int k) {
  Box& box = boxes_[static_cast<std::size_t>(k)];
  box.state = State::kDivided;
  box.first = static_cast<int>(boxes_.size());
  for (int part = 0; part < 8; ++part) boxes_.push_back({box.of.eighth(part), box.level + 1, State::kNew, -1, {}});
}

}  // namespace findspace::distance
