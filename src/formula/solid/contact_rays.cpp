// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "formula/solid/contact_rays.h"

#include "distance/rays/value_rays.h"
#include "distance/surface/surface_pair.h"

namespace findspace::formula {

using distance::Answer;
using distance::Between;
using exact::Real;
using space::RealVector;
using space::SurfaceSet;
using space::Vector;

namespace {

/// Positions about one of contact are no deeper, no farther from it, than they are from that one; those far from a
/// place where a shape fits have it that far.
std::optional<distance::SignBall> ball(distance::Which which, const distance::Answer& value, const Real& level) {
  if (!value.nearest) return std::nullopt;
  const bool farthest = which == distance::Which::kEta2 || which == distance::Which::kDelta2;
  const int sign = which == distance::Which::kGamma1 || farthest ? 1 : -1;
  return distance::SignBall{space::rounded(*value.nearest), abs(level).to_double(), sign, farthest};
}

distance::Surfaced surfaced(const space::RaySolid& solid) {
  auto set = std::make_shared<SurfaceSet>();
  set->add({solid}, 1);
  return {set, distance::Outline::of(set, 1), space::is_convex(solid)};
}

}  // namespace

space::RaySourcePointer contact_rays(distance::Which which, const space::RaySolid& b, const space::RaySolid& a,
                                     const Real& level, const space::RayGrid& grid) {
  const distance::Surfaced of_b = surfaced(b), of_a = surfaced(a);
  const space::RayBody &body_a = of_a.surface->sheets()[0]->body, &body_b = of_b.surface->sheets()[0]->body;
  const Vector low = exact::approx(body_a.low - body_b.high), high = exact::approx(body_a.high - body_b.low);
  // Beyond this the bodies are farther apart than the level, and every distance is more than that.
  const double size = space::length(high - low) + std::fabs(level.to_double()) + 1;
  const distance::PairDistances pair = surface_pair(of_b, of_a);
  const distance::RayRule rule = [pair, which, level](const RealVector& p) -> distance::TriedBetween {
    const distance::TriedAnswer decided = pair.try_value(which, p);
    if (!decided) return exact::Refusal("where two surfaces touch was not found within the limit");
    const std::optional<Answer>& found = *decided;
    if (!found) return std::nullopt;
    const double gap = (found->value - level).to_double(), error = found->error;
    return Between{gap - error, gap + error, ball(which, *found, level)};
  };
  return std::make_unique<distance::ValueRays>(rule, space::scaled(0.5, space::plus(low, high)), size, 1, grid);
}

}  // namespace findspace::formula
