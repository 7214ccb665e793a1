// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/polytope/triangulate.h"

#include <findspace/error.h>

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <numeric>
#include <optional>
#include <queue>
#include <utility>

namespace findspace::space {
namespace {

int turn(const Point2& a, const Point2& b, const Point2& c) {
  return exact::sign(int128(b.x - a.x) * (c.y - a.y) - int128(b.y - a.y) * (c.x - a.x));
}

int128 twice_area(std::span<const Point2> ring) {
  int128 sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
    sum += int128(a.x) * b.y - int128(a.y) * b.x;
  }
  return sum;
}

/// Whether p, which is none of the corners, lies in the closed triangle a b c.
bool blocks(const Point2& p, const Point2& a, const Point2& b, const Point2& c) {
  if (p == a || p == b || p == c) return false;
  return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
}

/// The corners of a ring in a tree of boxes, from which they are taken out one by one.
class CornerTree {
 public:
  explicit CornerTree(std::span<const Point2> ring)
      : ring_(ring), order_(ring.size()), leaf_(ring.size()), out_(ring.size()) {
    std::iota(order_.begin(), order_.end(), 0);
    if (!order_.empty()) build(0, int(order_.size()), kNone);
  }

  void take_out(int v) {
    out_[std::size_t(v)] = true;
    for (int k = leaf_[std::size_t(v)]; k != kNone; k = nodes_[std::size_t(k)].parent) --nodes_[std::size_t(k)].left;
  }

  /// One that blocks the triangle; -1 where none does.
  int blocker(const Point2& a, const Point2& b, const Point2& c) const { return blocker(0, a, b, c); }

 private:
  static constexpr int kNone = -1, kLeaf = 16;
  struct Node {
    Point2 low, high;
    int first, end, left, parent, below = kNone, beside = kNone;  // `left`: not taken out
  };

  int blocker(int at, const Point2& a, const Point2& b, const Point2& c) const {
    const Node& node = nodes_[std::size_t(at)];
    if (node.left == 0 || beyond(node, a, b) || beyond(node, b, c) || beyond(node, c, a)) return kNone;
    if (node.below != kNone) {
      const int found = blocker(node.below, a, b, c);
      return found == kNone ? blocker(node.beside, a, b, c) : found;
    }
    for (int i = node.first; i < node.end; ++i) {
      const int v = order_[std::size_t(i)];
      if (!out_[std::size_t(v)] && blocks(ring_[std::size_t(v)], a, b, c)) return v;
    }
    return kNone;
  }

  /// Whether the whole box lies to the right of the line from a to b.
  static bool beyond(const Node& n, const Point2& a, const Point2& b) {
    return turn(a, b, {b.y >= a.y ? n.low.x : n.high.x, b.x >= a.x ? n.high.y : n.low.y}) < 0;
  }

  int build(int first, int end, int parent) {
    const auto begin = order_.begin();
    Point2 low = ring_[std::size_t(order_[std::size_t(first)])], high = low;
    for (int i = first; i < end; ++i) {
      const Point2& p = ring_[std::size_t(order_[std::size_t(i)])];
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    const int at = int(nodes_.size());
    nodes_.push_back({low, high, first, end, end - first, parent});
    if (end - first <= kLeaf) {
      for (int i = first; i < end; ++i) leaf_[std::size_t(order_[std::size_t(i)])] = at;
      return at;
    }
    const bool wide = high.x - low.x >= high.y - low.y;
    const int middle = first + (end - first) / 2;
    std::nth_element(begin + first, begin + middle, begin + end, [&](int v, int w) {
      const Point2 &p = ring_[std::size_t(v)], &q = ring_[std::size_t(w)];
      return wide ? p.x < q.x : p.y < q.y;
    });
    const int below = build(first, middle, at), beside = build(middle, end, at);
    nodes_[std::size_t(at)].below = below;
    nodes_[std::size_t(at)].beside = beside;
    return at;
  }

  std::span<const Point2> ring_;
  std::vector<int> order_, leaf_;
  std::vector<bool> out_;
  std::vector<Node> nodes_;
};

/// Cuts off the ears of a ring: each time the first corner in which nothing blocks. What cannot be one waits until a
/// neighbour is cut off, or the corner that blocks it.
class Ears {
 public:
  explicit Ears(std::span<const Point2> ring) : ring_(ring), tree_(ring), corners_(ring.size()), left_(ring.size()) {
    const int n = int(ring.size());
    std::vector<int> all(ring.size());
    std::iota(all.begin(), all.end(), 0);
    for (const int v : all) corners_[std::size_t(v)] = {(v + n - 1) % n, (v + 1) % n};
    unsure_ = decltype(unsure_)(std::greater<>(), std::move(all));
  }

