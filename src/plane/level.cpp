// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/level.h"

#include <algorithm>

#include "plane/minkowski.h"
#include "plane/overlay.h"
#include "plane/primitives.h"

namespace findspace::plane {

SignMap distance_map(const Region& closed, const exact::Real& radius) {
  if (closed.edges.empty() && closed.vertices.empty()) return CellComplex::uniform(closed.faces[0].mark > 0 ? -1 : 1);
  // {d < r} = C (+) int rK, {d <= r} = C (+) rK.
  return contact_map(closed, region_of_disc(0, 0, radius));
}

SignMap level_map(const SignMap& base, const exact::Real& level) {
  int side = level.sign();
  if (side == 0) return base;
  if (side > 0) return distance_map(remark(base, [](Mark m) { return Mark(m <= 0); }), level);
  SignMap outside = distance_map(remark(base, [](Mark m) { return Mark(m >= 0); }), -level);
  return remark(std::move(outside), [](Mark m) { return Mark(-m); });
}

}  // namespace findspace::plane
