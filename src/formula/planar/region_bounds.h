// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Regions and instants that are known between bounds. Values only. Keywords: inner and outer approximation.
#pragma once

#include "plane/complex/cell_complex.h"
#include "plane/query/section.h"

namespace findspace::formula {

/// Positions that certainly and that possibly belong to a region.
struct RegionBounds {
  plane::Region inner, outer;
};

/// Instants that certainly and that possibly belong.
struct InstantBounds {
  plane::Section inner, outer;
};

}  // namespace findspace::formula
