// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The slack of what half-spaces, balls and convex sets grown by balls have in common: the greatest t for which a place
// is t inside each of them,
//     max over x in a tetrahedron of min over the sets of -(signed distance of x);
// more than 0 where they have interior in common. The place is found by cutting planes (a linear program of the
// planes and of tangents of the balls), finished in closed form where it is as deep in one to four of the sets; a grown
// set counts there as its tangent plane, or as the ball about the nearest place of its core. Guarantee: doubles; the
// value is that at `place`, so never more than the true one but for rounding, mostly that to 2^-46 of the sizes. Cost:
// some ten microseconds, with grown sets some hundred. Keywords: Chebyshev centre, problem of Apollonius, cutting
// planes.
#pragma once

#include <memory>
#include <span>

#include "distance/search/boundary_search.h"

namespace findspace::distance {

/// {x : at . x + by <= 0} with `at` of length 1, or the ball {x : |x - at| <= by}, or a set grown by `by`, moved by
/// `at`.
struct MeetSet {
  bool ball = false;
  space::Vector at;
  double by = 0;
  std::shared_ptr<const TouchingConstraint> grown{};  // the signed distance to the boundary of a grown set

  bool plane() const { return !ball && !grown; }
  double beyond(const space::Vector& x) const {
    if (grown) return (*grown)(x - at).value;
    return ball ? space::length(x - at) - by : space::dot(at, x) + by;
  }
};

struct MeetSlack {
  double value = 0;
  space::Vector place;
};

/// At least one set; `start` is in the tetrahedron, as near to the place as is known.
MeetSlack meet_slack(std::span<const MeetSet> sets, const Tetrahedron& about, const space::Vector& start);

}  // namespace findspace::distance
