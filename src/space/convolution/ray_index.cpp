// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The local index of a solid at a vertex w in direction n: 1 - chi(L above), L the link of w (a region of the small
// sphere) and "above" the open hemisphere about n. The frontier of L is the circuit of edges; seen from outside the
// sphere L lies on its right. It crosses the great circle across n in 2s points, which cut the hemisphere into s + 1
// regions: for s = 1 one of them is in L, and the index is 0; for more, the ones in L are counted from the order of the
// points along the circle.
#include <algorithm>
#include <numeric>
#include <span>

#include "space/convolution/ray_convolution.h"

namespace findspace::space {
namespace {

/// One place where the circuit crosses the great circle: in the corner whose face has normal `normal`, upward or
/// downward.
struct Crossing {
  const Wide3* normal = nullptr;
  bool up = false;
};

/// The direction n as the moved bodies see it, with the signs that need more than one edge.
struct Circle {
  const Wide3& n;
  int tie;

  /// + if the crossing q follows p within less than half a turn, counter-clockwise about n; 0 if they are opposite. The
  /// crossing lies along n x m, or against it where it goes down, and (n x m) x (n x m') . n has the sign of n x m .
  /// m'.
  int turn(const Crossing& p, const Crossing& q) const {
    int s = exact::sign_triple(n, *p.normal, *q.normal);
    if (s == 0) s = tie * exact::lexicographic_sign(n) * exact::lexicographic_sign_cross(*p.normal, *q.normal);
    return p.up == q.up ? s : -s;
  }
  /// Whether p, q, r come in this order, counter-clockwise.
  bool in_order(const Crossing& p, const Crossing& q, const Crossing& r) const {
    return (turn(p, q) > 0) + (turn(q, r) > 0) + (turn(r, p) > 0) >= 2;
  }
};

/// The number of regions of L above, from the crossings in the order of the circuit: those joined by the frontier above
/// (from each upward crossing to the next) and those joined by the circle (from each upward crossing
/// counter-clockwise).
int regions_above(std::span<const Crossing> crossings, const Circle& circle) {
  const int n = static_cast<int>(crossings.size());
  std::vector<int> order(n);
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin() + 1, order.end(),
            [&](int i, int j) { return i != j && circle.in_order(crossings[0], crossings[i], crossings[j]); });
  std::vector<int> root(n);
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&](int i) {
    while (root[i] != i) i = root[i];
    return i;
  };
  int regions = n;
  const auto join = [&](int i, int j) {
    const int a = find(i), b = find(j);
    if (a == b) return;
    root[a] = b;
    --regions;
  };
  for (int i = 0; i < n; ++i) {
    if (crossings[i].up) join(i, (i + 1) % n);
    if (crossings[order[i]].up) join(order[i], order[(i + 1) % n]);
  }
  return regions;
}

Point edge(const RayBody& body, const RayVertex& v, int j) {
  return body.points[body.corners[v.first + j % v.count].to] - body.points[v.point];
}

/// For a circuit all on one side of n: whether the solid is the smaller part, inside the cone of its edges. Decided at
/// an extreme edge of that cone, which has the others strictly between two planes through it: it is convex, or reflex.
bool solid_in_cone(const RayBody& body, const RayVertex& v) {
  const Point origin{};
  for (int j = 0; j < v.count; ++j) {
    const Point e = edge(body, v, j);
    const auto side = [&](const Point& p, const Point& q) { return exact::sign_volume(origin, e, p, q); };
    Point right = edge(body, v, j + 1), left = right;
    for (int k = 2; k < v.count; ++k) {
      const Point p = edge(body, v, j + k);
      if (side(right, p) < 0) right = p;
      if (side(left, p) > 0) left = p;
    }
    bool extreme = side(right, left) > 0;
    for (int k = 1; extreme && k < v.count; ++k) {
      const Point p = edge(body, v, j + k);
      extreme = side(right, p) >= 0 && side(p, left) >= 0;
    }
    if (!extreme) continue;
    const Point before = edge(body, v, j + v.count - 1), after = edge(body, v, j + 1);
    const int bend = side(before, after);
    // The solid is what lies counter-clockwise from `before` to `after` about e: less than half a turn iff convex.
    if (bend != 0) return bend > 0;
  }
  return true;  // the cone holds a line: then its edges are never all on one side
}

}  // namespace

int local_index(const RayBody& body, const RayVertex& vertex, const Wide3& n, const Approx3& n_approx, int tie) {
  constexpr int kFew = 64;
  Crossing few[kFew];
  int count = 0, ups = 0, last = 0, first = 0;
  const auto above = [&](int j) {
    const Point e = edge(body, vertex, j);
    const int s = exact::sign_dot(n, n_approx, e);
    return s != 0 ? s : tie * exact::lexicographic_sign(n) * exact::lexicographic_sign(e);
  };
  std::vector<Crossing> many;
  first = last = above(0);
  ups += first > 0;
  for (int j = 1; j <= vertex.count; ++j) {
    const int s = j < vertex.count ? above(j) : first;
    if (j < vertex.count) ups += s > 0;
    if (s == last) continue;
    const Crossing crossing{&body.normals[body.corners[vertex.first + j - 1].face], s > 0};
    if (count < kFew) few[count] = crossing;
    if (count >= kFew) {
      if (many.empty()) many.assign(few, few + kFew);
      many.push_back(crossing);
    }
    ++count;
    last = s;
  }
  if (count == 2) return 0;
  if (count == 0) {
    const bool in_cone = solid_in_cone(body, vertex);
    return (ups == 0) == in_cone ? 1 : 0;
  }
  const std::span<const Crossing> crossings = many.empty() ? std::span<const Crossing>(few, count) : many;
  return 1 - regions_above(crossings, {n, tie});
}

}  // namespace findspace::space
