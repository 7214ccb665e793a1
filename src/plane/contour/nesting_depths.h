// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// How deep rings lie in each other: what tells on which side of each the material of an even-odd set is.
#pragma once

#include <cstddef>
#include <vector>

#include "plane/contour/shape.h"

namespace findspace::plane {

/// Which of the other rings go round each ring. No two of them cross; corners may be common. Cost: pairs of boxes
/// that hold a corner, times the edges of the outer one.
std::vector<std::vector<std::size_t>> rings_around(const std::vector<Contour>& rings);
/// How many they are.
std::vector<std::size_t> nesting_depths(const std::vector<Contour>& rings);

}  // namespace findspace::plane
