// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "situation/cut_shapes.h"

#include <numeric>

namespace findspace::situation {

CutShapes cut_shapes(std::span<const SpaceShape> moving, std::span<const SpaceShape> fixed) {
  CutShapes out;
  if (moving.size() != 1 || fixed.size() != 1) return out;
  const bool cut_moves = moving[0].cut != nullptr;
  const SpaceShape &whole = cut_moves ? fixed[0] : moving[0], &cut = cut_moves ? moving[0] : fixed[0];
  if (!cut.cut || !whole.body || whole.body->outside) return out;
  out.scale = std::lcm(whole.body->scale, cut.cut->scale);
  out.pair = std::make_unique<distance::CutPair>(
      std::make_shared<const space::Body>(space::at_scale(*whole.body, out.scale)),
      std::make_shared<const space::CutBody>(space::at_scale(*cut.cut, out.scale)), cut_moves);
  return out;
}

}  // namespace findspace::situation
