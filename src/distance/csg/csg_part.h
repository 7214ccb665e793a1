// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A part of a solid that round ones are cut out of (csg_solid.h), as searches see it, and exact tests and candidates
// for what they find, and the positions at which a body is free of such parts. Internal to csg_pair. Guarantee: tests
// are exact; `empty` means no interior that doubles can see (2^-44 of the sizes). Keywords: spherical cavity, candidate
// features.
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
/// The part has to outlive it.
CsgPartSearch csg_part_search(const space::CsgPart& part, double size);
/// A polytope by its planes, or a ball. Refused for other sets.
exact::Tried<std::vector<MeetSet>> meet_sets(const space::BodyPart& part);
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

/// The positions at which B is free of the parts, which have to outlive it. Refused for round polyhedra and for what
/// has no interior.
exact::Tried<PositionSet> free_positions(const space::Body& b, const std::vector<CsgPartSearch>& parts, double size);

}  // namespace findspace::distance
