// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/grid/boundary_box.h"

#include <algorithm>
#include <limits>

namespace findspace::plane {

bool has_unbounded(std::span<const GridFace> faces) {
  return std::any_of(faces.begin(), faces.end(), [](const GridFace& f) { return f.unbounded; });
}

GridBox box_of(std::span<const GridFace> faces) {
  constexpr std::int64_t kFar = std::numeric_limits<std::int64_t>::max();
  GridBox w{kFar, kFar, -kFar, -kFar};
  for (const GridFace& f : faces)
    for (const GridCorner& c : f.corners) {
      w.x0 = std::min(w.x0, c.at.x);
      w.x1 = std::max(w.x1, c.at.x);
      w.y0 = std::min(w.y0, c.at.y);
      w.y1 = std::max(w.y1, c.at.y);
    }
  return w;
}

std::optional<GridBox> boundary_box(std::span<const GridFace> a, std::span<const GridFace> b) {
  if (has_unbounded(b)) return has_unbounded(a) ? std::nullopt : boundary_box(b, a);
  auto corners = [](const GridFace& f) { return !f.corners.empty(); };
  if (std::none_of(a.begin(), a.end(), corners) || std::none_of(b.begin(), b.end(), corners)) return std::nullopt;
  const GridBox p = box_of(a), q = box_of(b);
  const bool all = has_unbounded(a);
  GridBox w{p.x0 + (all ? q.x1 : q.x0) - 1, p.y0 + (all ? q.y1 : q.y0) - 1, p.x1 + (all ? q.x0 : q.x1) + 1,
            p.y1 + (all ? q.y0 : q.y1) + 1};
  if (w.x1 - w.x0 < 2 || w.y1 - w.y0 < 2) return std::nullopt;
  return w;
}

}  // namespace findspace::plane
