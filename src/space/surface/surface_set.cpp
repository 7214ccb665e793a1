// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/surface/surface_set.h"

#include <findspace/error.h>

#include <algorithm>

namespace findspace::space {

using exact::Real;

bool SurfaceSet::add(const std::vector<RaySolid>& solids, std::int64_t scale) {
  const auto near = [&](const Point& p) { return in_ray_range(p, scale); };
  for (const RaySolid& s : solids) {
    if (!std::all_of(s.surface.points.begin(), s.surface.points.end(), near) || (s.ball() && !near(s.center)))
      return false;
    inner_walls_ = inner_walls_ || s.inner_walls;
    if (s.ball())
      balls_.push_back({{s.center.x * scale, s.center.y * scale, s.center.z * scale}, s.radius * Real(scale)});
    else
      sheets_.push_back(scale == 1 ? sheet_of(s) : std::make_shared<const Sheet>(scaled(s.surface, scale)));
  }
  return true;
}

bool SurfaceSet::add(const Body& body, std::int64_t scale) {
  if (body.outside) return false;
  const auto near = [&](const Point& p) { return in_ray_range(p, scale / body.scale); };
  for (const BodyPart& part : body.parts) {
    if (!near(part.center) || !std::all_of(part.vertices().begin(), part.vertices().end(), near)) return false;
  }
  for (const BodyPart& part : at_scale(body, scale).parts) {
    if (part.point())
      balls_.push_back({part.center, part.radius});
    else if (part.core && part.radius.sign() == 0)
      sheets_.push_back(std::make_shared<const Sheet>(triangles(*part.core)));
    else
      return false;
  }
  return true;
}

Bounds3 SurfaceSet::box() const {
  Point low = sheets_[0]->body.low, high = sheets_[0]->body.high;
  for (const auto& sheet : sheets_) {
    const Point &l = sheet->body.low, &h = sheet->body.high;
    low = {std::min(low.x, l.x), std::min(low.y, l.y), std::min(low.z, l.z)};
    high = {std::max(high.x, h.x), std::max(high.y, h.y), std::max(high.z, h.z)};
  }
  return {real(low), real(high)};
}

std::shared_ptr<const Body> SurfaceSet::hull(std::int64_t scale) const {
  if (!has_hull()) return nullptr;
  std::vector<Point> points;
  for (const auto& sheet : sheets_) points.insert(points.end(), sheet->body.points.begin(), sheet->body.points.end());
  Body out;
  out.scale = scale;
  out.parts.push_back(part_of(points, Real()));
  return std::make_shared<const Body>(std::move(out));
}

bool seen_not_convex(const std::vector<RaySolid>& solids) {
  if (solids.size() != 1 || solids[0].ball()) return true;
  const auto sheet = sheet_of(solids[0]);
  const RayBody& body = sheet->body;
  return body.pieces > 1 ||
         std::any_of(body.edges.begin(), body.edges.end(), [](const RayEdge& e) { return e.bend < 0; });
}

}  // namespace findspace::space
