// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Solids to be packed in tests.
#pragma once

#include <utility>
#include <vector>

#include "packing/solid_problem/solid_problem.h"

namespace findspace::packing {

inline SolidPart part_of(const char* name, int demand, std::vector<space::BodyPart> parts) {
  SolidPart part{.name = name, .demand = demand, .forms = {}};
  part.forms.emplace_back().body.parts = std::move(parts);
  return part;
}

inline space::BodyPart block(const space::Point& low, const space::Point& high) {
  std::vector<space::Point> corners;
  for (int k = 0; k < 8; ++k)
    corners.push_back({k & 1 ? high.x : low.x, k & 2 ? high.y : low.y, k & 4 ? high.z : low.z});
  return space::part_of(corners, {});
}

inline SolidPart box(const char* name, int demand, int w, int d, int h) {
  return part_of(name, demand, {block({0, 0, 0}, {w, d, h})});
}

/// As it is given, and turned in all ways.
inline SolidPart with_turns(SolidPart part) {
  const SolidForm form = part.forms[0];
  part.forms.clear();
  for (const SolidRotation& rotation : axis_rotations(false)) part.forms.push_back(turned(form, rotation));
  return part;
}

}  // namespace findspace::packing
