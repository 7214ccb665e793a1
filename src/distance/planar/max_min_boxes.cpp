// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/planar/max_min_boxes.h"

#include <cmath>
#include <mutex>

#include "exact/margins/planar_distance.h"
#include "plane/query/locate.h"

namespace findspace::distance {

using exact::Real;
using plane::Index;
using plane::kNone;

namespace {

constexpr std::size_t kMostKept = 1 << 19;

}  // namespace

MaxMinBoxes::MaxMinBoxes(const FeatureTree& a) : a_(a), slack_(a.scale() * margin::kSameNumber) {
  if (a.empty()) return;
  const FeatureBox& box = a.nodes()[0].box;
  corner_ = {box.x0, box.y0};
  size_ = std::max(box.x1 - box.x0, box.y1 - box.y0);
}

double MaxMinBoxes::half(const Part& part) const { return std::ldexp(size_, -part.level - 1); }

Spot MaxMinBoxes::middle(const Part& part) const {
  const double half = this->half(part);
  return {corner_.x + half * double(2 * part.column + 1), corner_.y + half * double(2 * part.row + 1)};
}

MaxMinBoxes::Look MaxMinBoxes::look(const Part& part, Index guess) const {
  {
    std::shared_lock lock(guard_);
    if (auto known = known_.find(part); known != known_.end()) return known->second;
  }
  const Look found = looked(part, guess);
  std::unique_lock lock(guard_);
  if (known_.size() < kMostKept) known_.emplace(part, found);
  return found;
}

MaxMinBoxes::Look MaxMinBoxes::looked(const Part& part, Index guess) const {
  const Spot at = middle(part);
  const double radius = half(part) * std::sqrt(2.0);
  const auto near = a_.nearest(at.x, at.y, guess);
  const bool inside = in_set(at, near);
  const bool clear = inside ? near.distance >= radius : near.distance > radius && can_grow(at, near, radius);
  return {near, inside, clear || few_features(at, near.distance + 2 * radius + slack_)};
}

bool MaxMinBoxes::in_set(Spot at, const FeatureTree::Near& near) const {
  if (auto in = a_.contains(at.x, at.y, near)) return *in;
  return near.distance <= slack_ ||
         mark_of(a_.region(), locate(a_.region(), {Real::from_double(at.x), Real::from_double(at.y)})) > 0;
}

/// At most two parts of A can be nearest around `middle`: distances to two convex parts have no strict maximum
/// together.
bool MaxMinBoxes::few_features(Spot middle, double reach) const {
  int count = 0;
  a_.for_near(middle.x, middle.y, reach, [&](Index) { return ++count < 3; });
  return count < 3;
}

/// Whether the distance to A grows in one direction from every place within `radius` of `middle`, so that none is a
/// local maximum.
bool MaxMinBoxes::can_grow(Spot middle, const FeatureTree::Near& near, double radius) const {
  const BoundaryFeature& s = a_.features()[near.feature];
  double ux = middle.x - s.x0, uy = middle.y - s.y0;
  if (!s.is_vertex() && s.faces(middle.x, middle.y)) {
    double dx = s.x1 - s.x0, dy = s.y1 - s.y0;
    double side = (middle.y - s.y0) * dx - (middle.x - s.x0) * dy > 0 ? 1 : -1;
    ux = -dy * side;
    uy = dx * side;
  } else if (!s.is_vertex() && plain_length(middle.x - s.x1, middle.y - s.y1) < plain_length(ux, uy)) {
    ux = middle.x - s.x1;
    uy = middle.y - s.y1;
  }
  double n = plain_length(ux, uy), reach = near.distance + 2 * radius + slack_;
  ux /= n;
  uy /= n;
  double level = ux * middle.x + uy * middle.y - radius - slack_;
  auto height = [&](double x, double y) { return ux * x + uy * y - level; };
  std::vector<Index> stack{0};
  while (!stack.empty()) {
    Index at = stack.back();
    stack.pop_back();
    const FeatureTree::Node& node = a_.nodes()[at];
    if (height(ux > 0 ? node.box.x1 : node.box.x0, uy > 0 ? node.box.y1 : node.box.y0) < 0) continue;
    if (node.box.nearest_squared(middle.x, middle.y) > reach * reach) continue;
    if (node.right != kNone) {
      stack.insert(stack.end(), {node.right, at + 1});
      continue;
    }
    for (Index k = node.first; k < node.last; ++k) {
      BoundaryFeature part = a_.features()[k];
      double h0 = height(part.x0, part.y0), h1 = height(part.x1, part.y1);
      if (h0 < 0 && h1 < 0) continue;
      if (h0 < 0 || h1 < 0) {
        double t = h0 / (h0 - h1), x = part.x0 + t * (part.x1 - part.x0), y = part.y0 + t * (part.y1 - part.y0);
        (h0 < 0 ? part.x0 : part.x1) = x, (h0 < 0 ? part.y0 : part.y1) = y;
      }
      if (part.distance(middle.x, middle.y) <= reach) return false;
    }
  }
  return true;
}

}  // namespace findspace::distance