  struct Ear {
    std::array<int, 3> corners;
    bool straight;
  };
  std::optional<Ear> next() {
    while (left_ >= 3 && !unsure_.empty()) {
      const int v = unsure_.top();
      unsure_.pop();
      if (corners_[std::size_t(v)].cut) continue;
      const int before = corners_[std::size_t(v)].before, after = corners_[std::size_t(v)].after;
      const Point2 &a = ring_[std::size_t(before)], &b = ring_[std::size_t(v)], &c = ring_[std::size_t(after)];
      const int corner = turn(a, b, c);
      if (corner < 0) continue;
      const int blocker = corner == 0 ? kNone : tree_.blocker(a, b, c);
      if (blocker != kNone) {
        wait(v, blocker);
        continue;
      }
      cut_off(v);
      return Ear{{before, v, after}, corner == 0};
    }
    return std::nullopt;
  }

 private:
  static constexpr int kNone = -1;
  struct Corner {
    int before, after;
    int waiting = kNone;  // the first of `waits_` for it to be cut off
    bool cut = false;
  };
  struct Wait {
    int corner, next;
  };

  void wait(int v, int blocker) {
    Corner& corner = corners_[std::size_t(blocker)];
    waits_.push_back({v, corner.waiting});
    corner.waiting = int(waits_.size()) - 1;
  }

  void cut_off(int v) {
    Corner& corner = corners_[std::size_t(v)];
    corners_[std::size_t(corner.before)].after = corner.after;
    corners_[std::size_t(corner.after)].before = corner.before;
    corner.cut = true;
    tree_.take_out(v);
    --left_;
    unsure_.push(corner.before);
    unsure_.push(corner.after);
    for (int k = corner.waiting; k != kNone; k = waits_[std::size_t(k)].next)
      unsure_.push(waits_[std::size_t(k)].corner);
  }

  std::span<const Point2> ring_;
  CornerTree tree_;
  std::vector<Corner> corners_;
  std::vector<Wait> waits_;
  std::size_t left_;
  std::priority_queue<int, std::vector<int>, std::greater<>> unsure_;  // all others are cut off, or no ears
};

/// Whether segments p q and a b cross or touch, other than in ends that are equal.
bool meet(const Point2& p, const Point2& q, const Point2& a, const Point2& b) {
  if (a == p || a == q || b == p || b == q) return false;
  const int s = turn(p, q, a), t = turn(p, q, b), u = turn(a, b, p), v = turn(a, b, q);
  if (s == 0 && t == 0) {
    return std::max(std::min(p, q), std::min(a, b)) <= std::min(std::max(p, q), std::max(a, b));
  }
  return s * t <= 0 && u * v <= 0;
}

/// The corner w of `ring` where the segment to p, a vertex of another ring, leaves into the interior side.
bool opens_towards(const std::vector<Point2>& ring, std::size_t i, const Point2& p) {
  const Point2 &before = ring[(i + ring.size() - 1) % ring.size()], &at = ring[i], &after = ring[(i + 1) % ring.size()];
  const int left = turn(before, at, p), right = turn(at, after, p);
  return turn(before, at, after) >= 0 ? left > 0 && right > 0 : left > 0 || right > 0;
}

/// Outer ring and holes as one ring: each hole, from its rightmost vertex on, is joined by a bridge that meets nothing.
std::vector<Point2> with_bridges(const std::vector<std::vector<Point2>>& rings) {
  std::vector<Point2> ring = rings[0];
  std::vector<std::size_t> order(rings.size() - 1);
  std::iota(order.begin(), order.end(), 1);
  const auto rightmost = [&](std::size_t h) { return *std::max_element(rings[h].begin(), rings[h].end()); };
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return rightmost(a) > rightmost(b); });
  for (const std::size_t h : order) {
    const auto& hole = rings[h];
    const auto start = std::max_element(hole.begin(), hole.end());
    const auto free = [&](std::size_t i) {
      if (!opens_towards(ring, i, *start)) return false;
      for (std::size_t k = 0; k < ring.size(); ++k) {
        if (meet(ring[i], *start, ring[k], ring[(k + 1) % ring.size()])) return false;
      }
      for (const std::size_t other : order) {
        const auto& r = rings[other];
        for (std::size_t k = 0; k < r.size(); ++k) {
          if (meet(ring[i], *start, r[k], r[(k + 1) % r.size()])) return false;
        }
      }
      return true;
    };
    std::size_t bridge = 0;
    while (bridge < ring.size() && !free(bridge)) ++bridge;
    if (bridge == ring.size()) throw Error(ErrorCode::kGeometry, "a hole of the polygon is not inside its outer ring");
    std::vector<Point2> way(start, hole.end());
    way.insert(way.end(), hole.begin(), start + 1);
    way.push_back(ring[bridge]);
    ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(bridge) + 1, way.begin(), way.end());
  }
  return ring;
}

