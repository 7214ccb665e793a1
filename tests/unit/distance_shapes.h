// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Shapes for tests of distances, and a way to read sign maps.
#pragma once

#include <initializer_list>
#include <utility>
#include <vector>

#include "plane/complex/cell_complex.h"
#include "plane/complex/overlay.h"
#include "plane/complex/primitives.h"
#include "plane/contour/contour.h"
#include "plane/query/locate.h"

namespace findspace::testing {

using Corner = std::pair<std::int64_t, std::int64_t>;

inline plane::Contour ring(std::initializer_list<Corner> corners) {
  plane::Contour c;
  for (auto [x, y] : corners) c.push_back({.start = {x, y}});
  return c;
}

inline plane::Region polygon(std::initializer_list<Corner> outer,
                             std::vector<std::initializer_list<Corner>> holes = {}) {
  std::vector<plane::Contour> rings{ring(outer)};
  for (auto h : holes) rings.push_back(ring(h));
  return plane::region_of_rings(rings);
}

inline plane::Region box(std::int64_t x0, std::int64_t y0, std::int64_t x1, std::int64_t y1) {
  return polygon({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}});
}

inline exact::RealPoint at(std::int64_t x, std::int64_t y) { return {x, y}; }

inline int sign_at(const plane::SignMap& m, const exact::RealPoint& p) { return mark_of(m, locate(m, p)); }

}  // namespace findspace::testing
