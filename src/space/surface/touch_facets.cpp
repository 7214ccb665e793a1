// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/surface/touch_facets.h"

#include <algorithm>

namespace findspace::space {
namespace {

/// The corner of face f that is not on the edge.
int beyond(const RayBody& body, int f, const RayEdge& e) {
  const auto& face = body.faces[static_cast<std::size_t>(f)];
  return *std::find_if(face.begin(), face.end(), [&](int v) { return v != e.from && v != e.to; });
}

}  // namespace

/// A triangle in a direction.
struct TouchFacets::Seen {
  const RayBody& body;
  std::size_t triangle;
  const Wide3& n;
  const Approx3& n_approx;

  int point(int k) const { return body.faces[triangle][static_cast<std::size_t>(k)]; }
  /// The sign of n . (w - v).
  int rise(int v, int w) const {
    return exact::sign_dot(n, n_approx,
                           body.points[static_cast<std::size_t>(w)] - body.points[static_cast<std::size_t>(v)]);
  }
};

TouchFacets::TouchFacets(const RayBody& body, TouchSide side)
    : body_(body), outside_(side == TouchSide::kOutside), about_(body.points.size()) {
  for (const RayVertex& v : body.vertices) {
    for (int k = v.first; k < v.first + v.count; ++k)
      about_[static_cast<std::size_t>(v.point)].push_back(body.corners[static_cast<std::size_t>(k)]);
  }
}

bool TouchFacets::edge_may_touch(const Seen& seen, int k) const {
  const RayEdge& e =
      body_.edges[static_cast<std::size_t>(body_.face_edges[seen.triangle][static_cast<std::size_t>(k)])];
  const int own = static_cast<int>(seen.triangle), other = e.left == own ? e.right : e.left;
  // Above: covered; level: part of a facet of the other triangle.
  if (seen.rise(e.from, beyond(body_, other, e)) >= 0) return false;
  return own < other && (e.bend > 0) == outside_;
}

bool TouchFacets::vertex_may_touch(const Seen& seen, int v) const {
  const std::vector<RayCorner>& all = about_[static_cast<std::size_t>(v)];
  return std::all_of(all.begin(), all.end(), [&](const RayCorner& corner) {
    return corner.face >= static_cast<int>(seen.triangle) && seen.rise(v, corner.to) < 0;
  });
}

TouchSet touch_set(const RayBody& body, std::size_t triangle, const Polytope& part) {
  std::vector<Point> points;
  for (int k = 0; k < 3; ++k) {
    for (const Point& w : part.vertices()) points.push_back(body.corner(static_cast<int>(triangle), k) - w);
  }
  TouchSet set{Polytope::hull(points), {}};
  for (const Plane& p : set.closed.planes()) set.planes.emplace_back(p);
  return set;
}

bool TouchFacets::may_touch(std::size_t triangle, const Wide3& n, const Approx3& n_approx) const {
  const Seen seen{body_, triangle, n, n_approx};
  int highest = 0;
  for (int k = 1; k < 3; ++k) {
    if (seen.rise(seen.point(highest), seen.point(k)) > 0) highest = k;
  }
  bool level[3];
  for (int k = 0; k < 3; ++k) level[k] = k == highest || seen.rise(seen.point(highest), seen.point(k)) == 0;
  if (level[0] && level[1] && level[2]) {
    const Wide3& own = body_.normals[triangle];
    // Parallel: they agree in the sign of any component that is not 0.
    return (exact::lexicographic_sign(own) == exact::lexicographic_sign(n)) == outside_;
  }
  for (int k = 0; k < 3; ++k) {
    if (level[k] && level[(k + 1) % 3]) return edge_may_touch(seen, k);
  }
  return vertex_may_touch(seen, seen.point(highest));
}

}  // namespace findspace::space
