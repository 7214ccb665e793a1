// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "exact/planar/excerpt.h"

#include <algorithm>
#include <optional>

namespace findspace::exact {
namespace {

/// The latest are looked for most.
std::optional<std::uint32_t> copy_of(const std::vector<std::pair<std::uint32_t, std::uint32_t>>& copies,
                                     std::uint32_t of_whole) {
  const auto known = std::find_if(copies.rbegin(), copies.rend(), [&](const auto& c) { return c.first == of_whole; });
  return known == copies.rend() ? std::nullopt : std::optional(known->second);
}

}  // namespace

std::uint32_t Excerpt::curve(std::uint32_t of_whole) {
  if (const auto known = copy_of(curves_, of_whole)) return *known;
  const std::uint32_t made = copies_.add(whole_.supporting_curves[of_whole]);
  curves_.emplace_back(of_whole, made);
  return made;
}

std::uint32_t Excerpt::point(std::uint32_t of_whole) {
  if (const auto known = copy_of(points_, of_whole)) return *known;
  Point p = whole_.points[of_whole];
  if (p.kind == Point::Kind::kReal) {
    copies_.reals.push_back(whole_.reals[p.i]);
    p.i = std::uint32_t(copies_.reals.size() - 1);
  }
  if (p.kind == Point::Kind::kCross) {
    p.i = curve(p.i);
    p.j = curve(p.j);
    if (p.j < p.i) {  // the root of two circles is that of their order (Geometry::add_crossing)
      if (copies_.supporting_curves[p.i].circle && copies_.supporting_curves[p.j].circle) p.root = std::int8_t(-p.root);
      std::swap(p.i, p.j);
    }
  }
  copies_.points.push_back(p);
  const auto made = std::uint32_t(copies_.points.size() - 1);
  points_.emplace_back(of_whole, made);
  return made;
}

void Excerpt::clear() {
  copies_ = Geometry();
  curves_.clear();
  points_.clear();
}

}  // namespace findspace::exact
