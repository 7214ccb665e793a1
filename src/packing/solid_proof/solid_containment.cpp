// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/solid_proof/solid_containment.h"

#include <algorithm>
#include <numeric>

#include "packing/solid_proof/solid_pair_proof.h"
#include "space/surface/surface_side.h"

namespace findspace::packing {
namespace {

std::int64_t scale_of_surface(const SolidForm& form) {
  return form.surface.empty() ? form.body.scale : form.surface_scale;
}

}  // namespace

SolidContainment::SolidContainment(const SolidProblem& problem, const SolidContainer& container, const SolidForm& form)
    : steps_(bounded_product(problem.steps(), scale_of_surface(form))),
      container_(surfaces_of(*container.inside, scale_of_surface(form))),
      form_(surfaces_of(form, scale_of_surface(form))),
      gaps_(container_, form_) {}

space::RealVector SolidContainment::in_steps(const std::array<Fraction, 3>& at) const {
  return {packing::in_steps(at[0], steps_), packing::in_steps(at[1], steps_), packing::in_steps(at[2], steps_)};
}

bool SolidContainment::holds(const std::array<Fraction, 3>& at, const Fraction& edge) const {
  const space::RealVector p = in_steps(at);
  if (gaps_.relation(p) != space::SurfaceGaps::Relation::kInside) return false;
  return edge == 0 || !(gaps_.gap(p, gaps_.near(p)).value < packing::in_steps(edge, steps_));
}

double SolidContainment::excess(const std::array<Fraction, 3>& at, const Fraction& edge) const {
  const space::RealVector p = in_steps(at);
  const double steps = double(steps_);
  if (gaps_.relation(p) == space::SurfaceGaps::Relation::kInside)
    return edge.to_double() - gaps_.gap(p, gaps_.near(p)).value.to_double() / steps;
  const space::SurfaceSet::Sheet& walls = *container_->sheets()[0];
  double most = 0;
  const auto look_at = [&](const space::Point& q, double radius) {
    const space::RealVector x = space::plus(space::real(q), p);
    const double far = space::length(space::rounded(space::way_to(walls, x)));
    const bool held = space::side_of(walls.body, walls.tree, x, space::rounded(x)) == space::SurfaceSide::kInside;
    most = std::max(most, (held ? radius - far : radius + far) / steps);
  };
  for (const auto& sheet : form_->sheets())
    for (const space::Point& q : sheet->body.points) look_at(q, 0);
  for (const space::SurfaceSet::Ball& ball : form_->balls()) look_at(ball.center, ball.radius.to_double());
  return most;
}

}  // namespace findspace::packing
