// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/planar_features/feature_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "exact/margins/planar_distance.h"
#include "exact/margins/rounding.h"
#include "plane/base/union_find.h"

namespace findspace::distance {

using plane::Index;
using plane::kNone;
using plane::Region;

namespace {

constexpr Index kLeaf = 4;
constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr FeatureBox kNoBox{kInfinite, kInfinite, -kInfinite, -kInfinite};

double square(double x) { return x * x; }

FeatureTree::Reach reach_of(const FeatureBox& box) { return {box.x1 - box.x0, box.y1 - box.y0}; }

FeatureTree::Reach larger(FeatureTree::Reach a, FeatureTree::Reach b) {
  return {std::max(a.x, b.x), std::max(a.y, b.y)};
}

/// Features [first, last) that follow each other along the boundary.
struct PlacedWalk {
  Index first, last;
  FeatureBox box = kNoBox;
  double middle(bool wide) const { return wide ? box.x0 + box.x1 : box.y0 + box.y1; }
};

/// The left half before the right one, or the lower before the upper one, and so on in each.
void order_by_halves(std::span<PlacedWalk> walks) {
  if (walks.size() < 3) return;
  FeatureBox box = kNoBox;
  for (const PlacedWalk& w : walks) box.add(w.box);
  const bool wide = box.x1 - box.x0 > box.y1 - box.y0;
  const std::size_t half = walks.size() / 2;
  std::nth_element(walks.begin(), walks.begin() + std::ptrdiff_t(half), walks.end(),
                   [wide](const PlacedWalk& a, const PlacedWalk& b) {
                     return std::pair(a.middle(wide), a.first) < std::pair(b.middle(wide), b.first);
                   });
  order_by_halves(walks.first(half));
  order_by_halves(walks.subspan(half));
}

}  // namespace

void FeatureBox::add(const FeatureBox& o) {
  x0 = std::min(x0, o.x0);
  y0 = std::min(y0, o.y0);
  x1 = std::max(x1, o.x1);
  y1 = std::max(y1, o.y1);
}

double FeatureBox::nearest_squared(const FeatureBox& o, double px, double py) const {
  return square(std::max({x0 - (o.x1 + px), 0.0, o.x0 + px - x1})) +
         square(std::max({y0 - (o.y1 + py), 0.0, o.y0 + py - y1}));
}

double FeatureBox::farthest_squared(const FeatureBox& o, double px, double py) const {
  return square(std::max(x1 - (o.x0 + px), o.x1 + px - x0)) + square(std::max(y1 - (o.y0 + py), o.y1 + py - y0));
}

FeatureBox box_of(const BoundaryFeature& s) {
  FeatureBox b{std::min(s.x0, s.x1), std::min(s.y0, s.y1), std::max(s.x0, s.x1), std::max(s.y0, s.y1)};
  if (s.arc && s.cx >= b.x0 && s.cx <= b.x1) b.add({s.cx, s.cy + s.half * s.r, s.cx, s.cy + s.half * s.r});
  double tolerance = (std::abs(b.x0) + std::abs(b.x1) + std::abs(b.y0) + std::abs(b.y1)) * margin::kFewRoundings;
  return {b.x0 - tolerance, b.y0 - tolerance, b.x1 + tolerance, b.y1 + tolerance};
}

FeatureTree::FeatureTree(const Region& region) : region_(region) {
  collect();
  if (!features_.empty()) {
    nodes_.reserve(2 * features_.size());
    reaches_.reserve(2 * features_.size());
    build(0, Index(features_.size()));
  }
}

void FeatureTree::add_walk(Index half_edge, std::vector<char>& known) {
  Index h = half_edge;
  do {
    if (!known[h / 2] && region_.edges[h / 2].mark > 0) features_.push_back(edge_feature(region_, h / 2));
    known[h / 2] = 1;
    h = region_.next(h);
  } while (h != half_edge);
}

void FeatureTree::order_by_place(std::span<const Index> walks) {
  std::vector<PlacedWalk> order;
  for (std::size_t k = 0; k < walks.size(); ++k) {
    order.push_back({walks[k], k + 1 < walks.size() ? walks[k + 1] : Index(features_.size())});
    for (Index f = order[k].first; f < order[k].last; ++f) order[k].box.add(box_of(features_[f]));
  }
  order_by_halves(order);
  std::vector<BoundaryFeature> ordered;
  ordered.reserve(features_.size());
  for (const PlacedWalk& w : order)
    ordered.insert(ordered.end(), features_.begin() + w.first, features_.begin() + w.last);
  features_ = std::move(ordered);
}

void FeatureTree::collect() {
  features_.reserve(region_.edges.size());
  std::vector<char> known(region_.edges.size(), 0);
  std::vector<Index> walks;  // where each begins
  for (Index h = 0; h < region_.half_edges.size(); ++h) {
    if (known[h / 2]) continue;
    const Index first = Index(features_.size());
    add_walk(h, known);
    if (features_.size() > first) walks.push_back(first);
  }
  plane::UnionFind pieces(Index(region_.vertices.size()));
  for (const auto& e : region_.edges) pieces.unite(e.v0, e.v1);
  for (Index v = 0; v < region_.vertices.size(); ++v) {
    if (pieces.find(v) == v && region_.vertices[v].mark > 0) representatives_.push_back(v);
    if (region_.vertices[v].out == kNone && region_.vertices[v].mark > 0) {
      walks.push_back(Index(features_.size()));
      features_.push_back(vertex_feature(region_, v));
    }
  }
  if (walks.size() > 2) order_by_place(walks);
  std::sort(representatives_.begin(), representatives_.end(),
            [&](Index v, Index w) { return std::pair(region_.point(v).x, v) < std::pair(region_.point(w).x, w); });
  for (const BoundaryFeature& s : features_) {
    arcs_ = arcs_ || s.arc;
    scale_ = std::max({scale_, std::abs(s.x0), std::abs(s.y0), std::abs(s.x1), std::abs(s.y1), std::abs(s.cx) + s.r,
                       std::abs(s.cy) + s.r});
  }
}

Index FeatureTree::build(Index first, Index last) {
  Index at = Index(nodes_.size());
  nodes_.push_back({box_of(features_[first]), first, last, kNone});
  reaches_.push_back(reach_of(nodes_[at].box));
  if (last - first <= kLeaf) {
    for (Index k = first + 1; k < last; ++k) {
      const FeatureBox box = box_of(features_[k]);
      nodes_[at].box.add(box);
      reaches_[at] = larger(reaches_[at], reach_of(box));
    }
    return at;
  }
  Index middle = first + (last - first) / 2;
  build(first, middle);
  Index right = build(middle, last);
  nodes_[at].right = right;
  nodes_[at].box = nodes_[at + 1].box;
  nodes_[at].box.add(nodes_[right].box);
  reaches_[at] = larger(reaches_[at + 1], reaches_[right]);
  return at;
}

std::span<const Index> FeatureTree::representatives_in(const FeatureTree& set, double dx, double dy) const {
  if (set.region_.faces[0].mark > 0) return representatives_;
  if (set.nodes_.empty()) return {};
  const FeatureBox& box = set.nodes_[0].box;
  const double slack = (scale_ + set.scale_ + std::abs(dx) + std::abs(dy)) * margin::kOnBoundary;
  const auto x_of = [&](Index v) { return region_.point(v).x + dx; };
  const auto first = std::partition_point(representatives_.begin(), representatives_.end(),
                                          [&](Index v) { return x_of(v) < box.x0 - slack; });
  const auto last =
      std::partition_point(first, representatives_.end(), [&](Index v) { return x_of(v) <= box.x1 + slack; });
  return {first, last};
}

FeatureTree::Extreme FeatureTree::extreme(double ux, double uy) const {
  Extreme best{kNone, 0, 0, -std::numeric_limits<double>::infinity()};
  auto take = [&](Index vertex, double x, double y) {
    if (const double h = ux * x + uy * y; h > best.height) best = {vertex, x, y, h};
  };
  auto bound = [&](Index node) {
    const FeatureBox& box = nodes_[node].box;
    return ux * (ux > 0 ? box.x1 : box.x0) + uy * (uy > 0 ? box.y1 : box.y0);
  };
  std::array<Index, 64> stack;
  std::size_t size = 0;
  stack[size++] = 0;
  while (size > 0) {
    const Index at = stack[--size];
    const Node& n = nodes_[at];
    if (bound(at) <= best.height) continue;
    if (n.right != kNone) {
      const bool right_first = bound(n.right) > bound(at + 1);
      stack[size++] = right_first ? at + 1 : n.right;
      stack[size++] = right_first ? n.right : at + 1;
      continue;
    }
    for (Index k = n.first; k < n.last; ++k) {
      const BoundaryFeature& s = features_[k];
      take(s.is_vertex() ? s.cell.index : region_.edges[s.cell.index].v0, s.x0, s.y0);
      if (!s.is_vertex()) take(region_.edges[s.cell.index].v1, s.x1, s.y1);
    }
  }
  return best;
}

FeatureTree::Near FeatureTree::nearest(double x, double y, Index guess) const {
  if (nodes_.empty()) return {std::numeric_limits<double>::infinity(), kNone};
  double best = guess == kNone ? std::numeric_limits<double>::infinity() : features_[guess].squared_distance(x, y);
  Index feature = guess;
  struct Entry {
    Index node;
    double squared;
  };
  std::array<Entry, 64> stack;
  std::size_t size = 0;
  stack[size++] = {0, nodes_[0].box.nearest_squared(x, y)};
  while (size > 0) {
    Entry e = stack[--size];
    // Walks down to the leaf that is nearest; what is put off is near enough.
    while (e.squared <= best) {
      const Node& n = nodes_[e.node];
      if (n.right == kNone) {
        for (Index k = n.first; k < n.last; ++k)
          if (const double d = features_[k].squared_distance(x, y); d < best) {
            best = d;
            feature = k;
          }
        break;
      }
      Entry near{e.node + 1, nodes_[e.node + 1].box.nearest_squared(x, y)},
          far{n.right, nodes_[n.right].box.nearest_squared(x, y)};
      if (far.squared < near.squared) std::swap(near, far);
      if (far.squared <= best) stack[size++] = far;
      e = near;
    }
  }
  return {std::sqrt(best), feature};
}

/// The face that goes on from the vertex in the direction of the place.
std::optional<Index> FeatureTree::face_around(Index vertex, double x, double y) const {
  Index first = region_.vertices[vertex].out;
  if (first == kNone) return region_.vertices[vertex].face;
  const exact::Point& at = region_.point(vertex);
  double dx = x - at.x, dy = y - at.y;
  auto direction = [&](Index h) -> std::array<double, 2> {
    Index e = h / 2;
    if (!region_.is_arc(e)) {
      const exact::Point& to = region_.point(region_.target(h));
      return {to.x - at.x, to.y - at.y};
    }
    const exact::SupportingCurve& k = region_.supporting_curve(e);
    double turn = region_.heading(h).forward ? 1 : -1;  // counter-clockwise: the radius turned left
    return {-(at.y - k.y().value) * turn, (at.x - k.x().value) * turn};
  };
  // 0 where it is not certain.
  auto cross = [](double ax, double ay, double bx, double by) {
    double p = ax * by, q = ay * bx;
    return std::abs(p - q) > (std::abs(p) + std::abs(q)) * margin::kCertainTurn ? (p > q ? 1 : -1) : 0;
  };
  Index h = first;
  if (region_.clockwise(h) == h) return region_.face(h);
  do {
    Index next = region_.clockwise(h);  // the sector counter-clockwise from next to h
    auto a = direction(next), b = direction(h);
    int turn = cross(a[0], a[1], b[0], b[1]), left = cross(a[0], a[1], dx, dy), right = cross(dx, dy, b[0], b[1]);
    // The vertex is nearest, so where the place is in line with an edge it is on the other side: half a turn away.
    if (turn == 0) return std::nullopt;
    if (turn > 0 ? left > 0 && right > 0 : left >= 0 || right >= 0) return region_.face(next);
    h = next;
  } while (h != first);
  return std::nullopt;
}

std::optional<bool> FeatureTree::contains(double x, double y, const Near& near) const {
  if (near.feature == kNone) return region_.faces[0].mark > 0;
  if (near.distance <= (scale_ + std::abs(x) + std::abs(y)) * margin::kOnBoundary) return std::nullopt;
  const FeatureBox& box = nodes_[0].box;
  if (x < box.x0 || x > box.x1 || y < box.y0 || y > box.y1) return region_.faces[0].mark > 0;
  const BoundaryFeature& s = features_[near.feature];
  if (s.is_vertex()) return region_.faces[region_.vertices[s.cell.index].face].mark > 0;
  Index h = 2 * s.cell.index;  // from (x0, y0) to (x1, y1)
  if (s.faces(x, y)) {
    // At its end an edge may have another one beside it, tangent to it, that the place is behind.
    const double to_end = std::min(plain_length(x - s.x0, y - s.y0), plain_length(x - s.x1, y - s.y1));
    if (arcs_ && to_end <= near.distance * (1 + margin::kCertainTurn)) return std::nullopt;
    bool left = s.arc ? (plain_length(x - s.cx, y - s.cy) < s.r) == (s.half < 0)
                      : (s.x1 - s.x0) * (y - s.y0) - (s.y1 - s.y0) * (x - s.x0) > 0;
    return region_.faces[region_.face(left ? h : h + 1)].mark > 0;
  }
  bool first = plain_length(x - s.x0, y - s.y0) < plain_length(x - s.x1, y - s.y1);
  auto face = face_around(first ? region_.edges[s.cell.index].v0 : region_.edges[s.cell.index].v1, x, y);
  if (!face) return std::nullopt;
  return region_.faces[*face].mark > 0;
}

}  // namespace findspace::distance
