// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Whether a formula holds far away, beyond all that lines are taken through: by the sign that each distance has there.
#include <algorithm>

#include "distance/solid/pair_distances.h"
#include "formula/language/evaluate.h"
#include "formula/language/which.h"
#include "formula/solid/solve_rays.h"

namespace findspace::formula {

bool holds_far_away(const RayWorld& world, const Formula& formula) {
  std::vector<std::int8_t> signs;
  for (const SignMap& map : formula.sign_maps()) {
    Distance d = moving_first(map.distance, world.moving);
    const bool second = second_is_moving(d, world.moving);
    if (second) std::swap(d.first, d.second);
    const auto any_outside = [&](const std::vector<std::string>& names) {
      return std::any_of(names.begin(), names.end(),
                         [&](const std::string& name) { return world.shapes.at(name).outside(); });
    };
    // Of a complement that moves the other one moves in it.
    const bool back = any_outside(d.first), outside = back || any_outside(d.second);
    const distance::Which asked = which(d.kind, second);
    const int level = map.level.sign();
    switch (back ? distance::exchanged(asked) : asked) {
      case distance::Which::kGamma1:  // in a complement far away all fits
      case distance::Which::kEta1:
      case distance::Which::kMu:
        signs.push_back(outside ? -1 : 1);
        break;
      case distance::Which::kD1:
      case distance::Which::kH:
        signs.push_back(static_cast<std::int8_t>(outside ? -level : 1));
        break;
      case distance::Which::kPenetration:
      case distance::Which::kDstarBack:
        signs.push_back(static_cast<std::int8_t>(outside ? 1 : -level));
        break;
      case distance::Which::kDstar:
        signs.push_back(static_cast<std::int8_t>(-level));
        break;
      default:
        signs.push_back(1);
    }
  }
  return evaluate(formula, signs);
}

}  // namespace findspace::formula
