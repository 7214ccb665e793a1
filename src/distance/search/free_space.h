// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Sets of positions with round boundaries that no planes and balls alone express, and the place of such a set nearest
// to or farthest from a position:
//   outside   what a union of open convex sets, each grown by a ball, leaves: of parts with radii the complement of U,
//             and E where A is not convex;
//   inside    the positions at which a body lies in one convex round part, vertex by vertex;
//   common    what such sets have in common.
// Guarantee: places are found by search (boundary_search.h), mostly to 2^-40 of the sizes; `proven` is false and
// `error` says how far values may be off; whether a place belongs is decided exactly. A passage or fit of zero
// clearance, which numbers cannot tell from none, is found among the planes along the faces of the sets, exactly; one
// between other boundaries (an edge and a face, two edges) that would change the answer is refused, not passed over.
// Keywords: penetration depth, rounded polyhedra, containment.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "distance/answer/answer.h"
#include "distance/search/boundary_search.h"
#include "space/body/body.h"
#include "space/body/open_union.h"

namespace findspace::distance {

/// The open set of what is nearer than the radius to {x : every plane < 0}, or to the centre where there are no planes.
struct GrownSet {
  std::vector<space::HalfSpace> planes;
  space::RealVector center;
  exact::Real radius;

  bool holds(const space::RealVector& p) const;
  /// The signed distance to its boundary, negative inside, and the place of the boundary nearest to p where that is
  /// known.
  Answer to_boundary(const space::RealVector& p) const;
};

class FreeSpace {
 public:
  static FreeSpace outside(std::vector<GrownSet> sets, const space::RealVector& low, const space::RealVector& high);
  static FreeSpace inside(const space::Body& b, const space::BodyPart& a, const space::RealVector& low,
                          const space::RealVector& high);

  /// The box holds the set.
  static FreeSpace common(std::span<const FreeSpace> spaces, const space::RealVector& low,
                          const space::RealVector& high);

  bool holds(const space::RealVector& p) const { return allows_(p); }
  /// How far the nearest place is from p, which does not belong; nothing where there is none. Beyond the box all
  /// belongs if `open`.
  TriedAnswer nearest(const space::RealVector& p, bool open) const;
  /// At least how far p is from the set, if more than 0; else so far, negated, p may go without leaving it. Numbers.
  double beyond(const space::Vector& p) const;
  /// The search for the nearest place, as far as `until` wants it; nothing is beyond the box.
  BoundaryPlace nearly(const space::RealVector& p, const Until& until) const;
  /// The least distance of a place that belongs to a set; the value is that of `to` there.
  exact::Tried<Answer> nearest_to(const TouchingRule& to) const;
  TriedAnswer farthest(const space::RealVector& p) const;

 private:
  double deepest_at(const space::Vector& near) const;
  BoundaryPlace searched(const space::Vector& near, bool open, const Incumbent& ask, const Until* until) const;
  TriedAnswer settled(const BoundaryPlace& found, const space::RealVector& p,
                      const std::optional<space::RealVector>& known) const;
  Incumbent known_at(std::function<std::optional<space::RealVector>()> find, const space::RealVector& p, int sense,
                     std::optional<space::RealVector>& known) const;
  std::optional<space::RealVector> even_place(const BoundaryPlace& found) const;

  Constraints rules_;
  std::vector<GrownSet> sets_;
  std::function<bool(const space::RealVector&)> allows_;
  std::shared_ptr<const space::OpenUnion>
      sharp_;  // the sets within their planes moved out by the radii: they hold them
  space::RealVector low_, high_;
  space::Vector box_low_, box_high_;  // a little more
  double size_ = 0;
};

/// The distance to the set less its radius; inside the set without a radius minus the depth in its planes, so that it
/// is convex.
ConvexDistance grown_distance(const GrownSet& set);

/// d(x, core) - radius of a part moved by p, with its slope.
TouchingRule touching_distance(const space::BodyPart& part, const space::Vector& p, double radius);

}  // namespace findspace::distance