/// Two circuits that share the edge a b as one, if it is convex. `p` holds a b, `q` holds b a.
std::optional<std::vector<Point2>> joined(const std::vector<Point2>& p, const std::vector<Point2>& q, std::size_t i,
                                          std::size_t j) {
  std::vector<Point2> ring;
  for (std::size_t k = 1; k <= p.size(); ++k) ring.push_back(p[(i + k) % p.size()]);
  for (std::size_t k = 2; k < q.size(); ++k) ring.push_back(q[(j + k) % q.size()]);
  for (std::size_t k = 0; k < ring.size(); ++k) {
    if (turn(ring[k], ring[(k + 1) % ring.size()], ring[(k + 2) % ring.size()]) < 0) return std::nullopt;
  }
  return ring;
}

bool join_one(std::vector<std::vector<Point2>>& parts) {
  std::map<std::pair<Point2, Point2>, std::pair<std::size_t, std::size_t>> sides;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    for (std::size_t i = 0; i < parts[p].size(); ++i)
      sides[{parts[p][i], parts[p][(i + 1) % parts[p].size()]}] = {p, i};
  }
  for (const auto& [side, at] : sides) {
    const auto other = sides.find({side.second, side.first});
    if (other == sides.end() || other->second.first <= at.first) continue;
    if (auto whole = joined(parts[at.first], parts[other->second.first], at.second, other->second.second)) {
      parts[at.first] = std::move(*whole);
      parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(other->second.first));
      return true;
    }
  }
  return false;
}

}  // namespace

std::vector<std::array<int, 3>> triangulate(std::span<const Point2> ring, StraightCorner straight) {
  std::vector<std::array<int, 3>> triangles;
  int128 area = 0;
  Ears ears(ring);
  while (const auto ear = ears.next()) {
    const auto& [a, b, c] = ear->corners;
    if (ear->straight && straight == StraightCorner::kDrop) continue;
    triangles.push_back({a, b, c});
    area += twice_area(std::array<Point2, 3>{ring[a], ring[b], ring[c]});
  }
  if (area != twice_area(ring) || area <= 0) throw Error(ErrorCode::kGeometry, "the polygon is not simple");
  return triangles;
}

std::vector<ConvexPolygon> convex_parts(const std::vector<std::vector<Point2>>& rings) {
  const std::vector<Point2> ring = with_bridges(rings);
  std::vector<std::vector<Point2>> parts;
  for (const auto& [a, b, c] : triangulate(ring)) parts.push_back({ring[a], ring[b], ring[c]});
  while (join_one(parts)) {
  }
  std::vector<ConvexPolygon> polygons;
  for (const auto& part : parts) polygons.push_back(ConvexPolygon::hull(part));
  return polygons;
}

}  // namespace findspace::space
