// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/solid_proof/solid_bound.h"

#include <algorithm>
#include <cmath>

#include "exact/margins/packing.h"

namespace findspace::packing {
namespace {

/// Of a part, not more than it has.
double least_volume(const SolidProblem& problem, const SolidPart& part) {
  const double steps = double(problem.steps()) * double(part.body.scale);
  double sum = 0, most = 0;
  for (const space::BodyPart& piece : part.body.parts) {
    const double volume = piece.core ? piece.core->volume() : 0;
    sum += volume;
    most = std::max(most, volume);
  }
  return (part.disjoint ? sum : most) / steps / steps / steps;
}

}  // namespace

Fraction lower_bound(const SolidProblem& problem) {
  Fraction tallest;
  double sum = 0;
  for (const SolidPart& part : problem.parts) {
    if (part.demand == 0) continue;
    const SolidBox box = box_of(problem, part);
    tallest = std::max(tallest, box.high[2] - box.low[2]);
    sum += part.demand * least_volume(problem, part);
  }
  const double floor = (problem.width - problem.edge - problem.edge).to_double() *
                       (problem.depth - problem.edge - problem.edge).to_double();
  constexpr double kDecimals = 1000000;
  const double safe = std::floor(sum / floor * (1 - margin::kVolumeLost) * kDecimals);
  return std::max(tallest, Fraction(int128(safe), int128(kDecimals))) + problem.edge + problem.edge;
}

}  // namespace findspace::packing
