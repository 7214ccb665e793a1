// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/grid/edge_fan.h"

#include <algorithm>
#include <cmath>

#include "exact/margins/plane.h"
#include "plane/base/small_sort.h"

namespace findspace::plane {
namespace {

using exact::int128;

constexpr Index kFewRays = 16;  // are inserted one by one

/// Grows with the angle in [0, 360), by 4 in all; off by less than kDiamondAngle.
double diamond_angle(const GridCorner& c) {
  double x = double(c.dx), y = double(c.dy), t = y / (std::abs(x) + std::abs(y));
  return x < 0 ? 2 - t : t < 0 ? 4 + t : t;
}

/// Order of the directions of two edges by angle in [0, 360).
int compare(std::span<const GridCorner> p, const EdgeRay& r, std::span<const GridCorner> q, const EdgeRay& s) {
  double gap = r.angle - s.angle;
  if (std::abs(gap) > margin::kDiamondAngle) return gap > 0 ? 1 : -1;
  const GridCorner &c = p[r.corner], &d = q[s.corner];
  int128 cross = int128(c.dx) * d.dy - int128(c.dy) * d.dx;
  return (cross < 0) - (cross > 0);
}

bool is_lower_edge(const GridCorner& c) { return c.dy < 0 || (c.dy == 0 && c.dx < 0); }

/// Those of all corners, in order.
void set_rays(std::span<const GridCorner> corners, std::span<EdgeRay> rays) {
  const Index n = Index(corners.size());
  // A ring that turns left nearly everywhere has its edges nearly in order from here on.
  Index start = 0;
  while (start < n && (is_lower_edge(corners[start]) || !is_lower_edge(corners[corners[start].before]))) ++start;
  EdgeRay* next = rays.data();
  for (Index k = start; k < n; ++k) *next++ = {diamond_angle(corners[k]), k};
  for (Index k = 0; k < start; ++k) *next++ = {diamond_angle(corners[k]), k};
  // Many: nearly, and then exactly. Thousands of edges of boxes have four directions.
  if (n > kFewRays)
    std::sort(rays.begin(), rays.end(), [](const EdgeRay& p, const EdgeRay& q) {
      return p.angle < q.angle || (!(q.angle < p.angle) && p.corner < q.corner);
    });
  insert_all(rays.data(), rays.data() + n, [&](const EdgeRay& p, const EdgeRay& q) {
    const int order = compare(corners, p, corners, q);
    return order != 0 ? order < 0 : p.corner < q.corner;
  });
}

}  // namespace

EdgeFan::EdgeFan(const GridFace& face, Memory memory)
    : corners(face.corners), rays(face.rays), rank(memory), own_rays_(memory) {
  if (!rays.empty()) return;
  own_rays_.resize(corners.size());
  set_rays(corners, own_rays_);
  rays = own_rays_;
}

void make_rays(std::span<GridFace> faces) {
  for (GridFace& face : faces) {
    face.rays.resize(face.corners.size());
    set_rays(face.corners, face.rays);
  }
}

void EdgeFan::place(EdgeFan& first, EdgeFan& other) {
  first.rank.resize(first.rays.size());
  other.rank.resize(other.rays.size());
  Index i = 0, j = 0;
  while (i < first.rays.size() || j < other.rays.size()) {
    bool take_first = j == other.rays.size() || (i < first.rays.size() && compare(other.corners, other.rays[j],
                                                                                  first.corners, first.rays[i]) >= 0);
    if (take_first) {
      first.rank[first.rays[i].corner] = j;
      ++i;
    } else {
      other.rank[other.rays[j].corner] = i;
      ++j;
    }
  }
}

}  // namespace findspace::plane
