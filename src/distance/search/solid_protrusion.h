// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The signed directed Hausdorff distance of bodies: mu(B+p, A) = max over b in B + p of the signed distance of b to A.
//   A convex: at a vertex of B, exactly.
//   A a union, B + p not inside A: h = max over B of the distance to the nearest part of A, by solid_max_min.h. The
//   complement of polyhedra is such a union, of the cells outside them.
// Guarantee: convex: exact. Else within 2^-40 of the value, or of the size of B where the limit of kMostCells cells is
// reached (`proven` is false then). Keywords: directed Hausdorff distance, branch and bound.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <utility>

#include "distance/answer/answer.h"
#include "distance/search/round_solid.h"
#include "distance/search/solid_max_min.h"
#include "space/body/body.h"
#include "space/body/open_union.h"
#include "space/body/outside_cells.h"

namespace findspace::distance {

/// A part with a radius, or a point, moved.
RoundSolid round_solid(const space::BodyPart& part, const space::Vector& by);
/// The body's parts, moved by p, as searches divide them; the corners are those of the polyhedra.
Solids solids_of(const space::Body& b, const space::RealVector& p);
/// Of the parts without a radius.
std::vector<space::Point> sharp_corners(const space::Body& b);
/// The one that is at the place when moved by p, exactly.
std::optional<space::RealVector> corner_at(std::span<const space::Point> corners, const space::RealVector& p,
                                           const space::Vector& place, double size);
/// The exact distance from a place to the nearest of balls.
class NearestBall {
 public:
  explicit NearestBall(const space::RealVector& from) : from_(from) {}
  /// The way to its centre.
  void offer(const space::RealVector& way, const exact::Real& radius);
  const std::optional<Answer>& found() const { return found_; }

 private:
  space::RealVector from_;
  std::optional<Answer> found_;
};
/// What a search found; at a corner of what is moved by p by the exact distance from there.
Answer protrusion_answer(const SolidMaxMin& found, std::span<const space::Point> corners, const space::RealVector& p,
                         const std::function<Answer(const space::RealVector&)>& exact);
/// Whether no polyhedron among the parts has a radius.
bool polyhedra_and_balls(const space::Body& b);
/// Both less the radius of a convex A, where no part of B is less round: (P (+) r) (-) r = P, so they fit as they did.
std::optional<std::pair<space::Body, space::Body>> without_radius(const space::Body& b, const space::Body& a);
/// A convex, of any radius.
Answer protrusion_of_convex(const space::Body& b, const space::BodyPart& a, const space::RealVector& p);
/// The closed sets are convex and their union is A; B + p is not inside A.
Answer protrusion_of_cells(const space::Body& b, std::span<const space::OutsideCell> a, const space::RealVector& p);
/// B + p is not inside A.
Answer protrusion_of_union(const space::Body& b, const space::Body& a, const space::RealVector& p);

}  // namespace findspace::distance
