// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/surface_depths.h"

#include <algorithm>
#include <queue>

namespace findspace::distance {

using space::Vector;

namespace {

/// Distances for an answer, at most: what they do not show smaller boxes do.
constexpr int kMostLooks = 400;

/// Corners and the middles of edges and faces.
std::vector<Vector> places_of(const space::SurfaceSet& set) {
  const space::RayBody& body = set.sheets()[0]->body;
  std::vector<Vector> out;
  for (const space::Point& v : body.points) out.push_back(exact::shadow(v));
  for (const space::RayEdge& e : body.edges) {
    const Vector v = exact::shadow(body.points[static_cast<std::size_t>(e.from)]),
                 w = exact::shadow(body.points[static_cast<std::size_t>(e.to)]);
    out.push_back(space::scaled(0.5, space::plus(v, w)));
  }
  for (int f = 0; f < static_cast<int>(body.faces.size()); ++f) {
    const auto corner = [&](int k) { return exact::shadow(body.corner(f, k)); };
    out.push_back(space::scaled(1.0 / 3, space::plus(corner(0), space::plus(corner(1), corner(2)))));
  }
  return out;
}

double component(const Vector& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

}  // namespace

SurfaceDepths::SurfaceDepths(const space::SurfaceSet& b, const space::SurfaceSet& a, space::TouchSide side)
    : trees_{Tree{{}, {a, {}}, side == space::TouchSide::kInside, false}, Tree{{}, {b, {}}, false, true}} {
  for (Tree& tree : trees_) {
    std::vector<Vector> places = places_of(tree.back ? a : b);
    for (const Vector& v : places) size_ = std::max(size_, space::size_of(v));
    tree.nodes.emplace_back();
    build(tree, 0, places);
  }
}

void SurfaceDepths::build(Tree& tree, int node, std::span<Vector> places) {
  Vector low = places[0], high = low;
  for (const Vector& v : places) {
    low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
    high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
  }
  Node made{space::scaled(0.5, space::plus(low, high)), 0, -1};
  for (const Vector& v : places) made.radius = std::max(made.radius, space::length(v - made.middle));
  if (places.size() > 1) made.first = static_cast<int>(tree.nodes.size());
  tree.nodes[static_cast<std::size_t>(node)] = made;
  if (made.first < 0) return;
  tree.nodes.resize(tree.nodes.size() + 2);
  const Vector wide = high - low;
  const int axis = wide.x >= wide.y && wide.x >= wide.z ? 0 : wide.y >= wide.z ? 1 : 2;
  const std::size_t half = places.size() / 2;
  std::nth_element(places.begin(), places.begin() + static_cast<std::ptrdiff_t>(half), places.end(),
                   [axis](const Vector& v, const Vector& w) { return component(v, axis) < component(w, axis); });
  build(tree, made.first, places.first(half));
  build(tree, made.first + 1, places.subspan(half));
}

double SurfaceDepths::depth(const Tree& tree, const Node& node, const Vector& position) {
  const Vector x = tree.back ? node.middle - position : space::plus(node.middle, position);
  const SurfaceField::Signed at = tree.other.at(x);
  // Next to the surface the side is not told: 0 but for roundings.
  return at.certain ? (tree.outward ? at.value : -at.value) : 0;
}

bool SurfaceDepths::deeper(const Tree& tree, const Vector& position, double than, int& likely) {
  struct Task {
    double depth;
    int node;
    bool operator<(const Task& o) const { return depth != o.depth ? depth < o.depth : node > o.node; }
  };
  std::priority_queue<Task> queue;
  int looks = 0;
  const auto look = [&](int k) {
    const Node& node = tree.nodes[static_cast<std::size_t>(k)];
    const double at = depth(tree, node, position);
    ++looks;
    if (at - node.radius > than) {
      likely = k;
      return true;
    }
    if (at + node.radius > than && node.first >= 0) queue.push({at, k});
    return false;
  };
  if (look(0)) return true;
  while (!queue.empty() && looks < kMostLooks) {
    const int first = tree.nodes[static_cast<std::size_t>(queue.top().node)].first;
    queue.pop();
    if (look(first) || look(first + 1)) return true;
  }
  return false;
}

bool SurfaceDepths::deeper(const Vector& position, double than, int& likely) const {
  if (likely != kNone) {
    const Tree& tree = trees_[static_cast<std::size_t>(likely % 2)];
    const Node& node = tree.nodes[static_cast<std::size_t>(likely / 2)];
    if (depth(tree, node, position) - node.radius > than) return true;
  }
  for (int k = 0; k < 2; ++k) {
    int found = kNone;
    if (!deeper(trees_[static_cast<std::size_t>(k)], position, than, found)) continue;
    likely = 2 * found + k;
    return true;
  }
  return false;
}

}  // namespace findspace::distance
