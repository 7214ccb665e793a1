// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// One Phi-function at one position, exactly: the position is given by real numbers (the decimals of a scene or of
// --at), not by doubles. Guarantee: state and active facets are exact; the value and the distance are the exact ones
// with a relative error of 2^-50, also next to contact, where doubles cancel. Cost: a filter over all facets, then
// exact arithmetic for the few facets that compete.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "exact/number/real.h"
#include "space/phi/phi_function.h"
#include "space/polytope/real_vector.h"

namespace findspace::space {

struct PhiAt {
  State state = State::kContact;
  double max_form = 0;
  double distance = 0;      // of the bodies; 0 unless apart
  Vector gradient;          // of the max form, at its first active facet
  std::vector<int> active;  // facets that are highest at u, ties included
};

PhiAt phi_at(const PhiFunction& phi, const RealVector& u);

/// -1 overlap, 0 contact, +1 apart.
int sign_at(const PhiFunction& phi, const RealVector& u);

/// The squared distance of A and B + u; 0 unless they are apart.
exact::Real squared_distance(const PhiFunction& phi, const RealVector& u);

/// From the nearest point on the border of a convex polygon, counter-clockwise about the normal n, to u; nothing where
/// u is strictly above or below its inside. Of a point or of the two ends of a segment, n = 0, the nearest point of it.
std::optional<RealVector> off_border(std::span<const Point> corners, const RealVector& n, const RealVector& u);

}  // namespace findspace::space
