// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The integer coordinates of points that are grid points, though they may be given as crossings: unions of boxes have
// such corners. Guarantee: exact; other crossings may be grid points as well, and are not told. Keywords: lattice
// point.
#pragma once

#include <optional>

#include "exact/planar/geometry.h"

namespace findspace::exact {

struct GridCoordinates {
  std::int64_t x, y;
};

/// Of a point that is given by them, or as the crossing of a level and an upright grid line.
inline std::optional<GridCoordinates> grid_coordinates(const Geometry& g, const Point& p) {
  if (p.kind == Point::Kind::kGrid) return GridCoordinates{p.gx, p.gy};
  if (p.kind != Point::Kind::kCross) return std::nullopt;
  const SupportingCurve *level = &g.supporting_curves[p.i], *upright = &g.supporting_curves[p.j];
  if (level->a != 0) std::swap(level, upright);
  const auto is_grid_line = [](const SupportingCurve& k) { return !k.circle && k.grid && k.c == std::int64_t(k.c); };
  if (level->a != 0 || upright->b != 0 || !is_grid_line(*level) || !is_grid_line(*upright)) return std::nullopt;
  return GridCoordinates{std::int64_t(upright->c), std::int64_t(level->c)};
}

}  // namespace findspace::exact
