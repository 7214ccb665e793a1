// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/surface/surface_set.h"

#include <findspace/error.h>

#include <algorithm>

namespace findspace::space {

using exact::Real;

SurfaceSet::Sheet::Sheet(Triangles surface) : body(std::move(surface)), tree(body) {
  for (const RayEdge& e : body.edges) {
    const Vector way = exact::approx(body.points[std::size_t(e.to)] - body.points[std::size_t(e.from)]);
    longest = std::max(longest, length(way));
  }
}

void SurfaceSet::add(const std::vector<RaySolid>& solids, std::int64_t scale) {
  for (const RaySolid& s : solids) {
    if (s.ball())
      balls_.push_back({{s.center.x * scale, s.center.y * scale, s.center.z * scale}, s.radius * Real(scale)});
    else
      sheets_.push_back(std::make_unique<const Sheet>(scale == 1 ? s.surface : scaled(s.surface, scale)));
  }
}

bool SurfaceSet::add(const Body& body) {
  if (body.outside) return false;
  for (const BodyPart& part : body.parts) {
    for (const Point& v : part.vertices()) {
      for (const std::int64_t c : {v.x, v.y, v.z}) {
        if (c > exact::kRayLimit || c < -exact::kRayLimit) return false;
      }
    }
    if (part.point())
      balls_.push_back({part.center, part.radius});
    else if (part.core && part.radius.sign() == 0)
      sheets_.push_back(std::make_unique<const Sheet>(triangles(*part.core)));
    else
      return false;
  }
  return true;
}

std::shared_ptr<const Body> SurfaceSet::hull(std::int64_t scale) const {
  if (!balls_.empty() || sheets_.empty()) return nullptr;
  std::vector<Point> points;
  for (const auto& sheet : sheets_) points.insert(points.end(), sheet->body.points.begin(), sheet->body.points.end());
  Body out;
  out.scale = scale;
  out.parts.push_back(part_of(points, Real()));
  return std::make_shared<const Body>(std::move(out));
}

bool seen_not_convex(const std::vector<RaySolid>& solids) {
  if (solids.size() != 1 || solids[0].ball()) return true;
  const RayBody body(solids[0].surface);
  return body.pieces > 1 ||
         std::any_of(body.edges.begin(), body.edges.end(), [](const RayEdge& e) { return e.bend < 0; });
}

}  // namespace findspace::space
