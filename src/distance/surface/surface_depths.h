// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Whether two solids surely overlap at all positions near one, B moved there: where a place of B lies deeper in A than
// a position may change, the interiors meet, or less deep by the radius of a ball about it in B; so does a place of A
// in B. And how near the positions may be at which they do not: where a place lies in the other solid, it does so at
// all positions that no triangle separates from that one. The places are the corners and, of surfaces that are not
// fine, the middles of the edges and faces of both, and the centres of balls that touch some of the faces from inside,
// in trees of balls. Guarantee: doubles; a depth is never decided as more than it is but for roundings. Cost: some
// hundred distances to a surface, about a microsecond each, or a known one nearby (field_samples.h), and for the second
// question one distance of a part of the surface. The trees are divided where they are looked at. Threads: one at a
// time. Source: the balls as in Ma, Bae, Choi 2012, "3D medial axis point approximation using nearest neighbors and the
// normal field". Keywords: penetration depth, lower bound, bounding sphere hierarchy, shrinking ball.
#pragma once

#include <array>

#include "distance/surface/field_samples.h"
#include "distance/surface/place_tree.h"
#include "space/surface/real_overlap.h"

namespace findspace::distance {

class SurfaceDepths {
 public:
  /// Of one sheet each. Inside: in the complement of A. Keeps references.
  SurfaceDepths(const space::SurfaceSet& b, const space::SurfaceSet& a, space::TouchSide side);

  static constexpr int kNone = -1;
  /// Whether a place tells that they overlap at all positions of the box. `likely`: one that may, and the one that was
  /// found.
  bool overlap(const space::Extent& box, int& likely);
  /// At all positions of the box that are nearer to `from` than that they overlap: infinite where a place tells so of
  /// all; else by one that no triangle of the other surface separates from where it is;
  /// `known` where none tells more.
  double overlap(const space::Extent& box, const space::Vector& from, double known, int& likely);
  /// Of the coordinates.
  double size() const { return size_; }

 private:
  struct Tree {
    PlaceTree places;
    FieldSamples other;
    bool outward = false;  // deeper is farther out of the other one
    bool back = false;     // these are places of A
  };
  /// Of the numbers of nodes the last bit tells the tree.
  Tree& tree_of(int node) { return trees_[static_cast<std::size_t>(node % 2)]; }
  const Tree& tree_of(int node) const { return trees_[static_cast<std::size_t>(node % 2)]; }
  const PlaceTree::Node& at(int node) const { return tree_of(node).places.node(node / 2); }
  /// The two that the node is divided in.
  std::array<int, 2> divided(int node);
  /// Numbers between which the depth of all places of the node lies: close enough to tell whether one is deeper than
  /// that, or to order the nodes by.
  exact::Interval depth(int node, const space::Vector& position, double than) const;
  /// How deep a place surely lies at the position, deeper than `floor`: the deepest one that was found, or the first
  /// one deeper than `enough`. Else `floor`, and `likely` as it was.
  double deepest(const space::Vector& position, double enough, double floor, int& likely);
  /// What roundings may take from depths at positions of the box.
  double noise(const space::Extent& box) const;
  /// How near the positions of the box may be at which they do not overlap, as a place of the node tells, which lies
  /// deep at one of them; 0 where it does not.
  double told(int node, const space::Extent& box, const space::Vector& from, const space::Vector& position) const;

  SurfaceField of_b_, of_a_;
  std::array<Tree, 2> trees_;
  double size_ = 0;
};

}  // namespace findspace::distance
