// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/turned_directional.h"

#include <algorithm>
#include <array>

#include "plane/primitives.h"
#include "plane/turned_contact.h"

namespace findspace::distance {

using exact::Real;
using plane::Mark;
using plane::MarkSet;
using plane::SignMap;
using plane::TurnedContact;
using plane::TurnMap;

namespace {

/// - in int A, 0 on its boundary, + elsewhere.
SignMap of_point(const plane::Region& a) {
  const std::array<plane::GridPoint, 1> origin{};
  return ShapePair(plane::region_of_points(origin), a).distance(Which::kGamma1)->sign_map(Real());
}

TurnMap least(const TurnedShapes& s, const SignMap& fixed) {
  const auto rule = [](MarkSet met) {
    return Mark((met & plane::kNegative) != 0 ? -1 : (met & plane::kZero) != 0 ? 0 : 1);
  };
  return TurnedContact::turn_map({s.turning, fixed, s.about, s.to}, rule, plane::kNegative);
}

TurnMap greatest(const TurnedShapes& s, const SignMap& fixed) {
  const auto rule = [](MarkSet met) {
    return Mark((met & plane::kPositive) != 0 ? 1 : (met & plane::kZero) != 0 ? 0 : -1);
  };
  return TurnedContact::turn_map({s.turning, fixed, s.about, s.to}, rule, plane::kPositive);
}

TurnMap farthest(const TurnedShapes& s, const Track& track, const Real& level) {
  const DirectionalFarthest point(of_point(s.fixed), track);
  if (!point.defined() || level.sign() < 0) return TurnMap::uniform(1);
  const std::vector<SignMap> parts = point.parts(level);
  std::vector<TurnMap> maps{least(s, parts[0])};
  for (std::size_t k = 1; k < parts.size(); ++k) maps.push_back(greatest(s, parts[k]));
  std::vector<const TurnMap*> all;
  for (const TurnMap& m : maps) all.push_back(&m);
  return plane::overlay(all, [](std::span<const Mark> m) { return *std::max_element(m.begin(), m.end()); });
}

}  // namespace

std::optional<TurnMap> turned_directional(const TurnedShapes& shapes, Which which, const Track& track,
                                          const Real& level) {
  if (which == Which::kGamma2) return farthest(shapes, track, level);
  const bool outside = which == Which::kGamma1 && level.sign() > 0;
  if (!outside && (which != Which::kEta1 || level.sign() >= 0)) return std::nullopt;
  const SignMap point = DirectionalSigned(of_point(shapes.fixed), track).sign_map(level);
  return outside ? least(shapes, point) : greatest(shapes, point);
}

}  // namespace findspace::distance
