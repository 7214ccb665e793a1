// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/polytope/flat_core.h"

#include <algorithm>
#include <array>

namespace findspace::space {

namespace {

using Flat = std::array<exact::int128, 2>;

std::array<std::int64_t, 3> coordinates(const Point& p) { return {p.x, p.y, p.z}; }

/// A normal of the plane through three of the points; zero where they lie on one line.
RealVector normal_of(std::span<const Point> points) {
  const RealVector d = real(points[1] - points[0]);
  for (const Point& p : points.subspan(2)) {
    RealVector n = cross(d, real(p - points[0]));
    if (!is_zero(n)) return n;
  }
  return {};
}

/// The coordinate along which the plane is seen as a plane: where the normal has its greatest part.
std::size_t across(const RealVector& n) {
  std::size_t best = 0;
  for (std::size_t k = 1; k < 3; ++k) {
    if (abs(n[best]) < abs(n[k])) best = k;
  }
  return best;
}

int turn(const Flat& a, const Flat& b, const Flat& c) {
  const exact::int128 v = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  return v < 0 ? -1 : v > 0 ? 1 : 0;
}

/// One chain of the hull of points in ascending order, without its last corner.
void add_chain(const std::vector<std::pair<Flat, Point>>& sorted, std::vector<Point>& out) {
  std::vector<std::pair<Flat, Point>> chain;
  for (const auto& next : sorted) {
    while (chain.size() > 1 && turn(chain[chain.size() - 2].first, chain.back().first, next.first) <= 0)
      chain.pop_back();
    chain.push_back(next);
  }
  for (std::size_t k = 0; k + 1 < chain.size(); ++k) out.push_back(chain[k].second);
}

std::vector<Point> polygon(std::span<const Point> points, std::size_t drop) {
  std::vector<std::pair<Flat, Point>> sorted;
  for (const Point& p : points) sorted.push_back({{coordinates(p)[(drop + 1) % 3], coordinates(p)[(drop + 2) % 3]}, p});
  std::sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Point> out;
  add_chain(sorted, out);
  std::reverse(sorted.begin(), sorted.end());
  add_chain(sorted, out);
  return out;
}

HalfSpace through(const RealVector& normal, const Point& p) { return {normal, -dot(normal, real(p))}; }

}  // namespace

std::optional<std::vector<Point>> flat_corners(std::span<const Point> points) {
  std::vector<Point> all(points.begin(), points.end());
  const auto key = [](const Point& p) { return coordinates(p); };
  std::sort(all.begin(), all.end(), [&](const Point& p, const Point& q) { return key(p) < key(q); });
  all.erase(std::unique(all.begin(), all.end()), all.end());
  if (all.size() < 2) return all;
  const RealVector n = normal_of(all);
  if (is_zero(n)) return std::vector<Point>{all.front(), all.back()};
  const bool flat =
      std::all_of(all.begin(), all.end(), [&](const Point& p) { return dot(n, real(p - all[0])).sign() == 0; });
  if (!flat) return std::nullopt;
  return polygon(all, across(n));
}

std::vector<HalfSpace> flat_planes(std::span<const Point> corners) {
  std::vector<HalfSpace> planes;
  const Point& first = corners[0];
  const auto add_both = [&](const RealVector& n) {
    planes.push_back(through(n, first));
    planes.push_back(planes.back().opposite());
  };
  if (corners.size() == 2) {
    const RealVector d = real(corners[1] - first);
    RealVector axis;
    axis[(across(d) + 1) % 3] = exact::Real(1);
    const RealVector aside = cross(d, axis);
    add_both(aside);
    add_both(cross(d, aside));
    planes.push_back(through(d, corners[1]));
    planes.push_back(through(negated(d), first));
    return planes;
  }
  const RealVector n = normal_of(corners);
  add_both(n);
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Point &from = corners[k], &to = corners[(k + 1) % corners.size()];
    const HalfSpace side = through(cross(real(to - from), n), from);
    const bool inward =
        std::any_of(corners.begin(), corners.end(), [&](const Point& p) { return side.value(real(p)).sign() > 0; });
    planes.push_back(inward ? side.opposite() : side);
  }
  return planes;
}

}  // namespace findspace::space
