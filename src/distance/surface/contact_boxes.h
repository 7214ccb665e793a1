// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Boxes of positions of B about a solid A, divided where more has to be known: those at all of whose positions the
// interiors meet, those that few planes of contact pass, and those to be divided. What one search finds the next one
// knows. Guarantee: the former surely overlap; of the second no plane is missed. Cost: for a new box some ten
// microseconds to a millisecond. Threads: none. Keywords: octree, adaptive subdivision of a configuration space.
#pragma once

#include <deque>

#include "distance/surface/surface_depths.h"
#include "exact/margins/space_distance.h"
#include "space/polytope/extent.h"
#include "space/surface/contact_planes.h"
#include "space/surface/real_overlap.h"

namespace findspace::distance {

class ContactBoxes {
 public:
  /// Of one sheet each. Inside: in the complement of A. Keeps references.
  ContactBoxes(const space::SurfaceSet& b, const space::SurfaceSet& a, space::TouchSide side);

  enum class State { kNew, kOverlap, kPlanes, kMany, kDivided };
  struct Box {
    space::Extent of;
    int level = 0;
    State state = State::kNew;
    int first = -1;                        // of eight
    std::vector<space::HalfSpace> planes;  // that pass it; none: it is all on one side of the frontier

    space::Vector half() const { return space::scaled(0.5, of.high - of.low); }
  };
  /// The box number k, looked at; the first one holds all of the frontier. One that many planes pass is divided, but
  /// where these may all pass through one place, which is asked now and then: its state is `many`.
  const Box& look(int k);
  /// The same without looking.
  const Box& box(int k) const { return boxes_[static_cast<std::size_t>(k)]; }
  /// Those of a box that many pass; nothing where they are too many.
  std::optional<std::vector<space::HalfSpace>> many_planes(int k) const;
  bool tiny(const Box& box) const { return space::length(box.half()) < margin::kSmallestContactBox * size_; }
  /// One that is not tiny, in eight.
  void divide(int k);

  /// Whether the interiors meet.
  bool overlap(const space::RealVector& p) { return overlap_.interiors_meet(p, recent_); }
  /// Whether they do for sure at a position that is off by no more.
  bool surely_overlap(const space::Vector& p, double off) const { return overlap_.surely_meet(p, off, recent_); }
  /// That were made.
  std::size_t count() const { return boxes_.size(); }
  /// Of the coordinates and the boxes.
  double size() const { return size_; }

 private:
  space::RealOverlap overlap_;
  space::ContactPlanes planes_;
  SurfaceDepths depths_;
  double size_ = 0;
  std::deque<Box> boxes_;
  space::RealOverlap::Recent recent_;
  int likely_ = SurfaceDepths::kNone;
};

}  // namespace findspace::distance
