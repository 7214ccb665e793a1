// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "formula/solid/csg_shapes.h"

#include <algorithm>
#include <numeric>

namespace findspace::formula {

namespace {

bool any_cut(std::span<const SpaceShape> shapes) {
  return std::any_of(shapes.begin(), shapes.end(), [](const SpaceShape& s) { return s.cut != nullptr; });
}

bool bounded(const SpaceShape& shape) { return shape.cut || (shape.body && !shape.body->outside); }

space::Body whole_of(std::span<const SpaceShape> shapes) {
  std::vector<const space::Body*> all;
  for (const SpaceShape& s : shapes) all.push_back(s.body.get());
  return united(all);
}

space::CsgSolid cut_of(std::span<const SpaceShape> shapes) {
  const auto form = [](const SpaceShape& s) { return s.cut ? *s.cut : space::uncut(*s.body); };
  space::CsgSolid out = form(shapes[0]);
  for (const SpaceShape& s : shapes.subspan(1)) out = united(out, form(s));
  return out;
}

}  // namespace

CsgShapes csg_shapes(std::span<const SpaceShape> moving, std::span<const SpaceShape> fixed) {
  CsgShapes out;
  const bool cut_moves = any_cut(moving);
  if (cut_moves == any_cut(fixed)) return out;
  if (!std::all_of(moving.begin(), moving.end(), bounded) || !std::all_of(fixed.begin(), fixed.end(), bounded))
    return out;
  const space::Body whole = whole_of(cut_moves ? fixed : moving);
  const space::CsgSolid cut = cut_of(cut_moves ? moving : fixed);
  out.scale = std::lcm(whole.scale, cut.scale);
  out.pair = std::make_unique<distance::CsgPair>(
      std::make_shared<const space::Body>(space::at_scale(whole, out.scale)),
      std::make_shared<const space::CsgSolid>(space::at_scale(cut, out.scale)), cut_moves);
  return out;
}

}  // namespace findspace::formula
