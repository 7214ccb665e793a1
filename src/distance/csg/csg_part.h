// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A part of a solid that round ones are cut out of (csg_solid.h), as searches see it, and exact tests and candidates
// for what they find, and the positions at which a body is free of such parts. Internal to csg_pair. Guarantee: tests
// are exact; `empty` means no interior that doubles can see (2^-44 of the sizes), and is said where the search decides
// so: a thinner shell than it can find stays, and what is not found in it is refused. Keywords: spherical cavity,
// candidate features.
#pragma once

#include <optional>
#include <vector>

#include "distance/search/meet_slack.h"
#include "distance/search/position_set.h"
#include "distance/search/set_protrusion.h"
#include "distance/solid/solid_pair.h"
#include "space/body/body_boxes.h"
#include "space/body/csg_solid.h"

namespace findspace::distance {

struct CsgPartSearch {
  const space::CsgPart* sets = nullptr;
  PositionSet places;
  bool empty = false;

  /// Of its planes and balls.
  NearSet near_set() const;
  const space::Extent& box() const { return places.box(); }
};

/// Of all coordinates and radii.
double cut_size(const space::Body& b, const space::CsgSolid& a);
/// Whether no part of it has interior that doubles can see.
bool is_empty(const space::CsgSolid& body);
/// Whether the set moved by p has no interior in common with the part as one set that is cut out holds all of it.
bool in_a_cut(const space::BodyPart& set, const space::CsgPart& part, const space::RealVector& p);
/// At least how far the set moved by p is from the part by lying in a set that is cut out; 0 where it lies in none.
double depth_in_cuts(const space::BodyPart& set, const space::CsgPart& part, const space::RealVector& p, double size);
/// The part has to outlive it.
CsgPartSearch csg_part_search(const space::CsgPart& part, double size);
/// Why: of what has no interior.
exact::Refusal no_depth();
/// A polytope by its planes, a ball, or a grown set. Refused where it has no interior.
exact::Tried<std::vector<MeetSet>> meet_sets(const space::BodyPart& part);
/// Why: a search found no place of a part, or of what two parts have in common, and did not show that there is none.
exact::Refusal not_found_in_part();
/// Whether a search came to its end, so that value and bound part by rounding: then a place has the value by its name.
bool came_to_end(const BoundaryPlace& found, double size);
/// What no place of several parts is better than, as the searches in each of them say.
class BoundOfParts {
 public:
  /// `sense`: 1 for the nearest place, -1 for the farthest.
  BoundOfParts(int sense, double size) : sense_(sense), size_(size) {}
  /// `more`: what is added to the values.
  void add(const BoundaryPlace& found, double more = 0);
  /// The best value, with what it may be off. Refused where a part in which nothing was found may hold a better place.
  TriedAnswer best(std::optional<Answer> of) const;

 private:
  double sense_, size_, found_ = exact::kInfinity, missed_ = exact::kInfinity;
};
/// As constraints on a place: in the convex set moved by p, with how deep; outside it.
TouchingConstraint convex_constraint(const space::BodyPart& set, const space::Vector& p);
/// The distance to the set moved by p; inside it minus how deep, so that what is flat on both sides is decided at once.
TouchingConstraint gap_to(const space::BodyPart& set, const space::Vector& p);
ConvexDistance reverse_convex_constraint(const space::BodyPart& set, const space::Vector& p);

/// Whether the closed part holds the place, exactly.
bool holds(const space::CsgPart& part, const space::RealVector& x);
/// The distances from B's part s, moved by p, to places of A's part that square roots name: on one set of A alone, on a
/// sphere from inside, on the circle of a sphere with another or a plane; those that are near `place`.
std::vector<Answer> named_gaps(const space::CsgPart& a, const space::BodyPart& s, const space::RealVector& p,
                               const space::Vector& place, double size);

/// The positions at which B is free of the parts, which have to outlive it. Refused for what has no interior.
exact::Tried<PositionSet> free_positions(const space::Body& b, const std::vector<CsgPartSearch>& parts, double size);

}  // namespace findspace::distance
