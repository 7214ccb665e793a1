// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Which shapes are copies of each other: rings and discs that are the same but for a translation, wherever each ring
// begins and in whichever order the holes stand. Guarantee: what counts as alike is the same set, moved. Shapes of
// other kinds are alike to themselves alone. Cost: O(n log n) in the corners. Keywords: congruence, duplicate outlines.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "plane/contour/shape.h"

namespace findspace::plane {

/// For each shape the first that is alike: itself, or one before it.
std::vector<std::size_t> first_alike(std::span<const ShapePtr> shapes);

}  // namespace findspace::plane
