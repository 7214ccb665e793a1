// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "formula/solid/csg_shapes.h"

#include <algorithm>

#include "distance/csg/csg_between.h"
#include "distance/csg/csg_pair.h"
#include "space/body/cell_parts.h"

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
  out.cut_moves = any_cut(moving);
  if (out.cut_moves == any_cut(fixed)) return out;
  if (!std::all_of(moving.begin(), moving.end(), bounded) || !std::all_of(fixed.begin(), fixed.end(), bounded))
    return out;
  const space::Body whole = whole_of(out.cut_moves ? fixed : moving);
  const space::CsgSolid cut = cut_of(out.cut_moves ? moving : fixed);
  out.scale = space::joint_scale(whole.scale, cut.scale);
  out.complete = std::make_shared<const space::Body>(space::at_scale(whole, out.scale));
  out.cut = std::make_shared<const space::CsgSolid>(space::at_scale(cut, out.scale));
  return out;
}

std::shared_ptr<const distance::CsgSide> CsgShapes::side() const {
  return cut ? std::make_shared<const distance::CsgSide>(complete, cut) : nullptr;
}

std::optional<CutBetween> cut_between(std::span<const SpaceShape> moving, std::span<const SpaceShape> fixed) {
  using Solid = std::shared_ptr<const space::CsgSolid>;
  using BodyPointer = std::shared_ptr<const space::Body>;
  if (!any_cut(moving) || !std::all_of(moving.begin(), moving.end(), bounded)) return std::nullopt;
  const space::CsgSolid solid = cut_of(moving);
  const auto at = [](const space::CsgSolid& one, std::int64_t scale) {
    return std::make_shared<const space::CsgSolid>(at_scale(one, scale));
  };
  if (any_cut(fixed) && std::all_of(fixed.begin(), fixed.end(), bounded)) {
    const space::CsgSolid other = cut_of(fixed);
    const std::int64_t scale = space::joint_scale(solid.scale, other.scale);
    const Solid b = at(solid, scale), a = at(other, scale);
    const auto beside = [](Solid of) {
      return [of = std::move(of)](BodyPointer body) {
        return distance::csg_pair(std::make_shared<const distance::CsgSide>(std::move(body), of), false);
      };
    };
    return CutBetween{distance::pair_between({{b, beside(a), true}, {a, beside(b), false}}), scale};
  }
  if (fixed.size() != 1 || !fixed[0].body || !fixed[0].body->outside) return std::nullopt;
  const std::int64_t scale = space::joint_scale(solid.scale, fixed[0].body->scale);
  const BodyPointer a = std::make_shared<const space::Body>(at_scale(*fixed[0].body, scale));
  const auto beside = [a](BodyPointer body) { return distance::solid_pair(std::move(body), a); };
  return CutBetween{distance::pair_between({{at(solid, scale), beside, true}}), scale};
}

std::unique_ptr<space::RaySource> csg_map(distance::Which which, const exact::Real& level, const CsgShapes& shapes,
                                          const space::RayGrid& grid, const std::optional<distance::AlongWay>& way) {
  using distance::CsgSide;
  std::shared_ptr<const CsgSide> side;
  if (!shapes.cut_moves) {
    side = shapes.side();
  } else {
    // A + p in B is -B + p in -A.
    side = std::make_shared<const CsgSide>(std::make_shared<const space::Body>(mirrored(*shapes.complete)),
                                           std::make_shared<const space::CsgSolid>(mirrored(*shapes.cut)));
    which = distance::exchanged(which);
  }
  if (way) return cut_map_along(which, level, *way, std::move(side), shapes.scale, grid);
  return cut_map(which, level, std::move(side), shapes.scale, grid);
}

}  // namespace findspace::formula
