// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/planar/directional.h"

#include <algorithm>
#include <cmath>

#include "distance/planar/translation_value.h"
#include "plane/complex/overlay.h"
#include "plane/query/locate.h"
#include "plane/query/topology.h"

namespace findspace::distance {

using exact::Real;
using exact::RealPoint;
using plane::CellComplex;
using plane::Mark;
using plane::Section;
using plane::Sight;
using plane::SignMap;

namespace {

bool up_to_zero(Mark m) { return m <= 0; }

Section track_section(const SignMap& map, const TranslationDirection& direction, const RealPoint& p) {
  return section(map, p, {Real(direction.dx), Real(direction.dy)});
}

/// A distance along the direction from a section's parameter.
PlanarAnswer at_parameter(const Real& t, const TranslationDirection& direction, const RealPoint& p, int sign) {
  const Real dx(direction.dx), dy(direction.dy);
  return exact_answer(Real(sign) * abs(t) * sqrt(dx * dx + dy * dy), Way::kMap,
                      std::optional(RealPoint{p.x + t * dx, p.y + t * dy}));
}

/// Greater than the extent of the map's curves in any direction, in grid steps.
Real extent(const CellComplex& m) {
  double least = 0, most = 0, widest = 0;
  for (const plane::Vertex& v : m.vertices) {
    const exact::Point& p = m.geometry.points[v.point];
    least = std::min({least, p.x - p.error, p.y - p.error});
    most = std::max({most, p.x + p.error, p.y + p.error});
  }
  for (const exact::SupportingCurve& k : m.geometry.supporting_curves)
    if (k.circle) widest = std::max(widest, k.z().value + k.z().error);
  return Real::from_double(std::ceil(2 * (most - least + 2 * widest)) + 1);
}

}  // namespace

DirectionalSigned::DirectionalSigned(SignMap base, const TranslationDirection& direction)
    : base_(std::move(base)), direction_(direction), defined_(any_mark(base_, up_to_zero)) {}

SignMap DirectionalSigned::sign_map(const Real& level) const {
  if (!defined_) return CellComplex::uniform(1);
  const int side = level.sign();
  if (side == 0) return base_;
  const bool both = direction_.both_ways;
  const Real tolerance = abs(level);
  const plane::Window window =
      plane::window_along(direction_.dx, direction_.dy, both ? -tolerance : Real(0), tolerance);
  // t = 0 is inside the window, or (one way) its start, which then counts as what is inside.
  if (side > 0) {
    return swept(base_, window, [both](const Sight& s) {
      if (s.inside <= 0 || (!both && s.start <= 0)) return Mark(-1);
      return Mark(s.least() <= 0 ? 0 : 1);
    });
  }
  return swept(negated(base_), window, [both](const Sight& s) {
    if (s.inside <= 0 || (!both && s.start <= 0)) return Mark(1);
    return Mark(s.least() <= 0 ? 0 : -1);
  });
}

std::optional<PlanarAnswer> DirectionalSigned::value(const RealPoint& p) const {
  if (!defined_) return std::nullopt;
  if (mark_of(base_, locate(base_, p)) == 0) return exact_answer(Real(), Way::kMap);
  const auto found = translation_value(track_section(base_, direction_, p), false, direction_.both_ways);
  if (!found) return std::nullopt;
  if (!found->lowest) return at_parameter(found->t, direction_, p, found->sign);
  return lowest_answer(Way::kMap);
}

DirectionalFarthest::DirectionalFarthest(SignMap base, const TranslationDirection& direction)
    : base_(std::move(base)), direction_(direction), defined_(base_.faces[0].mark > 0 && any_mark(base_, up_to_zero)) {}

/// -1 where C is met at less than the level, 0 where at the level only, +1 elsewhere.
SignMap DirectionalFarthest::near_map(const Real& level) const {
  const bool both = direction_.both_ways;
  if (level.sign() == 0) return remark(base_, [](Mark m) { return Mark(m <= 0 ? 0 : 1); });
  return swept(base_, plane::window_along(direction_.dx, direction_.dy, both ? -level : Real(0), level),
               [both](const Sight& s) {
                 if (s.inside <= 0 || (!both && s.start <= 0)) return Mark(-1);
                 return Mark(s.least() <= 0 ? 0 : 1);
               });
}

/// +1 where C is met farther off than the level, 0 where not but at the level, -1 elsewhere; in one of the two ways.
SignMap DirectionalFarthest::far_map(const Real& level, bool forward) const {
  // A position with C within the level has nothing of it farther off than the level and the extent of C.
  const Real most = Real(2) * level + extent(base_);
  const plane::Window window = forward ? plane::window_along(direction_.dx, direction_.dy, level, most)
                                       : plane::window_along(direction_.dx, direction_.dy, -most, -level);
  return swept(base_, window, [forward](const Sight& s) {
    const Mark near = forward ? s.start : s.end, far = forward ? s.end : s.start;
    return Mark(s.inside <= 0 || far <= 0 ? 1 : near <= 0 ? 0 : -1);
  });
}

std::vector<SignMap> DirectionalFarthest::parts(const Real& level) const {
  std::vector<SignMap> maps{near_map(level), far_map(level, true)};
  if (direction_.both_ways) maps.push_back(far_map(level, false));
  return maps;
}

SignMap DirectionalFarthest::sign_map(const Real& level) const {
  if (!defined_ || level.sign() < 0) return CellComplex::uniform(1);
  const std::vector<SignMap> maps = parts(level);
  std::vector<const CellComplex*> all;
  for (const SignMap& m : maps) all.push_back(&m);
  // Nothing of C within reach, or something beyond: +. All of it nearer: -.
  return overlay(all, [](std::span<const Mark> m) { return *std::max_element(m.begin(), m.end()); });
}

std::optional<PlanarAnswer> DirectionalFarthest::value(const RealPoint& p) const {
  if (!defined_) return std::nullopt;
  const auto found = translation_value(track_section(base_, direction_, p), true, direction_.both_ways);
  if (!found) return std::nullopt;
  return exact_answer(at_parameter(found->t, direction_, p, 1).value, Way::kMap);
}

}  // namespace findspace::distance
