// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A formula along one line of space, and distances along a direction at one position, which are read off the signs at
// level 0 on the line through it. Signs come from the exact set of boxes where there is one, else from the one ray that
// the line is. Guarantee: exact, as the sources'. A line that is not parallel to an axis needs convex parts of the
// shapes.
#include <findspace/error.h>

#include <algorithm>

#include "distance/planar/translation_value.h"
#include "distance/rays/ray_directional_least.h"
#include "formula/language/evaluate.h"
#include "formula/language/text.h"
#include "formula/language/which.h"
#include "formula/solid/prepared_space.h"
#include "space/box/box_section.h"
#include "space/rays/oblique_line.h"

namespace findspace::formula {
namespace {

using distance::Answer;
using exact::Real;
using exact::Tried;
using plane::Section;
using space::Mark;
using space::RealVector;

/// The same line gone the other way.
Section reversed(const Section& line) {
  Section out{line.stops.empty() ? line.before : line.stops.back().after, {}};
  for (std::size_t k = line.stops.size(); k-- > 0;)
    out.stops.push_back({-line.stops[k].t, line.stops[k].at, k > 0 ? line.stops[k - 1].after : line.before});
  return out;
}

/// The axis that the line is parallel to, or -1.
int axis_of(const RealVector& direction) {
  int axis = -1;
  for (int k = 0; k < 3; ++k) {
    if (direction[static_cast<std::size_t>(k)].sign() == 0) continue;
    if (axis >= 0) return -1;
    axis = k;
  }
  return axis;
}

Tried<LineSigns> ray_signs(const RayWorld& world, const SignMap& map, const SpaceLine& line) {
  const int axis = axis_of(line.direction);
  const auto grid = axis < 0 ? std::nullopt : grid_through(line.through, axis);
  if (!grid) {
    space::RayGrid oblique{2, 1, 0, 0, 1, 1, 1, 1};
    oblique.oblique = std::make_shared<const space::ObliqueLine>(line.through, line.direction);
    return signs_on_line(world, map, oblique);
  }
  Tried<LineSigns> found = signs_on_line(world, map, *grid);
  if (!found) return found;
  Section& out = found->section;
  const Real unit = Real::ratio(1, grid->parts), &start = line.through[static_cast<std::size_t>(axis)];
  for (Section::Stop& stop : out.stops) stop.t = stop.t * unit - start;
  if (line.direction[static_cast<std::size_t>(axis)].sign() < 0) out = reversed(out);
  return found;
}

Section box_signs(const space::BoxComplex& map, const SpaceLine& line) {
  return section(map, line.through,
                 space::scaled(Real(1) / sqrt(space::dot(line.direction, line.direction)), line.direction));
}

/// gamma1, eta1 or delta1 plainly: at level 0 it is - on the open set, 0 on the rest of the closed one.
SignMap level_zero(const Distance& d) {
  Distance base = d;
  base.mode = Mode::kPlain;
  base.vector.clear();
  base.kind = nearest_kind(base.kind);
  SignMap map;
  map.distance = base;
  return map;
}

/// The position so far along the line.
RealVector at_way(const SpaceLine& line, const Real& t) {
  return space::along(line.through, t / sqrt(space::dot(line.direction, line.direction)), line.direction);
}

/// Of signs that a search told. Nothing: +infinity, or undefined.
Tried<std::optional<Answer>> bounded_value(const Distance& wanted, const distance::TranslationBounds& between,
                                           const SpaceLine& line) {
  const bool farthest = is_farthest(wanted.kind);
  const auto &lower = between.lower, &upper = between.upper;
  if (!lower && !upper) return std::nullopt;
  if (upper && upper->lowest) return distance::lowest_answer<distance::SpacePosition>(distance::Way::kLines);
  const bool no_lower = lower && lower->lowest;
  if ((farthest && bool(lower) != bool(upper)) || (no_lower && !upper))
    return refused(wanted, "the signs along the line, found by search, do not tell the value");
  Answer out;
  out.way = distance::Way::kLines;
  distance::Enclosure ends;
  if (!no_lower) ends.lower = lower->value();
  if (upper) ends.upper = upper->value();
  out.value = !ends.lower ? *ends.upper : !ends.upper ? *ends.lower : (*ends.lower + *ends.upper) / Real(2);
  if (ends.lower && ends.upper) {
    if (!farthest && lower->sign == upper->sign && lower->t.sign() == upper->t.sign())
      out.nearest = at_way(line, (lower->t + upper->t) / Real(2));
    if (*ends.lower == *ends.upper) return out;
    out.error = ends.width();
  }
  out.set_unproven();
  out.enclosed = std::move(ends);
  return out;
}

/// Of a distance along an axis.
struct Axial {
  PreparedSpace::Named plain;
  int axis = 0, way = 0;
};

Tried<Axial> axial(const PreparedSpace& prepared, const Distance& wanted) {
  const Distance d = moving_first(wanted, prepared.world.moving);
  const RealVector direction{d.vector.at(0), d.vector.at(1), d.vector.at(2)};
  const int axis = axis_of(direction);
  if (axis < 0) return refused(d, "the exact map needs a direction along an axis");
  Distance plain = level_zero(d).distance;
  plain.kind = d.kind;
  const Tried<PreparedSpace::Named> n = prepared.named(plain);
  if (!n) return n.refusal();
  return Axial{*n, axis, d.mode == Mode::kAlong ? 0 : direction[static_cast<std::size_t>(axis)].sign()};
}

/// A least value that a search found in numbers, as the place that it found has it: one way all of what that has both
/// ways.
Tried<std::optional<Answer>> confirmed(const PreparedSpace& prepared, const Distance& wanted, Answer least) {
  Distance both = wanted;
  both.mode = Mode::kAlong;
  const auto there = directional_value(prepared, both, least.at);
  if (!there) return there.refusal();
  const std::optional<Real> upper = *there ? (*there)->bounds().upper : std::nullopt;
  if (!upper || upper->sign() >= 0)
    return refused(wanted, "the least value that the search found was not confirmed at its place");
  least.value = *upper * Real(wanted.mode == Mode::kAlong ? 1 : 2);
  least.enclosed->upper = least.value;
  if (least.value < *least.enclosed->lower) least.enclosed->lower = least.value;
  return std::optional(std::move(least));
}

/// Where the positions of level 0 are convex by their longest chord, else by bodies.
Tried<std::optional<distance::Answer>> least_of_parts(const PreparedSpace& prepared, const Distance& wanted) {
  const Distance d = moving_first(wanted, prepared.world.moving);
  const Tried<PreparedSpace::Named> plain = prepared.named(level_zero(d).distance);
  if (!plain) return plain.refusal();
  if (is_farthest(d.kind))
    return refused(wanted, "the least of the farthest distance along a direction is computed in 3D along an axis only");
  const RealVector direction{d.vector.at(0), d.vector.at(1), d.vector.at(2)};
  auto found = plain->pair->directional_least(plain->which, direction, d.mode == Mode::kAlong);
  if (!found) return found.refusal().within(written(wanted));
  if (!*found) return found;
  if (!(*found)->proven) found = confirmed(prepared, wanted, **found);
  if (!found) return found;
  return distance::in_unit(**found, prepared.world.step);
}

}  // namespace

Tried<LineSigns> signs_on(const PreparedSpace& prepared, const SignMap& map, const SpaceLine& line) {
  const Tried<space::BoxComplex> boxes = sign_map(prepared, map);
  if (boxes) return LineSigns{box_signs(*boxes, line), false, distance::Way::kMap};
  if (map.minimum || !prepared.world.rays) return boxes.refusal();
  return ray_signs(*prepared.world.rays, map, line);
}

Tried<space::BoxComplex> directional_map(const PreparedSpace& prepared, const SignMap& map) {
  const Tried<Axial> d = axial(prepared, map.distance);
  if (!d) return d.refusal();
  const auto boxes = d->plain.pair->boxes();
  if (!boxes) return boxes.refusal();
  return (*boxes)->directional_map(d->plain.which, map.level / prepared.world.step, d->axis, d->way);
}

Tried<std::optional<distance::BoxMaps::Least>> directional_least(const PreparedSpace& prepared,
                                                                 const Distance& wanted) {
  const Tried<Axial> d = axial(prepared, wanted);
  if (!d) return d.refusal();
  if (const auto boxes = d->plain.pair->boxes()) {
    auto found = (*boxes)->directional_least(d->plain.which, d->axis, d->way);
    if (found) return found;
  }
  return refused(wanted, "the exact least value along a direction needs axis-parallel faces");
}

/// On lines the least value stands for where it is taken.
Tried<std::optional<distance::Answer>> directional_nearly_least(const PreparedSpace& prepared, const Distance& wanted) {
  const auto tried = directional_least(prepared, wanted);
  if (!tried) return least_of_parts(prepared, wanted);
  const std::optional<distance::BoxMaps::Least>& found = *tried;
  if (!found)
    return is_farthest(wanted.kind) ? Tried<std::optional<Answer>>(std::nullopt) : least_of_parts(prepared, wanted);
  const Real value = found->value * prepared.world.step;
  if (found->at.empty()) {
    distance::Answer out = distance::least_answer(value, value, true, {}, distance::Way::kBoxes);
    out.side = distance::Side::kNone;
    return out;
  }
  RealVector at;
  const space::IntervalBox box = found->at.boxes()[0];
  for (std::size_t k = 0; k < 3; ++k) {
    const auto &from = box[k].from, &to = box[k].to;
    at[k] = from && to ? (*from + *to) / Real(2) : from ? *from + Real(1) : to ? *to - Real(1) : Real();
  }
  return distance::least_answer(value, value, true, space::scaled(prepared.world.step, at), distance::Way::kBoxes);
}

/// Whether the value at p is the least.
Tried<bool> takes_least(const PreparedSpace& prepared, const Distance& wanted, const std::optional<Answer>& v,
                        const RealVector& p) {
  if (const auto whole = least(prepared, wanted)) return whole->at.mark(p) != 0;
  const auto nearly = directional_nearly_least(prepared, wanted);
  if (!nearly) return nearly.refusal();
  const std::optional<distance::Answer>& least = *nearly;
  if (!v || v->minus_infinity || !least || !is_taken(*least)) return false;
  const Real value = v->value * prepared.world.step;
  if (least->proven && v->proven) return value == least->value;
  if (least->value < value) return false;
  return refused(wanted, "the value is too near the least one, which is not exact, to tell whether it is that");
}

Tried<std::optional<Answer>> directional_value(const PreparedSpace& prepared, const Distance& wanted,
                                               const RealVector& p) {
  if (wanted.prefix != Extremum::kNone) return refused(wanted, "distances over time are not computed in 3D");
  const SpaceLine line{p, {wanted.vector.at(0), wanted.vector.at(1), wanted.vector.at(2)}};
  const Tried<LineSigns> found_signs =
      signs_on(prepared, level_zero(moving_first(wanted, prepared.world.moving)), line);
  if (!found_signs) return found_signs.refusal();
  const bool farthest = is_farthest(wanted.kind), both_ways = wanted.mode == Mode::kAlong;
  if (found_signs->searched)
    return bounded_value(wanted, distance::translation_bounds(found_signs->section, farthest, both_ways), line);
  const auto found = distance::translation_value(found_signs->section, farthest, both_ways);
  if (!found) return std::nullopt;
  if (found->lowest) return distance::lowest_answer<distance::SpacePosition>(found_signs->way);
  Answer out;
  out.way = found_signs->way;
  out.value = found->value();
  if (!farthest && found->sign != 0) out.nearest = at_way(line, found->t);
  return out;
}

}  // namespace findspace::formula
