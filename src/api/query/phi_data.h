// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What stands behind a public Phi: of the plane by convex parts or curves (shape_phi.h), of space by convex parts.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "api/values/shape_data.h"
#include "distance/planar/shape_phi.h"
#include "findspace/error.h"
#include "findspace/phi.h"
#include "space/body/rounded_phi.h"

namespace findspace {

struct Phi::Data {
  Shape first, second;
  std::size_t a = 0, b = 0;                    // convex parts
  std::optional<distance::ShapePhi> planar{};  // one of these two
  std::optional<space::RoundedPhi> solid{};
  exact::Real step{};                       // of space: one unit of the coordinates in the shapes' unit
  std::array<Shape::Rounded, 2> rounded{};  // of space: vertices of convex parts

  const distance::ShapePhi& plane() const {
    if (!planar) throw Error(ErrorCode::kBadValue, "a position of these shapes has three coordinates");
    return *planar;
  }
  const space::RoundedPhi& space() const {
    if (!solid) throw Error(ErrorCode::kBadValue, "a position of these shapes has two coordinates");
    return *solid;
  }
};

}  // namespace findspace
