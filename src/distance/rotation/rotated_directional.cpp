// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/rotation/rotated_directional.h"

#include <algorithm>
#include <array>

#include "plane/complex/primitives.h"
#include "plane/rotation/rotated_contact.h"
#include "plane/rotation/rotated_free.h"

namespace findspace::distance {

using exact::Real;
using plane::Mark;
using plane::MarkSet;
using plane::RotatedContact;
using plane::RotatedFree;
using plane::RotationMap;
using plane::SignMap;

namespace {

/// - in int A, 0 on its boundary, + elsewhere.
SignMap of_point(const plane::Region& a) {
  const std::array<plane::GridPoint, 1> origin{};
  return ShapePair(plane::region_of_points(origin), a).distance(Which::kGamma1)->sign_map(Real());
}

RotationMap least(const RotatedShapes& s, const SignMap& fixed) {
  const auto rule = [](MarkSet met) {
    return Mark((met & plane::kNegative) != 0 ? -1 : (met & plane::kZero) != 0 ? 0 : 1);
  };
  return RotatedContact::rotation_map({s.rotating, fixed, s.about, s.to}, rule, plane::kNegative);
}

RotationMap greatest(const RotatedShapes& s, const SignMap& fixed) {
  const auto rule = [](MarkSet met) {
    return Mark((met & plane::kPositive) != 0 ? 1 : (met & plane::kZero) != 0 ? 0 : -1);
  };
  return RotatedContact::rotation_map({s.rotating, fixed, s.about, s.to}, rule, plane::kPositive);
}

RotationMap farthest(const RotatedShapes& s, const TranslationDirection& direction, const Real& level) {
  const DirectionalFarthest point(of_point(s.fixed), direction);
  if (!point.defined() || level.sign() < 0) return RotationMap::uniform(1);
  const std::vector<SignMap> parts = point.parts(level);
  std::vector<RotationMap> maps{least(s, parts[0])};
  for (std::size_t k = 1; k < parts.size(); ++k) maps.push_back(greatest(s, parts[k]));
  std::vector<const RotationMap*> all;
  for (const RotationMap& m : maps) all.push_back(&m);
  return plane::overlay(all, [](std::span<const Mark> m) { return *std::max_element(m.begin(), m.end()); });
}

RotationMap negated(const RotationMap& map) {
  return plane::remark(map, [](Mark k) { return Mark(-k); });
}

enum class Roles { kStraight, kExchanged };

/// From the positions on the way that keep B in some relation to A; exchanged: A, rotated back, to B.
RotationMap of_positions(const RotatedShapes& s, RotatedFree::Keep keep, Roles roles,
                         const TranslationDirection& direction, const Real& level, bool far) {
  if (level.sign() < 0) return RotationMap::uniform(1);
  const bool back = roles == Roles::kExchanged;
  const SignMap around_a = of_point(s.fixed), around_b = of_point(s.rotating);
  const RotatedFree::Pair pair = back ? RotatedFree::Pair{s.fixed, s.rotating, s.to, s.about, around_b, around_a}
                                      : RotatedFree::Pair{s.rotating, s.fixed, s.about, s.to, around_a, around_b};
  // B moved by t along the way is A moved back by t, and the way rotates back with A.
  const Real side(back ? -1 : 1);
  const plane::FreeWay way{{side * Real(direction.dx), side * Real(direction.dy)}, direction.both_ways, back};
  const RotatedFree free(pair, keep, way);
  const RotationMap map = far ? free.farthest(level) : free.nearest(level);
  return back ? plane::mirrored(map) : map;
}

}  // namespace

RotationMap rotated_directional(const RotatedShapes& shapes, Which which, const TranslationDirection& direction,
                                const Real& level) {
  using Keep = RotatedFree::Keep;
  const bool exchanged = which == Which::kDelta1 || which == Which::kDelta2;
  const Roles roles = exchanged ? Roles::kExchanged : Roles::kStraight;
  if (which == Which::kGamma2) return farthest(shapes, direction, level);
  if (which == Which::kEta2 || which == Which::kDelta2)
    return of_positions(shapes, Keep::kInside, roles, direction, level, true);
  const bool apart = which == Which::kGamma1, above = level.sign() > 0;
  if (apart && above) return least(shapes, DirectionalSigned(of_point(shapes.fixed), direction).sign_map(level));
  if (apart) return negated(of_positions(shapes, Keep::kApart, roles, direction, -level, false));
  if (above) return of_positions(shapes, Keep::kInside, roles, direction, level, false);
  if (exchanged) return negated(of_positions(shapes, Keep::kNotWithin, roles, direction, -level, false));
  return greatest(shapes, DirectionalSigned(of_point(shapes.fixed), direction).sign_map(level));
}

}  // namespace findspace::distance
