// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/open_cover.h"

#include <algorithm>
#include <limits>

#include "space/foot_search.h"

namespace findspace::space {

using exact::Real;

Extent everywhere() {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  return {{-kFar, -kFar, -kFar}, {kFar, kFar, kFar}};
}

double Extent::distance(const Vector& p) const {
  const auto gap = [](double c, double lo, double hi) { return std::max({lo - c, c - hi, 0.0}); };
  return length({gap(p.x, low.x, high.x), gap(p.y, low.y, high.y), gap(p.z, low.z, high.z)});
}

void OpenCover::add(const Extent& extent, std::function<Planes()> make) {
  parts_.push_back(std::make_unique<Part>());
  parts_.back()->extent = extent;
  parts_.back()->make = std::move(make);
}

void OpenCover::add(const Extent& extent, Planes planes) {
  add(extent, [planes = std::move(planes)] { return planes; });
}

const OpenCover::Planes& OpenCover::planes(std::size_t k) const {
  const Part& part = *parts_[k];
  std::call_once(part.made, [&] { part.planes = part.make(); });
  return part.planes;
}

int OpenCover::covering(const RealVector& p) const {
  const Vector near = space::rounded(p);
  for (std::size_t k = 0; k < size(); ++k) {
    if (!extent(k).holds(near, 0x1p-40 * size_of(near))) continue;
    const Planes& all = planes(k);
    if (std::all_of(all.begin(), all.end(), [&](const HalfSpace& h) { return h.sign(p, near) < 0; }))
      return static_cast<int>(k);
  }
  return -1;
}

std::optional<RealVector> OpenCover::nearest_uncovered(const RealVector& p) const { return FootSearch(*this, p).run(); }

std::optional<RealVector> OpenCover::nearest_touching(const RealVector& p) const {
  const Vector near = space::rounded(p);
  // By a lower bound of the distance, so that most sets are never looked at closely.
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t k = 0; k < size(); ++k) order.emplace_back(extent(k).distance(near), k);
  std::sort(order.begin(), order.end());
  const double slack = 0x1p-40 * size_of(near);
  std::optional<RealVector> best;
  std::optional<Real> least;
  double bound = std::numeric_limits<double>::infinity();
  for (const auto& [floor, k] : order) {
    if (floor > bound + slack) break;
    double highest = 0;
    for (const HalfSpace& h : planes(k)) highest = std::max(highest, h.shadow_value(near) - h.error(near));
    if (highest > bound + slack) continue;
    std::optional<RealVector> q = nearest_in(planes(k), p);
    if (!q) continue;
    const RealVector off = minus(*q, p);
    const Real square = dot(off, off);
    if (least && !(square < *least)) continue;
    least = square;
    best = std::move(q);
    bound = std::sqrt(least->to_double());
    if (least->sign() == 0) break;
  }
  return best;
}

// A closed convex set is what the open half spaces beyond its planes do not cover.
std::optional<RealVector> nearest_in(std::span<const HalfSpace> planes, const RealVector& p) {
  OpenCover beyond;
  for (const HalfSpace& h : planes) beyond.add(everywhere(), OpenCover::Planes{h.opposite()});
  return beyond.nearest_uncovered(p);
}

}  // namespace findspace::space
