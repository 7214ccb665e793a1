// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/polytope/extent_tree.h"

namespace findspace::space {

namespace {

constexpr std::size_t kLeaf = 6;

/// Twice the middle of the box.
Vector middle(const Extent& e) { return plus(e.low, e.high); }

double coordinate(const Vector& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

}  // namespace

ExtentTree::ExtentTree(std::vector<Extent> extents) : extents_(std::move(extents)) {
  for (std::size_t k = 0; k < extents_.size(); ++k) (extents_[k].bounded() ? order_ : unbounded_).push_back(k);
  if (!order_.empty()) build(0, order_.size());
}

void ExtentTree::build(std::size_t first, std::size_t last) {
  const std::size_t at = nodes_.size();
  nodes_.push_back({extents_[order_[first]], first, last, 0});
  Extent middles{middle(extents_[order_[first]]), middle(extents_[order_[first]])};
  for (std::size_t i = first; i < last; ++i) {
    nodes_[at].around.add(extents_[order_[i]]);
    middles.add({middle(extents_[order_[i]]), middle(extents_[order_[i]])});
  }
  if (last - first <= kLeaf) return;
  const Vector spread = middles.high - middles.low;
  const int axis = spread.x >= spread.y && spread.x >= spread.z ? 0 : spread.y >= spread.z ? 1 : 2;
  const auto begin = order_.begin() + static_cast<std::ptrdiff_t>(first);
  const std::size_t half = (first + last) / 2;
  std::nth_element(begin, order_.begin() + static_cast<std::ptrdiff_t>(half),
                   order_.begin() + static_cast<std::ptrdiff_t>(last), [&](std::size_t a, std::size_t b) {
                     return coordinate(middle(extents_[a]), axis) < coordinate(middle(extents_[b]), axis);
                   });
  build(first, half);
  nodes_[at].right = nodes_.size();
  build(half, last);
}

}  // namespace findspace::space
