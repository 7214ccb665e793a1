// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/convolution/ray_boxes.h"

#include <numeric>

namespace findspace::space {
namespace {

constexpr int kLeaf = 4;

GridBox united(const GridBox& a, const GridBox& b) {
  return {{std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y), std::min(a.low.z, b.low.z)},
          {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y), std::max(a.high.z, b.high.z)}};
}

}  // namespace

BoxTree::BoxTree(const RayBody& body) : order_(body.faces.size()), boxes_(body.faces.size()) {
  std::iota(order_.begin(), order_.end(), 0);
  for (std::size_t f = 0; f < body.faces.size(); ++f) {
    const Point& p = body.corner(static_cast<int>(f), 0);
    boxes_[f] = {p, p};
    for (int k = 1; k < 3; ++k) {
      const Point& q = body.corner(static_cast<int>(f), k);
      boxes_[f] = united(boxes_[f], {q, q});
    }
  }
  nodes_.emplace_back();
  build(0, 0, static_cast<int>(order_.size()));
  std::vector<GridBox> sorted;
  sorted.reserve(boxes_.size());
  for (const int f : order_) sorted.push_back(boxes_[f]);
  boxes_ = std::move(sorted);
}

void BoxTree::build(int node, int first, int count) {
  const auto begin = order_.begin() + first, end = begin + count;
  GridBox box = boxes_[*begin];
  for (auto i = begin; i != end; ++i) box = united(box, boxes_[*i]);
  nodes_[node].box = box;
  if (count <= kLeaf) {
    nodes_[node].first = first;
    nodes_[node].count = count;
    return;
  }
  const Point size = box.high - box.low;
  const auto key = [&](int f) {
    const GridBox& b = boxes_[f];
    const std::int64_t twice = size.x >= size.y && size.x >= size.z ? b.low.x + b.high.x
                               : size.y >= size.z                   ? b.low.y + b.high.y
                                                                    : b.low.z + b.high.z;
    return std::pair(twice, f);
  };
  std::nth_element(begin, begin + count / 2, end, [&](int f, int g) { return key(f) < key(g); });
  const int children = static_cast<int>(nodes_.size());
  nodes_[node].first = children;
  nodes_.resize(nodes_.size() + 2);
  build(children, first, count / 2);
  build(children + 1, first + count / 2, count - count / 2);
}

}  // namespace findspace::space
