// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The ring of a sum that has only one, as most sums of two polygons. Keywords: simply connected.
#pragma once

#include <array>

#include "plane/complex/ring_map.h"

namespace findspace::plane {

/// It runs counter-clockwise round the only bounded face.
inline constexpr std::array<NestedRing, 1> kOneRing{{{.start = 0, .inside = 1, .outside = 0, .outer = true}}};

}  // namespace findspace::plane
