// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The nearest feasible position from contacts alone, in the plane and in space. All atoms must hold, and those that
// fail compare gamma1, eta1, delta1 or a directed distance (mu, h, hausdorff) with a number. Such a distance f changes
// no faster than the position, so no position with the level is nearer to p than |f(p) - level|; one that is as near
// lies on the line through p and the nearest contact (of a directed distance: as its two points show), and it is the
// answer if f has the level there (beyond it, too, for `<` and `>`, which it bounds) and the other atoms hold. Of a gap
// that is too small, where contacts end at edges and corners, a search of the shapes grown by it finds the place
// (ContactWorld::apart). Guarantee: exact, but for that search, whose place is feasible and nearest but for its error;
// nothing where contacts do not decide. Cost: a few values at a position. Keywords: closest feasible configuration,
// minimum translation, penetration vector.
#pragma once

#include <functional>
#include <optional>

#include "formula/language/position_answers.h"

namespace findspace::formula {

/// What is asked of a world at positions of the scene.
struct ContactWorld {
  /// The distance; nothing where it is undefined, or not computed at once.
  std::function<std::optional<distance::SceneAnswer>(const Distance&, const distance::Coordinates&)> value;
  /// The sign of an atom's distance against its level; nothing where that is not known.
  std::function<std::optional<int>(std::size_t atom, const distance::Coordinates&)> sign;
  /// The nearest position with `distance >= level`; none, or nothing where that is not computed.
  std::function<std::optional<distance::Coordinates>(const Distance&, const exact::Real& level,
                                                     const distance::Coordinates&)>
      apart = {};
  /// Whether the distance is surely more than that, as far as it is quickly known.
  std::function<bool(const Distance&, const exact::Real&, const distance::Coordinates&)> more =
      [](const Distance&, const exact::Real&, const distance::Coordinates&) { return false; };
};

std::optional<NearestFeasible> nearest_by_contact(const ContactWorld& world, const Formula& formula,
                                                  const distance::Coordinates& p);

}  // namespace findspace::formula
