// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/surface/surface_depths.h"

#include <algorithm>

#include "distance/search/boundary_cells.h"
#include "exact/margins/space_distance.h"
#include "plane/base/subdivide.h"

namespace findspace::distance {

using space::Vector;

namespace {

/// Nodes looked at for an answer, at most: what they do not show smaller boxes do. With fewer of them the deepest place
/// near a contact of fine surfaces is missed, and many more boxes are looked at.
constexpr int kMostLooks = 1000;

/// Of the radius of a node, by which it may have a place deeper than its middle: so much of it is hoped for.
constexpr double kHoped = 0.5;

/// Balls in a solid, at most.
constexpr std::size_t kMostBalls = 300;

/// Faces of a mesh whose middles are places: in a finer one the corners are as near to one another, and among five
/// times as many the deepest one is not found within so many looks.
constexpr std::size_t kMostMiddles = 50000;

/// Of half a box: places less deep are not asked how far they overlap.
constexpr double kLeastShare = 0.125;

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

/// Corners, of a mesh that is not fine the middles of edges and faces, and balls if asked for.
std::vector<PlaceTree::Place> places_of(const space::SurfaceSet& set, bool balls) {
  const space::RayBody& body = set.sheets()[0]->body;
  std::vector<PlaceTree::Place> out;
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

}  // namespace

// Of the complement of A balls are not looked for.
SurfaceDepths::SurfaceDepths(const space::SurfaceSet& b, const space::SurfaceSet& a, space::TouchSide side)
    : of_b_(b, {}),
      of_a_(a, {}),
      trees_{Tree{PlaceTree(places_of(b, true)), FieldSamples(a), side == space::TouchSide::kInside, false},
             Tree{PlaceTree(places_of(a, side == space::TouchSide::kOutside)), FieldSamples(b), false, true}} {
  for (const Tree& tree : trees_) {
    for (const PlaceTree::Place& p : tree.places.places()) size_ = std::max(size_, space::size_of(p.at));
  }
}

std::array<int, 2> SurfaceDepths::divided(int node) {
  const int which = node % 2;
  const auto [one, two] = tree_of(node).places.divided(node / 2);
  return {2 * one + which, 2 * two + which};
}

exact::Interval SurfaceDepths::depth(int k, const Vector& position, double than) const {
  const Tree& tree = tree_of(k);
  const PlaceTree::Node& node = at(k);
  const Vector x = tree.back ? node.middle - position : space::plus(node.middle, position);
  exact::Interval out;
  // Boxes are kept for later places, distances are not.
  tree.other.ask(x, than / 2, [&](const exact::Interval& other) {
    const exact::Interval middle = tree.outward ? other : -other;
    out = {middle.lo - node.radius + node.least, middle.hi + node.radius + node.most};
    return out.lo > than || !(out.hi > than) || (!node.leaf() && middle.hi - middle.lo < node.radius);
  });
  return out;
}

double SurfaceDepths::deepest(const Vector& position, double enough, double floor, int& likely) {
  struct Task {
    double hoped, most;
    int node;
    bool operator<(const Task& o) const { return hoped < o.hoped; }
  };
  plane::Subdivision<Task> left;
  double best = floor;
  int looks = 0;
  const auto look = [&](int k) {
    const PlaceTree::Node& node = at(k);
    const exact::Interval found = depth(k, position, best);
    ++looks;
    if (found.lo > best) {
      best = found.lo;
      likely = k;
    }
    const double middle = (found.lo - node.least + found.hi - node.most) / 2;
    if (!node.leaf() && found.hi > best) left.push({middle + node.most + kHoped * node.radius, found.hi, k});
  };
  if (likely != kNone) look(likely);
  for (const int root : {0, 1}) {
    if (!(best > enough)) look(root);
  }
  left.run([&](const Task& /*top*/) { return best > enough || looks >= kMostLooks; },
           [&](const Task& top) {
             if (!(top.most > best)) return;
             for (const int part : divided(top.node)) {
               if (!(best > enough)) look(part);
             }
           });
  return best;
}

// Of the positions that are nearer than the surface in the window, which are convex with the one at which the place is
// deep, none separates another one from that.
double SurfaceDepths::told(int node, const space::Extent& box, const Vector& from, const Vector& position) const {
  const double noise = margin::kDepthNoise * (size_ + space::length(from));
  const Tree& tree = tree_of(node);
  const Vector place = tree.places.place(node / 2).at;
  const auto seen = [&](const Vector& q) { return tree.back ? place - q : space::plus(place, q); };
  const SurfaceField& other = tree.back ? of_b_ : of_a_;
  const SurfaceField::Signed there = other.at(seen(position));
  if (!there.certain || !((tree.outward ? there.value : -there.value) > noise)) return 0;
  space::Extent window{seen(box.low), seen(box.low)};
  window.add({seen(box.high), seen(box.high)});
  const double apart = distance_in(other, grown(window, noise), seen(from)) - noise;
  return apart > space::length(position - from) + noise ? apart : 0;
}

double SurfaceDepths::noise(const space::Extent& box) const {
  return margin::kDepthNoise * (size_ + space::length(box.low) + space::length(box.high));
}

bool SurfaceDepths::overlap(const space::Extent& box, int& likely) {
  const double than = space::length(box.high - box.low) / 2 + noise(box);
  return deepest(box.middle(), than, than, likely) > than;
}

double SurfaceDepths::overlap(const space::Extent& box, const Vector& from, double known, int& likely) {
  const double half = space::length(box.high - box.low) / 2;
  const Vector position = probe(box, from, known);
  const double enough = half + space::length(position - box.middle()) + noise(box),
               floor = kLeastShare * half + noise(box);
  const double depth = deepest(position, enough, floor, likely);
  if (depth > enough) return exact::kInfinity;
  return depth > floor ? std::max(known, told(likely, box, from, position)) : known;
}

}  // namespace findspace::distance
