// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A board's file with some footprints at new positions. Only the numbers of (at ...) within these footprints change:
// their own, and where they are rotated the angles of their pads and texts, which count from the board's axes. All
// other bytes stay. Guarantee: positions are written as they are given, on KiCad's grid. Keywords: placement, back
// annotation.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "exact/number/real.h"
#include "plane/contour/shape.h"

namespace findspace::io {

struct NewPlace {
  plane::GridPoint at;  // of the anchor, in millionths of a millimetre
  exact::Real turn{};   // degrees to add, counter-clockwise as it is seen
};

/// `places`: by the names that the board's parts have. Throws Error where a name is none, or where a part has areas of
/// its own, which stand in the file where they are.
std::string moved_board(std::string_view text, const std::string& file, const std::map<std::string, NewPlace>& places);

}  // namespace findspace::io
