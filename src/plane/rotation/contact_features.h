// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What of the boundary of a set M ("material") can touch another set from outside: its straight edges, each with the
// normal that points out of M, and its round parts, arcs and corners, each a centre, a signed radius (0: a corner, less
// than 0: M lies outside the circle) and the range of its outward normals. A part of M and a part of another set that
// touch have opposite normals, so pairs of features with opposite normals give all positions in which two sets touch
// without overlapping: the reduced convolution. Curves without area have normals to both sides. Guarantee: no feature
// is missing; there may be some too many (normals in doubles, with tolerance). Cost: linear. Source: Guibas, Ramshaw,
// Stolfi, A kinetic framework for computational geometry (1983). Keywords: normal cone, convolution, contact curve.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "plane/rotation/rotated_edges.h"

namespace findspace::plane {

/// A range of directions in radians, counter-clockwise.
struct Cone {
  double from = 0, width = 0;
};

/// Where two sets touch that both have their outside on several sides, each may go through the other, which then holds
/// it from anywhere: a wire in a slot, or between parts that touch in a point. kOnlySeveral: a corner for that alone.
enum class Outside : std::uint8_t { kOneSide, kSeveral, kOnlySeveral };

inline bool may_meet(Outside a, Outside b) {
  return (a != Outside::kOnlySeveral || b != Outside::kOneSide) &&
         (b != Outside::kOnlySeveral || a != Outside::kOneSide);
}

/// The part of a circle (or a corner, or a single point) around `center`.
struct RoundFeature {
  RealVector center;
  exact::Real radius;  // signed
  double x = 0, y = 0, r = 0;
  Cone normals;
  Outside outside = Outside::kOneSide;
};

/// The segment from p to q; its normal points to the left of that way (side +1) or to the right (-1).
struct EdgeFeature {
  RealVector p, q;
  int side = 1;
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0, nx = 0, ny = 0, normal = 0;  // unit normal, and its direction in radians
  Outside outside = Outside::kOneSide;
};

struct ContactFeatures {
  std::vector<RoundFeature> rounds;
  std::vector<EdgeFeature> edges;
};

/// A feature that may be made: its number among all rounds, or all edges, and its normals.
struct FeatureOutline {
  bool edge;
  Index number;
  Cone normals;
  Outside outside;
};
using ChosenFeatures = std::function<bool(const FeatureOutline&)>;

/// Of the set of faces with a wanted mark and all edges and vertices. Relative to `about`. `chosen`: only these, or
/// all; a set has many, of which one direction is a few.
ContactFeatures contact_features(const CellComplex& complex, const exact::RealPoint& about,
                                 const std::function<bool(Mark)>& material, const ChosenFeatures& chosen = {});

/// Two ranges of directions have one in common, up to `tolerance`.
bool cones_meet(const Cone& a, const Cone& b, double tolerance);

}  // namespace findspace::plane
