// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Whether two solids surely overlap at all positions near one, B moved there: where a place of B lies deeper in A than
// a position may change, the interiors meet, or less deep by the radius of a ball about it in B; so does a place of A
// in B. And how near the positions may be at which they do not: where a place lies in the other solid, it does so at
// all positions that no triangle separates from that one. The places are the corners and, of surfaces that are not
// fine, the middles of the edges and faces of both, and the centres of balls that touch some of the faces from inside,
// in trees of balls. Guarantee: doubles; a depth is never decided as more than it is but for roundings. Cost: some
// dozen distances to a surface, about a microsecond each, or a known one nearby (field_samples.h), and for the second
// question one distance of a part of the surface. The trees are divided where they are looked at. Threads: one at a
// time. Source: the balls as in Ma, Bae, Choi 2012, "3D medial axis point approximation using nearest neighbors and the
// normal field". Keywords: penetration depth, lower bound, bounding sphere hierarchy, shrinking ball.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "distance/surface/field_samples.h"
#include "space/surface/real_overlap.h"

namespace findspace::distance {

class SurfaceDepths {
 public:
  /// Of one sheet each. Inside: in the complement of A. Keeps references.
  SurfaceDepths(const space::SurfaceSet& b, const space::SurfaceSet& a, space::TouchSide side);

  /// Whether a place lies deeper than that at the position; `likely`: one that may, and the one that does.
  bool deeper(const space::Vector& position, double than, int& likely);
  static constexpr int kNone = -1;
  /// At all positions of the box that are nearer to `from` than that they overlap, as a place tells that no triangle of
  /// the other surface separates from where it is; `known` where none tells more, and
  /// of surfaces that are not fine.
  double overlap(const space::Extent& box, const space::Vector& from, double known, int& likely);
  /// Of the coordinates.
  double size() const { return size_; }

 private:
  /// And a ball about it in the solid.
  struct Place {
    space::Vector at;
    double clearance = 0;
  };
  /// A ball about some of the places, and the least and the greatest of their clearances: a leaf holds one, others the
  /// two nodes from `first` on once they are divided.
  struct Node {
    space::Vector middle;
    double radius = 0, least = 0, most = 0;
    std::uint32_t begin = 0, end = 0;
    int first = -1;
    bool leaf() const { return end - begin == 1; }
  };
  struct Tree {
    std::vector<Place> places;
    std::vector<Node> nodes;  // those that were needed
    FieldSamples other;
    bool outward = false;  // deeper is farther out of the other one
    bool back = false;     // these are places of A
  };
  static std::vector<Place> places_of(const space::SurfaceSet& set, bool balls);
  static space::Extent box_of(std::span<const Place> places);
  static Node node_of(const Tree& tree, std::uint32_t begin, std::uint32_t end);
  /// The first of the two that the node is divided in.
  static int divided(Tree& tree, int node);
  /// At the middle of the node, between bounds that tell whether its ball has a place that is deeper than that.
  static exact::Interval depth(const Tree& tree, const Node& node, const space::Vector& position, double than);
  static bool deeper(Tree& tree, const space::Vector& position, double than, int& likely);
  /// The same as a place of the node tells, which lies deep at a position of the box.
  double told(int node, const space::Extent& box, const space::Vector& from, const space::Vector& position) const;

  SurfaceField of_b_, of_a_;
  std::array<Tree, 2> trees_;
  double size_ = 0;
  bool fine_ = false;  // one of the surfaces
};

}  // namespace findspace::distance
