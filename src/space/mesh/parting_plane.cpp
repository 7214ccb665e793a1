// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/mesh/parting_plane.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "space/polytope/vector.h"

namespace findspace::space {
namespace {

constexpr int kDirections = 16;
constexpr std::int64_t kFarthest = std::int64_t{1} << 40;
constexpr double kLargestComponent = 1 << 19;  // the largest component: products and their sum stay below 2^63

Vector rounded_vector(const Point& p) {
  return {static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)};
}

std::int64_t rise(const Point& d, const Point& p) { return d.x * p.x + d.y * p.y + d.z * p.z; }

/// Of at most four points: which of them span the place of their hull that is nearest to 0, and that place.
struct NearestOfHull {
  unsigned kept = 0;
  Vector at{};
};

/// The place nearest to 0 of the plane, line or point through some of the points, if it is between them.
std::optional<Vector> nearest_between(std::span<const Vector> points) {
  const Vector& base = points[0];
  if (points.size() == 1) return base;
  std::array<Vector, 3> edge{};
  for (std::size_t k = 1; k < points.size(); ++k) edge[k - 1] = points[k] - base;
  if (points.size() == 2) {
    const double square = dot(edge[0], edge[0]), t = -dot(base, edge[0]);
    if (!(t > 0 && t < square)) return std::nullopt;
    return plus(base, scaled(t / square, edge[0]));
  }
  if (points.size() == 3) {
    const Vector n = space::cross(edge[0], edge[1]), off = scaled(-1, base);
    const double square = dot(n, n), s = dot(space::cross(off, edge[1]), n), t = dot(space::cross(edge[0], off), n);
    if (!(s > 0 && t > 0 && s + t < square)) return std::nullopt;
    return scaled(dot(base, n) / square, n);
  }
  return std::nullopt;  // four points about 0, or flat ones
}

NearestOfHull nearest_of(std::span<const Vector> points) {
  NearestOfHull out;
  double least = HUGE_VAL;
  for (unsigned kept = 1; kept < 1U << points.size(); ++kept) {
    if (std::popcount(kept) > 3) continue;
    std::array<Vector, 3> some{};
    std::size_t count = 0;
    for (std::size_t k = 0; k < points.size(); ++k)
      if ((kept >> k & 1U) != 0) some[count++] = points[k];
    const std::optional<Vector> at = nearest_between({some.data(), count});
    if (!at || !(dot(*at, *at) < least)) continue;
    least = dot(*at, *at);
    out = {kept, *at};
  }
  return out;
}

/// Of the set, what is least along d.
const Point& least_along(const Point& d, std::span<const Point> set) {
  const Point* out = &set[0];
  std::int64_t least = rise(d, *out);
  for (const Point& p : set) {
    const std::int64_t here = rise(d, p);
    if (here >= least) continue;
    least = here;
    out = &p;
  }
  return *out;
}

bool all_near(std::span<const Point> set) {
  const auto small = [](std::int64_t c) { return c < kFarthest && c > -kFarthest; };
  return std::all_of(set.begin(), set.end(), [&](const Point& p) { return small(p.x) && small(p.y) && small(p.z); });
}

}  // namespace

bool plane_parts(std::span<const Point> p, std::span<const Point> q) {
  if (p.empty() || q.empty() || !all_near(p) || !all_near(q)) return false;
  std::vector<Vector> hull{rounded_vector(q[0] - p[0])};
  Vector nearest = hull[0];
  for (int round = 0; round < kDirections; ++round) {
    const double size = std::max({std::fabs(nearest.x), std::fabs(nearest.y), std::fabs(nearest.z)});
    if (!(size > 0)) return false;
    const auto whole = [&](double c) { return static_cast<std::int64_t>(std::llround(c / size * kLargestComponent)); };
    const Point d{whole(nearest.x), whole(nearest.y), whole(nearest.z)};
    const Point &low = least_along(d, q), &high = least_along({-d.x, -d.y, -d.z}, p);
    if (rise(d, low) > rise(d, high)) return true;
    const Vector next = rounded_vector(low - high);
    const auto same = [&](const Vector& v) { return v.x == next.x && v.y == next.y && v.z == next.z; };
    if (std::any_of(hull.begin(), hull.end(), same)) return false;
    hull.push_back(next);
    const NearestOfHull found = nearest_of(hull);
    std::vector<Vector> kept;
    for (std::size_t k = 0; k < hull.size(); ++k)
      if ((found.kept >> k & 1U) != 0) kept.push_back(hull[k]);
    hull.swap(kept);
    nearest = found.at;
  }
  return false;
}

}  // namespace findspace::space
