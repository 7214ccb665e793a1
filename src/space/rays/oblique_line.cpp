// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/rays/oblique_line.h"

#include <algorithm>
#include <limits>

#include "exact/margins/rounding.h"
#include "exact/margins/space.h"

namespace findspace::space {

using exact::Real;

namespace {

RealVector of_length_one(const RealVector& v) { return scaled(Real(1) / sqrt(dot(v, v)), v); }

}  // namespace

ObliqueLine::ObliqueLine(RealVector through, const RealVector& direction) : origin(std::move(through)) {
  RealVector aside;
  std::size_t least = 0;
  for (std::size_t k = 1; k < 3; ++k) {
    if (abs(direction[k]) < abs(direction[least])) least = k;
  }
  aside[least] = Real(1);
  const RealVector first = cross(aside, direction);
  frame = {of_length_one(first), of_length_one(cross(direction, first)), of_length_one(direction)};
}

bool ObliqueLine::may_meet(const Vector& low, const Vector& high, double scale) const {
  const Vector p = space::scaled(scale, space::rounded(origin)), d = space::rounded(frame[2]);
  double from = -std::numeric_limits<double>::infinity(), to = -from;
  const double tolerance = margin::kWiderBox * (size_of(p) + 1);
  const auto clip = [&](double at, double slope, double least, double most) {
    // Nearly across this axis: where it crosses says little.
    if (std::fabs(slope) < margin::kAcrossAxis || !std::isfinite(least) || !std::isfinite(most)) return;
    const double a = (least - at) / slope, b = (most - at) / slope,
                 blur = margin::kWiderBox * (std::fabs(a) + std::fabs(b));
    from = std::max(from, std::min(a, b) - blur - tolerance / std::fabs(slope));
    to = std::min(to, std::max(a, b) + blur + tolerance / std::fabs(slope));
  };
  clip(p.x, d.x, low.x, high.x);
  clip(p.y, d.y, low.y, high.y);
  clip(p.z, d.z, low.z, high.z);
  return from <= to;
}

}  // namespace findspace::space
