// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/solid_proof/solid_bound.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "exact/margins/rounding.h"
#include "packing/proof/fewest_bins.h"

namespace findspace::packing {
namespace {

/// Six times the volume in front of the origin of a face's fan of triangles.
exact::Real six_volumes_of(const std::vector<space::Point>& ring) {
  exact::Real sum;
  for (std::size_t k = 1; k + 1 < ring.size(); ++k)
    sum += exact::Real(exact::dot(exact::cross(ring[k] - ring[0], ring[k + 1] - ring[0]), ring[0]));
  return sum;
}

exact::Real six_volumes_of(const space::Polytope& polytope) {
  exact::Real sum;
  for (int f = 0; f < polytope.facet_count(); ++f) {
    std::vector<space::Point> ring;
    for (const int v : polytope.circuit(f))
      ring.push_back(polytope.vertices()[std::size_t(v)] - polytope.vertices()[0]);
    sum += six_volumes_of(ring);
  }
  return sum;
}

/// Eight times pi times the cube of the radius, or less.
exact::Real six_volumes_of_ball(const exact::Real& radius) {
  const exact::Real below_pi = exact::Real::ratio(314159265358979, 100000000000000);
  return exact::Real(8) * below_pi * radius * radius * radius;
}

/// Of what its surfaces enclose, in cubic units.
exact::Real surface_volume(const SolidProblem& problem, const SolidForm& form) {
  exact::Real sum;
  const exact::Real steps = exact::Real(problem.steps()) * exact::Real(form.surface_scale);
  for (const space::RaySolid& solid : form.surface)
    for (const auto& face : solid.surface.faces) {
      const auto& points = solid.surface.points;
      sum += six_volumes_of({points[std::size_t(face[0])] - points[0], points[std::size_t(face[1])] - points[0],
                             points[std::size_t(face[2])] - points[0]});
    }
  return sum / (exact::Real(6) * steps * steps * steps);
}

/// Of a part, in cubic units, or less where it has balls that may overlap others.
exact::Real exact_volume(const SolidProblem& problem, const SolidPart& part) {
  exact::Real sum, most;
  const SolidForm& form = part.forms[0];
  if (!form.is_exact()) return surface_volume(problem, form);
  const exact::Real unit(problem.steps()), steps = unit * exact::Real(form.body.scale);
  for (const space::BodyPart& piece : form.body.parts) {
    const exact::Real volume = piece.core ? six_volumes_of(*piece.core) : six_volumes_of_ball(piece.radius);
    sum += volume;
    if (most < volume) most = volume;
  }
  const exact::Real found = (part.disjoint ? sum : most) / (exact::Real(6) * steps * steps * steps);
  return part.flat_volume ? std::max(found, *part.flat_volume / (unit * unit * unit)) : found;
}

/// Of a part and half the gap about it, in cubic units, rounded down: of all sets of its volume a ball has the least.
exact::Real least_volume(const SolidProblem& problem, const SolidPart& part) {
  const exact::Real volume = exact_volume(problem, part);
  if (problem.gap == Fraction(0)) return volume;
  const double ball = std::cbrt(4 * std::numbers::pi / 3);
  const double side = std::cbrt(volume.to_double()) + ball * problem.gap.to_double() / 2;
  return exact::Real::from_double(side * side * side * (1 - margin::kRoundings16));
}

/// Of the forms that fit the floor.
Fraction least_height(const SolidProblem& problem, const SolidPart& part) {
  std::optional<Fraction> least;
  for (const SolidForm& form : part.forms) {
    const SolidBox box = box_of(problem, form);
    if (fits(problem, box)) least = std::min(least.value_or(box.high[2] - box.low[2]), box.high[2] - box.low[2]);
  }
  return least.value_or(0);
}

/// Of polytopes that do not overlap, in cubic units.
exact::Real cells_volume(const SolidProblem& problem, const SolidForm& cells) {
  exact::Real sum;
  for (const space::BodyPart& cell : cells.body.parts) sum += six_volumes_of(*cell.core);
  const exact::Real steps = exact::Real(problem.steps()) * exact::Real(cells.body.scale);
  return sum / (exact::Real(6) * steps * steps * steps);
}

/// What one that is no box holds, or more.
exact::Real most_inside(const SolidProblem& problem, const SolidContainer& container) {
  const SolidForm& inside = *container.inside;
  if (!inside.surface.empty()) return surface_volume(problem, inside);
  exact::Real least = 1;
  for (const Fraction& side : {container.width, container.depth, container.height}) least = least * in_steps(side, 1);
  if (inside.has_balls()) {
    const exact::Real above_pi = exact::Real::ratio(314159265358980, 100000000000000);
    const exact::Real steps = exact::Real(problem.steps()) * exact::Real(inside.body.scale);
    for (const space::BodyPart& ball : inside.body.parts) {
      const exact::Real radius = ball.radius / steps;
      least = std::min(least, exact::Real::ratio(4, 3) * above_pi * radius * radius * radius);
    }
    return least;
  }
  return container.lacks->has_balls() ? least : least - cells_volume(problem, *container.lacks);
}

/// What solids, with half the gap about them, can fill at most, in cubic units: of the box about it what the edge
/// leaves. Where the edge is less than half the gap, that is of the box alone.
exact::Real most_volume(const SolidProblem& problem, const SolidContainer& container) {
  exact::Real within = 1;
  for (const Fraction& side : {container.width, container.depth, container.height}) {
    const Fraction left = side - problem.edge - problem.edge;
    if (left <= Fraction(0)) return {};
    within = within * in_steps(left + problem.gap, 1);
  }
  if (!container.inside || problem.edge + problem.edge < problem.gap) return within;
  const exact::Real whole = most_inside(problem, container);
  return within < whole ? within : whole;
}

Fraction fewest_containers(const SolidProblem& problem) {
  std::vector<Alike> containers, parts;
  std::size_t fixed = 0;
  for (std::size_t k = 0; k < problem.containers.size(); ++k) {
    const SolidContainer& container = problem.containers[k];
    containers.push_back({most_volume(problem, container), std::size_t(container.count)});
    fixed += containers_with_fixed(problem, k);
  }
  for (const SolidPart& part : problem.parts) parts.push_back({least_volume(problem, part), std::size_t(part.demand)});
  return Fraction(int128(std::max(fixed, fewest_bins(std::move(containers), std::move(parts)))));
}

/// The greatest decimal of nine digits that is not above the value.
Fraction rounded_down(const exact::Real& value) {
  constexpr std::int64_t kDecimals = 1000000000;
  return Fraction(exact::floor(value * exact::Real(kDecimals)), kDecimals);
}

}  // namespace

Fraction lower_bound(const SolidProblem& problem) {
  if (problem.in_containers()) return fewest_containers(problem);
  Fraction tallest;
  exact::Real sum;
  for (const SolidPart& part : problem.parts) {
    if (part.demand == 0) continue;
    tallest = std::max(tallest, least_height(problem, part));
    sum += exact::Real(part.demand) * least_volume(problem, part);
  }
  const Fraction width = problem.width - problem.edge - problem.edge,
                 depth = problem.depth - problem.edge - problem.edge;
  Fraction top;  // of what is fixed
  if (!problem.fixed.empty()) top = layout_of_fixed(problem).height;
  // What lies within half the gap of solids lies within so much of what the edge leaves.
  const exact::Real floor = in_steps(width + problem.gap, 1) * in_steps(depth + problem.gap, 1);
  const Fraction by_volume = rounded_down(sum / floor - in_steps(problem.gap, 1));
  return std::max(std::max(tallest, by_volume) + problem.edge + problem.edge, top);
}

}  // namespace findspace::packing
