// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// RayShape: a shape as closed surfaces, or as convex parts, or (of its box alone) as it is stated.
#include <findspace/error.h>

#include "formula/solid/solve_rays.h"
#include "formula/solid/solve_space.h"
#include "space/shape/shape_rays.h"

namespace findspace::formula {

using exact::Real;
using exact::Tried;
using space::RaySolid;

const std::vector<RaySolid>* RayShape::solids() const {
  std::call_once(made_->solids_once, [&] {
    auto solids = space::try_ray_solids(*shape_);
    if (solids)
      made_->solids = *std::move(solids);
    else if (solids.refusal().fault() && !try_body())
      throw solids.refusal().error;  // without convex parts a surface that meets itself is an error
  });
  return made_->solids ? &*made_->solids : nullptr;
}

bool RayShape::outside() const {
  if (solids()) return false;
  const Tried<const space::Body*> whole = try_body();
  return whole ? (*whole)->outside : space::shape_box(*shape_).unbounded;
}

namespace {

/// A fault of the shape is a refusal too: its box may be known.
Tried<LazyBody::Pointer> body_of(const plane::Shape& shape) {
  const Tried<SpaceShape> made = try_space_shape(shape);
  if (!made) return made.refusal();
  if (!made->body) return exact::Refusal(made->refused);
  return made->body.try_pointer();
}

}  // namespace

Tried<const space::Body*> RayShape::try_body() const {
  std::call_once(made_->body_once, [&] { made_->body.emplace(body_of(*shape_)); });
  if (!*made_->body) return made_->body->refusal();
  return (*made_->body)->get();
}

void RayShape::extend_box(space::Point& low, space::Point& high, bool& any) const {
  if (const auto* surfaces = solids()) return space::extend_box(*surfaces, low, high, any);
  const Tried<const space::Body*> whole = try_body();
  if (!whole) {
    const space::ShapeBox box = space::shape_box(*shape_);
    space::extend_box(box.low, low, high, any);
    return space::extend_box(box.high, low, high, any);
  }
  const space::Bounds3 box = bounds(**whole);
  const Real scale((*whole)->scale);
  const auto corner = [&](const space::RealVector& p, const Real& round_up) {
    std::array<std::int64_t, 3> c{};
    for (std::size_t k = 0; k < 3; ++k) c[k] = static_cast<std::int64_t>(exact::floor(p[k] / scale + round_up));
    return space::Point{c[0], c[1], c[2]};
  };
  space::extend_box(corner(box.low, Real()), low, high, any);
  space::extend_box(corner(box.high, Real(1)), low, high, any);
}

}  // namespace findspace::formula
