// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Where two convex parts overlap, as a set of relative positions: that within the planes of their Phi-function, or of
// two balls a ball. Balls push the planes out by their radius, and some more planes cut off the corners. With a gap the
// planes lie farther out by it. About a round container it is what lies beyond any plane of a polytope. Guarantee: that
// of doubles. Cost: a product a plane. Source: phi.md 2, 10. Keywords: penetration depth, Minkowski difference,
// configuration-space obstacle.
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <vector>

#include "exact/margins/packing.h"
#include "packing/solid_problem/solid_problem.h"
#include "space/phi/axis_scan.h"

namespace findspace::packing {

using space::Vector;

inline Vector operator+(const Vector& a, const Vector& b) { return space::plus(a, b); }
inline Vector operator*(double s, const Vector& a) { return space::scaled(s, a); }

/// By coordinates.
inline Vector least_of(const Vector& a, const Vector& b) {
  return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}
inline Vector most_of(const Vector& a, const Vector& b) {
  return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}

/// How far out of a convex set a place is, and which way is out: of its highest plane, or from its centre.
struct Facing {
  double value;   // below 0 inside
  Vector normal;  // of length 1
};

/// The open set of the positions of B + u where it overlaps A, of two convex parts: that within planes, or of two balls
/// a ball. Or, of a wall about places that are free, what is beyond any plane.
struct ConvexOverlap {
  enum class Kind { kWithin, kBall, kAbout };
  Vector low, high;  // its box
  std::span<const space::PlaneBlock> planes;
  std::array<space::AxisPlanes, 3> on_axes;  // kWithin: the same planes
  double radius = 0;  // kBall: in the middle of its box; kAbout: of a ball about the origin that holds what is free
  Kind kind = Kind::kWithin;

  bool may_hold(const Vector& u) const {
    return u.x > low.x && u.y > low.y && u.z > low.z && u.x < high.x && u.y < high.y && u.z < high.z;
  }
  /// 0 where there is none.
  double depth(const Vector& u) const;
  /// t with u + t way in a convex set, where the line comes deeper than `shallow`; crossed elsewhere. Along an axis
  /// also where it grazes the set on a long way.
  space::LineStretch stretch(const Vector& u, const Vector& way, double shallow) const;
  /// Visits the stretches of t with u + t way in the set, where the line comes deeper than `shallow`: of a convex set
  /// one. Where a line nowhere leaves what is about places, it is the whole line, the best of which is lowest_on().
  template <class Visit>
  void for_each_stretch(const Vector& u, const Vector& way, double shallow, const Visit& visit) const {
    if (kind != Kind::kAbout) {
      const space::LineStretch t = stretch(u, way, shallow);
      if (t.from < t.to) visit(t);
      return;
    }
    constexpr double far = std::numeric_limits<double>::infinity();
    const space::LineStretch free = free_stretch(u, way, shallow);
    if (!(free.from < free.to)) return visit(space::LineStretch{-far, far});
    visit(space::LineStretch{-far, free.from});
    visit(space::LineStretch{free.to, far});
  }
  /// The t at which a line comes nearest to the places that this is about.
  double lowest_on(const Vector& u, const Vector& way) const;
  /// Visits the planes by which it can be left: of a convex set its highest alone, of what is about places all that are
  /// passed or not farther than `reach`.
  template <class Visit>
  void for_each_facing(const Vector& u, double reach, const Visit& visit) const {
    if (kind != Kind::kAbout) return visit(facing(u));
    for (const space::PlaneBlock& b : planes)
      for (std::size_t k = 0; k < 8; ++k) {
        const double free = -(b.x[k] * u.x + b.y[k] * u.y + b.z[k] * u.z + b.d[k]);
        if (free <= reach) visit(Facing{free, {-b.x[k], -b.y[k], -b.z[k]}});
      }
  }
  double value(const Vector& u) const {
    if (kind == Kind::kWithin) return highest(u).value;
    return kind == Kind::kBall ? from_ball(u) : -highest(u).value;
  }

 private:
  Facing facing(const Vector& u) const;
  space::LineStretch free_stretch(const Vector& u, const Vector& way, double shallow) const {
    return space::scan_line(planes.data(), planes.size(), u, way, -shallow, margin::kAlongPlane);
  }
  space::Highest highest(const Vector& u) const { return space::scan_planes(planes.data(), planes.size(), u); }
  Vector center() const { return 0.5 * (low + high); }
  double from_ball(const Vector& u) const { return space::length(u - center()) - radius; }
  space::LineStretch stretch_on_axis(std::size_t axis, const Vector& u, double sense, double shallow) const;
  space::LineStretch stretch_of_ball(const Vector& u, const Vector& way, double shallow) const;
};

/// Convex parts on a common grid, and its steps in a unit; rounded where their exact one is out of range.
struct CommonParts {
  std::vector<space::BodyPart> first, second;
  double steps;
};
/// `steps` of the problem's grid in a unit.
CommonParts common_parts(const space::Body& a, const space::Body& b, double steps);

/// The sides along x, y and z, low and high, on which a set has no end.
using OpenSides = std::array<std::array<bool, 2>, 3>;

/// Unit vectors that are spread evenly.
std::vector<Vector> spread_directions();

/// Of A and B + u, but for its planes, which are the blocks that are added; p of A and q of B are on a common grid of
/// that step. Where q is open it goes on beyond its face.
void add_overlap(const space::BodyPart& p, const space::BodyPart& q, double step, double gap, const OpenSides& open,
                 ConvexOverlap& overlap, std::vector<space::PlaneBlock>& blocks);
/// What is beyond any of the planes normal . u <= offset, all of whose places are within `reach` of the origin.
void add_about(std::span<const Vector> normals, std::span<const double> offsets, double reach, ConvexOverlap& overlap,
               std::vector<space::PlaneBlock>& blocks);
/// The same where B is the half-space normal . x + offset <= 0, its normal of length 1, in units; `steps` of p in a
/// unit.
void add_overlap(const space::BodyPart& p, double steps, const Vector& normal, double offset, double gap,
                 ConvexOverlap& overlap, std::vector<space::PlaneBlock>& blocks);

}  // namespace findspace::packing
