// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/rotation/turned_directional.h"

#include <algorithm>
#include <array>

#include "plane/complex/primitives.h"
#include "plane/rotation/turned_contact.h"
#include "plane/rotation/turned_free.h"

namespace findspace::distance {

using exact::Real;
using plane::Mark;
using plane::MarkSet;
using plane::SignMap;
using plane::TurnedContact;
using plane::TurnedFree;
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

TurnMap negated(const TurnMap& map) {
  return plane::remark(map, [](Mark k) { return Mark(-k); });
}

enum class Roles { kStraight, kExchanged };

/// From the positions on the way that keep B in some relation to A; exchanged: A, turned back, to B.
TurnMap of_positions(const TurnedShapes& s, TurnedFree::Keep keep, Roles roles, const Track& track, const Real& level,
                     bool far) {
  if (level.sign() < 0) return TurnMap::uniform(1);
  const bool back = roles == Roles::kExchanged;
  const SignMap around_a = of_point(s.fixed), around_b = of_point(s.turning);
  const TurnedFree::Pair pair = back ? TurnedFree::Pair{s.fixed, s.turning, s.to, s.about, around_b, around_a}
                                     : TurnedFree::Pair{s.turning, s.fixed, s.about, s.to, around_a, around_b};
  // B moved by t along the way is A moved back by t, and the way turns back with A.
  const Real side(back ? -1 : 1);
  const plane::FreeWay way{{side * Real(track.dx), side * Real(track.dy)}, track.both_ways, back};
  const TurnedFree free(pair, keep, way);
  const TurnMap map = far ? free.farthest(level) : free.nearest(level);
  return back ? plane::mirrored(map) : map;
}

}  // namespace

TurnMap turned_directional(const TurnedShapes& shapes, Which which, const Track& track, const Real& level) {
  using Keep = TurnedFree::Keep;
  const bool exchanged = which == Which::kDelta1 || which == Which::kDelta2;
  const Roles roles = exchanged ? Roles::kExchanged : Roles::kStraight;
  if (which == Which::kGamma2) return farthest(shapes, track, level);
  if (which == Which::kEta2 || which == Which::kDelta2)
    return of_positions(shapes, Keep::kInside, roles, track, level, true);
  const bool apart = which == Which::kGamma1, above = level.sign() > 0;
  if (apart && above) return least(shapes, DirectionalSigned(of_point(shapes.fixed), track).sign_map(level));
  if (apart) return negated(of_positions(shapes, Keep::kApart, roles, track, -level, false));
  if (above) return of_positions(shapes, Keep::kInside, roles, track, level, false);
  if (exchanged) return negated(of_positions(shapes, Keep::kNotWithin, roles, track, -level, false));
  return greatest(shapes, DirectionalSigned(of_point(shapes.fixed), track).sign_map(level));
}

}  // namespace findspace::distance
