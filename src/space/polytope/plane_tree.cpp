// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/polytope/plane_tree.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace findspace::space {

namespace {

constexpr std::size_t kPlaneLeaf = 4;

}  // namespace

PlaneTree::PlaneTree(std::span<const HalfSpace> planes) {
  for (const HalfSpace& h : planes) planes_.push_back({h.unit, h.shift});
  if (!planes_.empty()) build(0, planes_.size());
}

void PlaneTree::build(std::size_t first, std::size_t last) {
  const auto four = [](const Plane& p) { return Four{p.unit.x, p.unit.y, p.unit.z, p.shift}; };
  const auto begin = planes_.begin() + static_cast<std::ptrdiff_t>(first),
             end = planes_.begin() + static_cast<std::ptrdiff_t>(last);
  Node made{four(*begin), four(*begin), first, last, 0};
  for (auto p = begin; p != end; ++p) {
    const Four at = four(*p);
    for (std::size_t c = 0; c < 4; ++c) {
      made.low[c] = std::min(made.low[c], at[c]);
      made.high[c] = std::max(made.high[c], at[c]);
    }
  }
  const std::size_t at = nodes_.size();
  nodes_.push_back(made);
  if (last - first <= kPlaneLeaf) return;
  // By normals: planes of a convex solid with normals nearby are at distances nearby.
  std::size_t axis = 0;
  for (const std::size_t c : {1, 2}) {
    if (made.high[c] - made.low[c] > made.high[axis] - made.low[axis]) axis = c;
  }
  const std::size_t half = (first + last) / 2;
  std::nth_element(begin, planes_.begin() + static_cast<std::ptrdiff_t>(half), end,
                   [&](const Plane& p, const Plane& q) { return four(p)[axis] < four(q)[axis]; });
  build(first, half);
  nodes_[at].right = nodes_.size();
  build(half, last);
}

/// No plane of the node has more at x.
double PlaneTree::Node::most(const Vector& x) const {
  return std::max(low[0] * x.x, high[0] * x.x) + std::max(low[1] * x.y, high[1] * x.y) +
         std::max(low[2] * x.z, high[2] * x.z) + high[3];
}

const PlaneTree::Plane& PlaneTree::farthest_beyond(const Vector& x) const {
  std::vector<std::pair<std::size_t, double>> stack;
  stack.reserve(64);
  stack.emplace_back(0, nodes_[0].most(x));
  const Plane* best = &planes_[0];
  double value = best->beyond(x);
  while (!stack.empty()) {
    const auto [at, most] = stack.back();
    stack.pop_back();
    if (most < value) continue;
    const Node& node = nodes_[at];
    if (node.right != 0) {
      std::pair<std::size_t, double> one{at + 1, nodes_[at + 1].most(x)}, two{node.right, nodes_[node.right].most(x)};
      if (one.second > two.second) std::swap(one, two);
      stack.push_back(one);
      stack.push_back(two);
      continue;
    }
    for (std::size_t k = node.first; k < node.last; ++k) {
      const double next = planes_[k].beyond(x);
      if (!(next > value)) continue;
      value = next;
      best = &planes_[k];
    }
  }
  return *best;
}

}  // namespace findspace::space
