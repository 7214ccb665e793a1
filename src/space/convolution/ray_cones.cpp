// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/convolution/ray_cones.h"

#include <algorithm>
#include <numeric>

#include "exact/margins/space.h"
#include "space/polytope/vector.h"

namespace findspace::space {
namespace {

using exact::Approx3;

constexpr double kHalfTurn = 3.125;  // below pi: all cones beyond meet
constexpr double kNarrow = 1.5;      // caps above this count as full: short arcs stay in caps below a hemisphere

double angle_between(const Approx3& a, const Approx3& b) { return std::acos(std::clamp(dot(a, b), -1.0, 1.0)); }

Cone around(const Approx3& sum) {
  const double size = std::sqrt(dot(sum, sum));
  if (!(size > margin::kWiderCone)) return {{0, 0, 1}, kFullCone};
  return {{sum.x / size, sum.y / size, sum.z / size}, 0};
}

}  // namespace

Approx3 unit(const Approx3& v) {
  const double size = std::sqrt(dot(v, v));
  return {v.x / size, v.y / size, v.z / size};
}

Cone cone_of(std::span<const Approx3> units) {
  Approx3 sum;
  for (const Approx3& u : units) sum = {sum.x + u.x, sum.y + u.y, sum.z + u.z};
  Cone cone = around(sum);
  for (const Approx3& u : units) cone.angle = std::max(cone.angle, angle_between(cone.axis, u) + margin::kWiderCone);
  if (cone.angle > kNarrow) cone.angle = kFullCone;
  return cone;
}

bool ConeTree::may_meet(const Cone& a, const Cone& b) {
  const double reach = a.angle + b.angle + margin::kWiderCone;
  return reach >= kHalfTurn || dot(a.axis, b.axis) >= std::cos(reach) - margin::kWiderCone;
}

ConeTree::ConeTree(std::vector<Cone> cones) : cones_(std::move(cones)) {
  order_.resize(cones_.size());
  std::iota(order_.begin(), order_.end(), 0);
  if (cones_.empty()) return;
  nodes_.emplace_back();
  build(0, 0, static_cast<int>(cones_.size()));
  std::vector<Cone> sorted;
  for (const int i : order_) sorted.push_back(cones_[i]);
  cones_ = std::move(sorted);
}

void ConeTree::build(int node, int first, int count) {
  const auto begin = order_.begin() + first, end = begin + count;
  Approx3 sum, low{2, 2, 2}, high{-2, -2, -2};
  for (auto i = begin; i != end; ++i) {
    const Approx3& a = cones_[*i].axis;
    sum = {sum.x + a.x, sum.y + a.y, sum.z + a.z};
    low = {std::min(low.x, a.x), std::min(low.y, a.y), std::min(low.z, a.z)};
    high = {std::max(high.x, a.x), std::max(high.y, a.y), std::max(high.z, a.z)};
  }
  Cone cone = around(sum);
  for (auto i = begin; i != end; ++i) {
    cone.angle =
        std::max(cone.angle, angle_between(cone.axis, cones_[*i].axis) + cones_[*i].angle + margin::kWiderCone);
  }
  nodes_[node].cone = cone;
  if (count <= 4) {
    nodes_[node].first = first;
    nodes_[node].count = count;
    return;
  }
  const Approx3 size = high - low;
  const auto key = [&](int i) {
    const Approx3& a = cones_[i].axis;
    return size.x >= size.y && size.x >= size.z ? a.x : size.y >= size.z ? a.y : a.z;
  };
  const int half = count / 2;
  std::nth_element(begin, begin + half, end, [&](int i, int j) { return std::pair(key(i), i) < std::pair(key(j), j); });
  const int children = static_cast<int>(nodes_.size());
  nodes_[node].first = children;
  nodes_.resize(nodes_.size() + 2);
  build(children, first, half);
  build(children + 1, first + half, count - half);
}

}  // namespace findspace::space
