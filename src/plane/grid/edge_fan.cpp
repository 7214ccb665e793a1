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
int compare(const EdgeFan& p, const EdgeFan::Ray& r, const EdgeFan& q, const EdgeFan::Ray& s) {
  double gap = r.angle - s.angle;
  if (std::abs(gap) > margin::kDiamondAngle) return gap > 0 ? 1 : -1;
  const GridCorner &c = p.corners[r.corner], &d = q.corners[s.corner];
  int128 cross = int128(c.dx) * d.dy - int128(c.dy) * d.dx;
  return (cross < 0) - (cross > 0);
}

}  // namespace

EdgeFan::EdgeFan(const GridFace& face, Memory memory) : corners(face.corners), rays(memory), rank(memory) {
  const Index n = Index(corners.size());
  rays.resize(n);
  // A ring that turns left nearly everywhere has its edges nearly in order from here on.
  Index start = 0;
  while (start < n && (lower(corners[start]) || !lower(corners[corners[start].before]))) ++start;
  Ray* next = rays.data();
  for (Index k = start; k < n; ++k) *next++ = {diamond_angle(corners[k]), k};
  for (Index k = 0; k < start; ++k) *next++ = {diamond_angle(corners[k]), k};
  // Many: nearly, and then exactly.
  if (n > kFewRays) std::sort(rays.begin(), rays.end(), [](const Ray& p, const Ray& q) { return p.angle < q.angle; });
  const auto before = [this](const Ray& p, const Ray& q) {
    const int order = compare(*this, p, *this, q);
    return order != 0 ? order < 0 : p.corner < q.corner;
  };
  insert_all(rays.data(), rays.data() + n, before);
}

void EdgeFan::place(EdgeFan& first, EdgeFan& other) {
  first.rank.resize(first.rays.size());
  other.rank.resize(other.rays.size());
  Index i = 0, j = 0;
  while (i < first.rays.size() || j < other.rays.size()) {
    bool take_first =
        j == other.rays.size() || (i < first.rays.size() && compare(other, other.rays[j], first, first.rays[i]) >= 0);
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
