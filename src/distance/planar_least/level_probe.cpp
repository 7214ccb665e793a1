// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/planar_least/level_probe.h"

#include <algorithm>
#include <array>

#include "plane/complex/overlay.h"
#include "plane/query/topology.h"

namespace findspace::distance {

using plane::CellComplex;
using plane::Mark;

CellComplex probe(const PositionFunction& f, const exact::Real& level, const plane::Region& over, int rotation) {
  plane::SignMap m = f.sign_map(level);
  const auto rule = [rotation](Mark k) { return Mark(rotation * k < 0 ? kBeyond : k == 0 ? kOn : 0); };
  if (plane::is_whole(over)) return plane::remark(std::move(m), rule);
  const std::array<const CellComplex*, 2> both{&m, &over};
  return plane::overlay(both, [&](std::span<const Mark> k) { return k[1] > 0 ? rule(k[0]) : Mark(0); });
}

plane::Region on_level(CellComplex probed) {
  return plane::remark(std::move(probed), [](Mark k) { return Mark(k == kOn); });
}

}  // namespace findspace::distance
