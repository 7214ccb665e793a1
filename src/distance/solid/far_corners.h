// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Those corners of two solids that are farthest apart, and the corner that is farthest from a convex set. A solid is
// known by lists of points: their convex hull counts, so the corners of a mesh do as well as those of its hull.
// Guarantee: exact; what is near the farthest in doubles is compared exactly. Cost: some passes over the points, and
// the pairs that are not clearly too near. Keywords: farthest pair, diameter.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "distance/answer/answer.h"
#include "space/body/body.h"

namespace findspace::distance {

/// Points, each grown by the radius.
struct Corners {
  std::span<const space::Point> points;
  exact::Real radius;
};
/// Of the parts of a body, which has to last.
std::vector<Corners> corners_of(const space::Body& body);

/// gamma2 of B + p and A: the greatest distance of two of their points, with these. Of pairs that are equally far the
/// first one counts, in the order of A's points.
Answer farthest_apart(const std::vector<Corners>& b, const std::vector<Corners>& a, const space::RealVector& p);
/// The same, where numbers leave few pairs.
std::optional<Answer> farthest_of_few(const std::vector<Corners>& b, const std::vector<Corners>& a,
                                      const space::RealVector& p);
/// The point of B + p that is surely farther from A than all others; none where numbers leave several, or where it may
/// lie within A.
std::optional<space::BodyPart> only_farthest(const std::vector<Corners>& b, const space::BodyPart& a,
                                             const space::RealVector& p);

/// max |v - w| + radii over two points of the body.
exact::Real diameter(const space::Body& body);

}  // namespace findspace::distance
