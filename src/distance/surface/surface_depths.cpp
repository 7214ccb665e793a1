// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/surface/surface_depths.h"

#include <algorithm>

#include "distance/search/boundary_cells.h"
#include "exact/margins/space_distance.h"

namespace findspace::distance {

using space::Vector;

namespace {

/// Distances for an answer, at most: what they do not show smaller boxes do.
constexpr int kMostLooks = 400;

/// Balls in a solid, at most.
constexpr std::size_t kMostBalls = 300;

/// Faces of a mesh whose middles are places: in a finer one the corners are as near to one another, and among five
/// times as many the deepest one is not found within so many looks. Of two that are not finer the planes of a box are
/// told sooner than how near it overlaps.
constexpr std::size_t kMostMiddles = 50000;

/// Of half a box: places so deep are asked how far they overlap, the deepest first.
constexpr std::array<double, 2> kShares{0.5, 0.125};

Vector middle_of(const space::RayBody& body, int f) {
  const auto corner = [&](int k) { return exact::approx(body.corner(f, k)); };
  return space::scaled(1.0 / 3, space::plus(corner(0), space::plus(corner(1), corner(2))));
}

/// The least distance of x from what lies in the window of a surface, which is the only one, or less; infinite where
/// nothing does.
double distance_in(const SurfaceField& field, const space::Extent& window, const Vector& x) {
  const space::BoxTree& tree = field.set().sheets()[0]->tree;
  const auto side = [](double low, double high, std::int64_t from, std::int64_t to, double at) {
    const double lo = std::max(low, static_cast<double>(from)), hi = std::min(high, static_cast<double>(to));
    return lo > hi ? exact::kInfinity : std::max({lo - at, at - hi, 0.0});
  };
  const auto gap = [&](const space::GridBox& box) {
    return space::length({side(window.low.x, window.high.x, box.low.x, box.high.x, x.x),
                          side(window.low.y, window.high.y, box.low.y, box.high.y, x.y),
                          side(window.low.z, window.high.z, box.low.z, box.high.z, x.z)});
  };
  double out = exact::kInfinity;
  tree.nearest_first(
      gap, [&](double away) { return away < out; },
      [&](int k) {
        out = std::min(out, std::max(field.distance(tree.face(k), x), gap(tree.box(k))));
        return true;
      });
  return out;
}

/// Times that a position is moved away and back into the box.
constexpr int kMoves = 4;

/// A position of the box near its middle that is about so far away, or farther.
Vector probe(const space::Extent& box, const Vector& from, double away) {
  Vector at = box.middle();
  for (int k = 0; k < kMoves; ++k) {
    const Vector way = at - from;
    const double length = space::length(way);
    if (!(length < away) || !(length > 0)) break;
    const Vector x = space::plus(from, space::scaled(away / length, way));
    at = {std::clamp(x.x, box.low.x, box.high.x), std::clamp(x.y, box.low.y, box.high.y),
          std::clamp(x.z, box.low.z, box.high.z)};
  }
  return at;
}

}  // namespace

/// Corners, of a mesh that is not fine the middles of edges and faces, and balls if asked for.
std::vector<SurfaceDepths::Place> SurfaceDepths::places_of(const space::SurfaceSet& set, bool balls) {
  const space::RayBody& body = set.sheets()[0]->body;
  std::vector<Place> out;
  for (const space::Point& v : body.points) out.push_back({exact::approx(v)});
  if (body.faces.size() <= kMostMiddles) {
    for (const space::RayEdge& e : body.edges) {
      const Vector v = exact::approx(body.points[static_cast<std::size_t>(e.from)]),
                   w = exact::approx(body.points[static_cast<std::size_t>(e.to)]);
      out.push_back({space::scaled(0.5, space::plus(v, w))});
    }
    for (int f = 0; f < static_cast<int>(body.faces.size()); ++f) out.push_back({middle_of(body, f)});
  }
  if (!balls) return out;
  const SurfaceField field(set, {});
  for (std::size_t f = 0; f < body.faces.size(); f += body.faces.size() / kMostBalls + 1) {
    if (const auto ball = field.inner_ball(static_cast<int>(f))) out.push_back({ball->center, ball->radius});
  }
  return out;
}

SurfaceDepths::SurfaceDepths(const space::SurfaceSet& b, const space::SurfaceSet& a, space::TouchSide side)
    : of_b_(b, {}),
      of_a_(a, {}),
      trees_{Tree{{}, {}, FieldSamples(a), side == space::TouchSide::kInside, false},
             Tree{{}, {}, FieldSamples(b), false, true}} {
  for (Tree& tree : trees_) {
    // Of the complement of A balls are not looked for.
    tree.places = places_of(tree.back ? a : b, !tree.back || side == space::TouchSide::kOutside);
    fine_ = fine_ || (tree.back ? a : b).sheets()[0]->body.faces.size() > kMostMiddles;
    for (const Place& p : tree.places) size_ = std::max(size_, space::size_of(p.at));
    tree.nodes.push_back(node_of(tree, 0, static_cast<std::uint32_t>(tree.places.size())));
  }
}

space::Extent SurfaceDepths::box_of(std::span<const Place> places) {
  space::Extent box{places[0].at, places[0].at};
  for (const Place& p : places) box.add({p.at, p.at});
  return box;
}

SurfaceDepths::Node SurfaceDepths::node_of(const Tree& tree, std::uint32_t begin, std::uint32_t end) {
  const std::span<const Place> places = std::span(tree.places).subspan(begin, end - begin);
  Node made;
  made.begin = begin;
  made.end = end;
  made.least = made.most = places[0].clearance;
  made.middle = box_of(places).middle();
  for (const Place& p : places) {
    made.least = std::min(made.least, p.clearance);
    made.most = std::max(made.most, p.clearance);
    made.radius = std::max(made.radius, space::length(p.at - made.middle));
  }
  return made;
}

int SurfaceDepths::divided(Tree& tree, int node) {
  const Node of = tree.nodes[static_cast<std::size_t>(node)];
  if (of.first >= 0) return of.first;
  const std::span<Place> places = std::span(tree.places).subspan(of.begin, of.end - of.begin);
  const space::Extent box = box_of(places);
  const Vector wide = box.high - box.low;
  const int axis = wide.x >= wide.y && wide.x >= wide.z ? 0 : wide.y >= wide.z ? 1 : 2;
  const std::uint32_t half = (of.end - of.begin) / 2;
  std::nth_element(places.begin(), places.begin() + half, places.end(),
                   [axis](const Place& p, const Place& q) { return component(p.at, axis) < component(q.at, axis); });
  const int first = static_cast<int>(tree.nodes.size());
  tree.nodes[static_cast<std::size_t>(node)].first = first;
  tree.nodes.push_back(node_of(tree, of.begin, of.begin + half));
  tree.nodes.push_back(node_of(tree, of.begin + half, of.end));
  return first;
}

namespace {

/// A place of the node's ball is surely deeper than that.
template <class Node>
bool some_deeper(const exact::Interval& depth, const Node& node, double than) {
  return depth.lo - node.radius + node.least > than;
}
/// Surely none is.
template <class Node>
bool none_deeper(const exact::Interval& depth, const Node& node, double than) {
  return !(depth.hi + node.radius + node.most > than);
}

}  // namespace

exact::Interval SurfaceDepths::depth(const Tree& tree, const Node& node, const Vector& position, double than) {
  const Vector x = tree.back ? node.middle - position : space::plus(node.middle, position);
  exact::Interval out;
  // Boxes are kept for later places, distances are not.
  tree.other.ask(x, than / 2, [&](const exact::Interval& at) {
    out = tree.outward ? at : -at;
    // Or that whatever the depth is, neither of the two is so.
    const bool neither = !(out.hi - node.radius + node.least > than) && out.lo + node.radius + node.most > than;
    return some_deeper(out, node, than) || none_deeper(out, node, than) || neither;
  });
  return out;
}

bool SurfaceDepths::deeper(Tree& tree, const Vector& position, double than, int& likely) {
  struct Task {
    double depth;
    int node;
  };
  std::array<Task, 128> stack;  // of those to be divided, the deepest of two on top
  std::size_t left = 0;
  int looks = 0;
  const auto look = [&](int k) {
    const Node& node = tree.nodes[static_cast<std::size_t>(k)];
    const exact::Interval at = depth(tree, node, position, than);
    ++looks;
    if (some_deeper(at, node, than)) {
      likely = k;
      return true;
    }
    if (!node.leaf() && !none_deeper(at, node, than)) stack[left++] = {(at.lo + at.hi) / 2 + node.most, k};
    return false;
  };
  if (look(0)) return true;
  while (left > 0 && looks < kMostLooks) {
    const std::size_t below = --left;
    const int first = divided(tree, stack[below].node);
    if (look(first) || look(first + 1)) return true;
    if (left == below + 2 && stack[below].depth > stack[below + 1].depth) std::swap(stack[below], stack[below + 1]);
  }
  return false;
}

bool SurfaceDepths::deeper(const Vector& position, double than, int& likely) {
  if (likely != kNone) {
    const Tree& tree = trees_[static_cast<std::size_t>(likely % 2)];
    const Node& node = tree.nodes[static_cast<std::size_t>(likely / 2)];
    if (some_deeper(depth(tree, node, position, than), node, than)) return true;
  }
  for (int k = 0; k < 2; ++k) {
    int found = kNone;
    if (!deeper(trees_[static_cast<std::size_t>(k)], position, than, found)) continue;
    likely = 2 * found + k;
    return true;
  }
  return false;
}

// Of the positions that are nearer than the surface in the window, which are convex with the one at which the place is
// deep, none separates another one from that.
double SurfaceDepths::told(int node, const space::Extent& box, const Vector& from, const Vector& position) const {
  const double noise = margin::kDepthNoise * (size_ + space::length(from));
  const Tree& tree = trees_[static_cast<std::size_t>(node % 2)];
  const Vector place = tree.places[tree.nodes[static_cast<std::size_t>(node / 2)].begin].at;
  const auto seen = [&](const Vector& q) { return tree.back ? place - q : space::plus(place, q); };
  const SurfaceField& other = tree.back ? of_b_ : of_a_;
  const SurfaceField::Signed at = other.at(seen(position));
  if (!at.certain || !((tree.outward ? at.value : -at.value) > noise)) return 0;
  space::Extent window{seen(box.low), seen(box.low)};
  window.add({seen(box.high), seen(box.high)});
  const double apart = distance_in(other, grown(window, noise), seen(from)) - noise;
  return apart > space::length(position - from) + noise ? apart : 0;
}

double SurfaceDepths::overlap(const space::Extent& box, const Vector& from, double known, int& likely) {
  if (!fine_) return known;
  const Vector position = probe(box, from, known);
  const double half = space::length(box.high - box.low) / 2;
  double most = likely == kNone ? known : std::max(known, told(likely, box, from, position));
  if (most > known) return most;
  for (const double share : kShares) {
    int found = kNone;
    if (!deeper(position, share * half + margin::kDepthNoise * size_, found)) continue;
    const double next = told(found, box, from, position);
    if (!(next > most)) continue;
    likely = found;
    return next;
  }
  return most;
}

}  // namespace findspace::distance
