// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// All parts moved and rotated a little at once by one linear program that shortens the layout. Pairs near each other
// keep to a convex set of free positions (free_half_planes.h). Each half-plane is told by the corners and edges that
// meet there, and rotations move these by their velocity. Guarantee: none; a rotation by w leaves overlaps of the order
// of w squared, which linear_moves.h takes away, and proofs follow. Cost: some milliseconds a program. Source:
// quasi-phi-functions, Stoyan, Pankratov & Romanova 2016; here to first order. Keywords: continuous rotation.
#pragma once

#include <optional>
#include <vector>

#include "packing/compaction/free_half_planes.h"
#include "packing/compaction/linear_program.h"
#include "packing/nfp/row.h"

namespace findspace::packing {

/// By how much an item may be rotated from where it is, in radians, counter-clockwise.
struct TiltRange {
  double low = 0, high = 0;
};

class TiltingMoves {
 public:
  /// Both must live as long.
  TiltingMoves(const FieldTable& table, const Row& row) : table_(table), row_(row) {}

  /// An item after a program: its position once rotated by `angle` about its own origin.
  struct Move {
    Vec at;
    double angle = 0;
  };
  /// No corner moves farther than some `trust`s. Nothing where the program has no solution or no part may be rotated.
  std::optional<std::vector<Move>> shorten(const std::vector<Pose>& poses, const std::vector<TiltRange>& ranges,
                                           double length, double trust);

 private:
  /// A part as the program sees it: its rings about its own origin, and the point that it is rotated about.
  struct Body {
    std::vector<std::vector<Vec>> rings;
    Vec middle;
    double radius = 0;
    bool is_round = false;
  };
  /// dot(normal, velocity of b there - velocity of a there) >= need. The places are relative to the origins.
  struct Contact {
    std::size_t a, b;
    Vec normal, on_a, on_b;
    double need;
  };
  /// A half-plane of free positions in the directions of the world; it lacks this much now.
  struct Side {
    Vec normal;
    double lacks, gap, reach, tolerance;
  };

  static Body body_of(const Variant& variant);
  void collect_pair(const std::vector<Pose>& poses, std::size_t a, std::size_t b, double trust);
  bool add_contacts(const Contact& pair, Vec t, const Side& side);
  bool add_corners_at_edges(const Contact& pair, Vec t, const Side& side, bool swapped);
  bool add_corners(const Contact& pair, Vec t, const Side& side);
  void add_walls(LinearProgram& program, const std::vector<Pose>& poses, int end, double trust) const;
  void add_velocity(LinearProgram& program, std::size_t item, Vec normal, Vec place, double sign) const;

  const Variant& variant(const Pose& pose) const { return table_.variants()[pose.variant]; }

  const FieldTable& table_;
  const Row& row_;
  std::vector<Body> bodies_;  // of the poses, then of the obstacles
  std::vector<Contact> contacts_;
  std::vector<HalfPlane> planes_;
  std::vector<bool> keeps_angle_;  // a contact of it is not known by its corners
};

}  // namespace findspace::packing
