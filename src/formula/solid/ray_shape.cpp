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
using space::RaySolid;

const std::vector<RaySolid>* RayShape::solids() const {
  std::call_once(made_->solids_once, [&] {
    try {
      made_->solids = space::ray_solids(*shape_);
    } catch (const Error& e) {
      if (e.code() == ErrorCode::kUnsupported) return;
      // A surface that meets itself in edges or faces may still have convex parts.
      if (e.code() != ErrorCode::kGeometry || !has_body()) throw;
    }
  });
  return made_->solids ? &*made_->solids : nullptr;
}

bool RayShape::has_body() const {
  try {
    body();
    return true;
  } catch (const Error&) {
    return false;
  }
}

bool RayShape::outside() const {
  if (solids()) return false;
  return has_body() ? body().outside : space::shape_box(*shape_).unbounded;
}

const space::Body& RayShape::body() const {
  std::call_once(made_->body_once, [&] {
    const SpaceShape made = space_shape(*shape_);
    if (!made.body) throw Error(ErrorCode::kUnsupported, made.refused, shape_->place);
    made_->body = made.body.pointer();
  });
  return *made_->body;
}

void RayShape::extend_box(space::Point& low, space::Point& high, bool& any) const {
  if (const auto* surfaces = solids()) return space::extend_box(*surfaces, low, high, any);
  if (!has_body()) {
    const space::ShapeBox box = space::shape_box(*shape_);
    space::extend_box(box.low, low, high, any);
    return space::extend_box(box.high, low, high, any);
  }
  const space::Bounds3 box = bounds(body());
  const Real scale(body().scale);
  const auto corner = [&](const space::RealVector& p, const Real& round_up) {
    std::array<std::int64_t, 3> c{};
    for (std::size_t k = 0; k < 3; ++k) c[k] = static_cast<std::int64_t>(exact::floor(p[k] / scale + round_up));
    return space::Point{c[0], c[1], c[2]};
  };
  space::extend_box(corner(box.low, Real()), low, high, any);
  space::extend_box(corner(box.high, Real(1)), low, high, any);
}

}  // namespace findspace::formula
