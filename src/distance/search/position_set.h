// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A closed set of positions (or of places) within a box, {x : each constraint on x holds}, whatever says the
// constraints, and the questions that every one of them answers:
//   holds      whether a place belongs, exactly;
//   nearest    the place nearest to a position, or to a convex set;
//   farthest   the place farthest from a position, or from a union of convex sets;
//   deepest    the place with the most slack, where no functions are made lazily.
// Providers say the constraints:
//   outside    what a union of open convex sets, each grown by a ball, leaves: of parts with radii the complement of U,
//              and E where A is not convex;
//   inside     the positions at which a body lies in one convex round part, vertex by vertex;
//   common     what such sets have in common;
//   of_constraints   convex functions, as of a part of a solid that round ones are cut out of (csg_part.h);
//   lazily     functions that each search makes for the cells it looks at (csg_positions.cpp, union_fit.h,
//              surface_ball.h).
// Guarantee: places are found by search (boundary_search.h), mostly to 2^-40 of the sizes; `proven` is false and
// `error` says how far values may be off; whether a place belongs is decided exactly, where a provider can. A passage
// or fit of zero clearance, which numbers cannot tell from none, is found among the planes along the faces of the sets,
// exactly; with one between other boundaries (an edge and a face, two edges) that would change the answer, or a search
// that ends at its limit, the value is what that leaves open: from the bound to the best place that is known. Keywords:
// configuration space, penetration depth, rounded polyhedra, containment.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "distance/answer/answer.h"
#include "distance/search/boundary_search.h"
#include "distance/search/grown_set.h"
#include "space/body/body.h"
#include "space/body/open_union.h"
#include "space/polytope/extent.h"

namespace findspace::distance {

/// The nearest complete number, or a simple part, where that is within the blur; else the coordinate.
exact::Real simple(double coordinate, double blur);
/// What is off by no more than `error`, or lies between.
Answer unproven_answer(double value, double error);
Answer unproven_answer(exact::Real value, Enclosure ends);
/// What a search found for a value of that size; nothing is off by more than `error`.
Answer searched_answer(const BoundaryPlace& found, double size);

/// The value at the place that it found, which is off by no more than `slack`.
Answer searched_place(const BoundaryPlace& found, const space::RealVector& p, double slack);
/// Of a search that ended before: the nearest (farthest) place lies between the bound, which may be off by `slack`, and
/// the best one of those that are known. Without one there may be none, whose distance counts as +infinity.
Answer ended_before(const BoundaryPlace& found, double slack, std::span<const Answer> places, bool farthest);

class PositionSet {
 public:
  using Box = space::Extent;
  using Holds = std::function<bool(const space::RealVector&)>;
  using MakeLazy = std::function<std::unique_ptr<LazyConstraints>()>;
  /// A value that some place is known to have, perhaps with the place: exactly, or with an error of its own.
  using Known = std::function<std::optional<Answer>()>;

  static PositionSet outside(std::vector<GrownSet> sets, const space::RealVector& low, const space::RealVector& high);
  /// What the insides of the body's parts leave.
  static PositionSet outside_of(const space::Body& body);
  static PositionSet inside(const space::Body& b, const space::BodyPart& a, const space::RealVector& low,
                            const space::RealVector& high);
  /// The box holds the set.
  static PositionSet common(std::span<const PositionSet> sets, const space::RealVector& low,
                            const space::RealVector& high);
  /// `size`: of the coordinates and of what the functions are made of.
  static PositionSet of_constraints(Constraints constraints, const Box& box, double size, Holds holds);
  /// `slack`: of the sizes, what its places may be off.
  static PositionSet lazily(MakeLazy lazy, const Box& box, double size, double slack = margin::kFoundError);
  /// What it has in common with a convex set.
  PositionSet also_in(TouchingConstraint set) const;
  /// The same set, searched within another box.
  PositionSet within(const Box& box) const;

  bool holds(const space::RealVector& p) const { return !holds_ || holds_(p); }
  /// How far the nearest place is from p, which does not belong; nothing where there is none. Beyond the box all
  /// belongs if `open`. None is nearer than `floor`.
  TriedAnswer nearest(const space::RealVector& p, bool open, const Known& known = {}, double floor = 0) const;
  TriedAnswer farthest(const space::RealVector& p, const Known& known = {}) const;
  /// The least of a convex function at a place of the set, to which all beyond the box belongs.
  Answer least(const TouchingConstraint& of) const;

  /// At least how far p is from the set, if more than 0; else so far, negated, p may go without leaving it. Numbers.
  double beyond(const space::Vector& p) const;
  /// The searches themselves, as far as `until` wants them. `floor`: the function is nowhere less.
  struct Query {
    double floor = 0;
    Incumbent known{};
    const Until* until = nullptr;
    std::optional<Box> box{};  // instead of the set's own
  };
  BoundaryPlace nearest_to(const TouchingConstraint& to, const Query& query) const;
  BoundaryPlace farthest_from(std::span<const ConvexDistance> from, const Incumbent& known = {},
                              const FarEnd& end = {}) const;
  BoundaryPlace farthest_from(const ConvexDistance& from, const Incumbent& known = {}, const FarEnd& end = {}) const {
    return farthest_from(std::span(&from, 1), known, end);
  }
  BoundaryPlace farthest_from(const space::Vector& p, const Incumbent& known = {}) const {
    return farthest_from([p](const space::Vector& x) { return space::length(x - p); }, known);
  }
  Slack deepest(const SlackEnd& end, std::optional<Box> box = {}) const {
    return most_slack(cells(box.value_or(box_)), constraints_, end);
  }

  const Box& box() const { return box_; }
  /// Of the coordinates.
  double size() const { return size_; }
  const Constraints& constraints() const { return constraints_; }
  /// Whether there are more than these, made by each search.
  bool has_more() const { return lazy_ != nullptr; }

 private:
  PositionSet(const space::RealVector& low, const space::RealVector& high);

  std::vector<Tetrahedron> cells(const Box& box) const;
  Box around_box(const Box& box) const;
  Box around(const space::Vector& p) const;
  double deepest_at(const space::Vector& p) const;
  Answer beyond_box(const space::RealVector& p) const;
  TriedAnswer settled(const BoundaryPlace& found, const space::RealVector& p, const std::optional<Answer>& known,
                      const std::optional<Answer>& beyond, bool farthest) const;
  Known sharp_place(std::function<exact::Tried<std::optional<space::RealVector>>()> find,
                    const space::RealVector& p) const;
  std::optional<space::RealVector> even_place(const BoundaryPlace& found) const;

  Constraints constraints_;
  MakeLazy lazy_;
  std::vector<GrownSet> sets_;
  Holds holds_;
  /// The sets within their planes moved out by the radii: they hold them.
  std::shared_ptr<const space::OpenUnion> sharp_;
  space::RealVector low_, high_;
  Box box_;
  bool askew_ = false;  // the box is to be put askew (boundary_cells.h)
  double size_ = 0, slack_ = margin::kFoundError;
};

}  // namespace findspace::distance
