// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Equality of sets, by their symmetric difference.
#pragma once

#include <array>
#include <span>

#include "plane/complex/overlay.h"
#include "plane/query/topology.h"

namespace findspace::plane {

/// Nothing is in one and not in the other.
inline bool same_set(const Region& a, const Region& b) {
  return is_empty(
      overlay(std::array<const CellComplex*, 2>{&a, &b}, [](std::span<const Mark> m) { return Mark(m[0] != m[1]); }));
}

}  // namespace findspace::plane
