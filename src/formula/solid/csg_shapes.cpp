// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "formula/solid/csg_shapes.h"

#include <algorithm>

#include "distance/rays/ray_directional.h"
#include "distance/rays/ray_directional_least.h"
#include "distance/rays/ray_signs.h"
#include "distance/solid/solid_least.h"
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

namespace {

using BodyPointer = std::shared_ptr<const space::Body>;
using Beside = std::function<distance::BesideBody(BodyPointer)>;

/// Of a body in the place of a solid beside another solid.
Beside beside_cut(std::shared_ptr<const space::CsgSolid> other, std::int64_t scale, bool moves) {
  return [=](BodyPointer body) {
    const auto side = std::make_shared<const distance::CsgSide>(body, other);
    const CsgShapes shapes{scale, std::move(body), other, !moves};
    distance::BesideBody out{csg_pair(side, false), {}, {}, {}};
    out.map = [shapes](distance::Which which, const exact::Real& level, const std::optional<distance::AlongWay>& way,
                       const space::RayGrid& grid) -> exact::Tried<space::RaySourcePointer> {
      space::RaySourcePointer rays = csg_map(which, level, shapes, grid, way);
      if (!rays) return exact::Refusal(kNoMapAlong);
      return rays;
    };
    out.least = [=](distance::Which which) { return csg_least(which, side, !moves); };
    out.least_along = [=](distance::Which which, const distance::AlongWay& way) {
      return csg_directional_least(which, side, !moves, way.direction, way.both);
    };
    return out;
  };
}

/// The same beside a body.
Beside beside_body(BodyPointer other, bool moves) {
  return [=](BodyPointer body) {
    const auto both = moves ? std::make_shared<const distance::BodiesOnLines>(*body, *other)
                            : std::make_shared<const distance::BodiesOnLines>(*other, *body);
    distance::BesideBody out{distance::solid_pair(std::move(body), other), {}, {}, {}};
    out.map = [both](distance::Which which, const exact::Real& level, const std::optional<distance::AlongWay>& way,
                     const space::RayGrid& grid) -> exact::Tried<space::RaySourcePointer> {
      if (way) return distance::ray_directional_map(which, level, way->direction, way->both, *both, grid);
      return distance::ray_sign_map(which, level, both->b(), both->a(), grid);
    };
    out.least = [both](distance::Which which) { return distance::solid_least(which, both->b(), both->a()); };
    out.least_along = [both](distance::Which which, const distance::AlongWay& way) {
      return distance::ray_directional_least(which, way.direction, way.both, both->b(), both->a());
    };
    return out;
  };
}

/// Of the shapes of one side in one form.
struct OneSide {
  std::shared_ptr<const space::CsgSolid> cut;
  BodyPointer body;

  std::int64_t scale() const { return cut ? cut->scale : body->scale; }
  OneSide at(std::int64_t to) const {
    if (cut) return {std::make_shared<const space::CsgSolid>(at_scale(*cut, to)), nullptr};
    return {nullptr, std::make_shared<const space::Body>(space::at_scale(*body, to))};
  }
  OneSide mirrored() const {
    if (cut) return {std::make_shared<const space::CsgSolid>(space::mirrored(*cut)), nullptr};
    return {nullptr, std::make_shared<const space::Body>(space::mirrored(*body))};
  }
  exact::Real size() const {
    const space::Bounds3 box = cut ? bounds(*cut) : bounds(*body);
    const space::RealVector across = space::minus(box.high, box.low);
    return across[0] + across[1] + across[2];
  }
  Beside beside(std::int64_t scale, bool moves) const {
    return cut ? beside_cut(cut, scale, moves) : beside_body(body, moves);
  }
};

/// Nothing where a complement is among several.
std::optional<OneSide> one_side(std::span<const SpaceShape> shapes) {
  if (!std::all_of(shapes.begin(), shapes.end(), bounded)) {
    if (shapes.size() != 1 || !shapes[0].body) return std::nullopt;
    return OneSide{nullptr, shapes[0].body.pointer()};
  }
  if (any_cut(shapes)) return OneSide{std::make_shared<const space::CsgSolid>(cut_of(shapes)), nullptr};
  return OneSide{nullptr, std::make_shared<const space::Body>(whole_of(shapes))};
}

}  // namespace

distance::TriedAnswer CutBetween::value(distance::Which asked, const space::RealVector& p) const {
  return of.pair().try_value(which(asked), p);
}

std::optional<CutBetween> cut_between(std::span<const SpaceShape> moving, std::span<const SpaceShape> fixed) {
  if (!any_cut(moving) && !any_cut(fixed)) return std::nullopt;
  const auto all_bounded = [](std::span<const SpaceShape> some) {
    return std::all_of(some.begin(), some.end(), bounded);
  };
  // Of one cut shape and a bounded body all is told without.
  if (any_cut(moving) != any_cut(fixed) && all_bounded(moving) && all_bounded(fixed)) return std::nullopt;
  std::optional<OneSide> b = one_side(moving), a = one_side(fixed);
  if (!b || !a) return std::nullopt;
  const bool back = b->body && b->body->outside;
  if (back) {
    std::swap(b, a);
    b = b->mirrored();
    a = a->mirrored();
  }
  const std::int64_t scale = space::joint_scale(b->scale(), a->scale());
  b = b->at(scale);
  a = a->at(scale);
  std::vector<distance::ReplacedSolid> solids;
  if (b->cut) solids.push_back({b->cut, a->beside(scale, true), true});
  if (a->cut) solids.push_back({a->cut, b->beside(scale, false), false});
  return CutBetween{distance::DistancesBetween(std::move(solids), b->size() + a->size()), scale, back};
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
