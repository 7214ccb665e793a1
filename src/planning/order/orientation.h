// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// How a placed body is rotated about its pole: by degrees (in space about the z axis), or in space by any rotation.
// Guarantee: a value, exact. Keywords: orientation.
#pragma once

#include <optional>
#include <string>

#include "exact/number/real.h"
#include "space/shape/rotation.h"

namespace findspace::planning {

struct Orientation {
  exact::Real degrees;
  std::optional<space::Rotation> rotation{};  // instead of degrees
  std::string text{};                         // of the rotation, for reports

  Orientation() = default;
  Orientation(exact::Real angle) : degrees(std::move(angle)) {}  // NOLINT: a number of degrees is a turn
  Orientation(space::Rotation r, std::string words) : rotation(std::move(r)), text(std::move(words)) {}

  /// Whether the body stands as it is drawn.
  bool none() const { return !rotation && degrees.sign() == 0; }
  space::Rotation in_space() const {
    return rotation ? *rotation : space::Rotation::about_axis(2, degrees, space::Point{});
  }
};

}  // namespace findspace::planning
