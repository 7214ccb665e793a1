// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Regions and instants that are known between bounds. Values only. Keywords: inner and outer approximation.
#pragma once

#include <optional>

#include "plane/complex/cell_complex.h"
#include "plane/query/section.h"

namespace findspace::formula {

/// Positions that certainly and that possibly belong to a region.
struct RegionBounds {
  plane::Region inner, outer;
};

/// A region as far as it is known: exactly, or what certainly belongs and, in `outer`, what may.
struct SolvedRegion {
  plane::Region region;
  std::optional<plane::Region> outer{};
  /// With `outer`: as distances are compared with each other; else as shapes rotate, or distances are in rotation.
  bool compared = false;
};

/// Instants that certainly and that possibly belong.
struct InstantBounds {
  plane::Section inner, outer;
};

/// Instants as far as they are known, likewise.
struct SolvedInstants {
  plane::Section instants;
  std::optional<plane::Section> outer;
};

}  // namespace findspace::formula
