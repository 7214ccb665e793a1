// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The answer to a question about a distance: its value at a position, or its least value over positions. One type in
// the plane and in space, from the searches to the formulas: the value, whether it is exact, what encloses it, who
// takes it, and which way found it. Lengths in the steps of the asker. Guarantee: the true value lies from lower() to
// upper(). Keywords: result, enclosure, witness.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "distance/answer/side.h"
#include "distance/answer/way.h"
#include "exact/number/tried.h"
#include "exact/planar/geometry.h"
#include "plane/query/locate.h"

namespace findspace::distance {

/// A point of one of the shapes, with B at its place. V: a position.
template <class V>
struct FeatureOf {
  bool of_moving = false;
  std::optional<plane::Cell> cell;  // in the plane, of that shape: vertex or edge; dimension 2: a point inside
  V at{};
};

/// What a value that is not proven may be off at least.
double rounding_of(const exact::Real& value);

/// A position in space (space::RealVector), which this header does without: it stands below the public interface too.
using SpacePosition = std::array<exact::Real, 3>;

/// The ends of what a value that is not exact lies between; without one it has no bound there.
struct Enclosure {
  std::optional<exact::Real> lower, upper;

  /// How far the ends, which are both there, are apart.
  double width() const { return (*upper - *lower).to_double(); }
};

/// The ends as doubles that are not within; infinite where there is none.
struct OutwardEnds {
  double lower, upper;
};
OutwardEnds outward(const Enclosure& ends);

template <class V>
struct AnswerOf {
  exact::Real value;
  bool proven = true;           // the exact number; else `enclosed`, or within 2^-34 relative or within `error`
  Side side = Side::kExact;     // of the value, where it is not proven
  bool minus_infinity = false;  // and `value` means nothing
  std::optional<V> nearest;     // signed distances: the nearest position where they are 0, if the value is not
  std::optional<V> farthest;    // eta2, delta2: the position of the farthest touching
  /// Two points that take the distance, where it is one of points: of B + p first. Of a diameter perhaps both of one.
  std::vector<FeatureOf<V>> witness;
  double error = 0;  // what a value that is not proven may be off
  std::optional<Enclosure> enclosed;
  Way way = Way::kParts;
  V at{};  // of a least value: a position that takes it

  void set_unproven(Side where = Side::kMixed) {
    proven = false;
    side = where;
  }
  /// What the value at a position may be off, with room for its rounding; 0 where it is proven.
  double slack() const { return proven ? 0 : std::max(rounding_of(value), error); }
  Enclosure bounds() const {
    if (proven) return {value, value};
    if (enclosed) return *enclosed;
    const exact::Real off = exact::Real::from_double(slack());
    return {value - off, value + off};
  }
};

using Answer = AnswerOf<SpacePosition>;
/// Nothing where the distance is undefined: +infinity. Refused where it is not computed.
using TriedAnswer = exact::Tried<std::optional<Answer>>;
using PlanarAnswer = AnswerOf<exact::RealPoint>;
using Feature = FeatureOf<exact::RealPoint>;

/// A place of the plane or of space.
using Coordinates = std::vector<exact::Real>;
/// The answer as a scene has it, in its unit.
using SceneAnswer = AnswerOf<Coordinates>;
inline Coordinates coordinates(const exact::RealPoint& p) { return {p.x, p.y}; }
inline Coordinates coordinates(const SpacePosition& p) { return {p[0], p[1], p[2]}; }

inline exact::RealPoint times(const exact::Real& s, const exact::RealPoint& p) { return {s * p.x, s * p.y}; }
inline SpacePosition times(const exact::Real& s, const SpacePosition& p) { return {s * p[0], s * p[1], s * p[2]}; }

/// The answer with every place put through `place`, and every length times `unit`.
template <class Place, class V>
auto in_unit(const AnswerOf<V>& a, const exact::Real& unit, const Place& place)
    -> AnswerOf<std::invoke_result_t<Place, const V&>> {
  AnswerOf<std::invoke_result_t<Place, const V&>> out;
  out.value = a.value * unit;
  out.proven = a.proven;
  out.side = a.side;
  out.minus_infinity = a.minus_infinity;
  if (a.nearest) out.nearest = place(*a.nearest);
  if (a.farthest) out.farthest = place(*a.farthest);
  for (const FeatureOf<V>& f : a.witness) out.witness.push_back({f.of_moving, f.cell, place(f.at)});
  out.error = a.error * unit.to_double();
  out.enclosed = a.enclosed;
  if (out.enclosed && out.enclosed->lower) *out.enclosed->lower *= unit;
  if (out.enclosed && out.enclosed->upper) *out.enclosed->upper *= unit;
  out.way = a.way;
  out.at = place(a.at);
  return out;
}

/// "(1+2*sqrt(5))/3": of an exact value that has one.
std::optional<std::string> closed_form(const SceneAnswer& answer);

/// In another unit of length: `unit` of the old ones are one of the new ones.
template <class V>
AnswerOf<V> in_unit(const AnswerOf<V>& a, const exact::Real& unit) {
  return in_unit(a, unit, [&](const V& p) { return times(unit, p); });
}

/// With places as plain coordinates.
template <class V>
SceneAnswer in_scene(const AnswerOf<V>& a, const exact::Real& unit) {
  return in_unit(a, unit, [&](const V& p) { return coordinates(times(unit, p)); });
}

/// The answer, knowing that the value has that sign against the level: what it lies between ends there.
template <class V>
AnswerOf<V> narrowed(AnswerOf<V> a, const exact::Real& level, int sign) {
  if (a.proven || a.minus_infinity) return a;
  if (sign == 0) {
    a.value = level;
    a.proven = true;
    a.side = Side::kExact;
    a.error = 0;
    a.enclosed.reset();
    return a;
  }
  Enclosure ends = a.bounds();
  std::optional<exact::Real>& near = sign > 0 ? ends.lower : ends.upper;
  if (!near || (*near - level).sign() * sign < 0) near = level;
  if ((a.value - level).sign() * sign <= 0) {
    const std::optional<exact::Real>& far = sign > 0 ? ends.upper : ends.lower;
    a.value = far ? (level + *far) / exact::Real(2) : level;
  }
  if (ends.lower && ends.upper) a.error = ends.width();
  a.enclosed = std::move(ends);
  return a;
}

/// An exact value.
template <class V = exact::RealPoint>
AnswerOf<V> exact_answer(exact::Real value, Way way, std::optional<V> nearest = {}) {
  AnswerOf<V> out;
  out.value = std::move(value);
  out.way = way;
  out.nearest = std::move(nearest);
  return out;
}

/// A value that a search leaves between two numbers, in whichever order.
inline PlanarAnswer enclosed_answer(exact::Real value, exact::Real a, exact::Real b) {
  PlanarAnswer out = exact_answer(std::move(value), Way::kSearch);
  out.set_unproven();
  out.error = abs(b - a).to_double();
  out.enclosed = a < b ? Enclosure{std::move(a), std::move(b)} : Enclosure{std::move(b), std::move(a)};
  return out;
}

/// Minus infinity.
template <class V = exact::RealPoint>
AnswerOf<V> lowest_answer(Way way) {
  AnswerOf<V> out = exact_answer<V>(exact::Real(), way);
  out.minus_infinity = true;
  return out;
}

/// Minus a value that is not minus infinity.
template <class V>
AnswerOf<V> minus(AnswerOf<V> a) {
  a.value = -a.value;
  if (!a.enclosed) return a;
  std::swap(a.enclosed->lower, a.enclosed->upper);
  if (a.enclosed->lower) *a.enclosed->lower = -*a.enclosed->lower;
  if (a.enclosed->upper) *a.enclosed->upper = -*a.enclosed->upper;
  return a;
}

/// Two points, of B + p and of A.
inline std::vector<FeatureOf<SpacePosition>> point_pair(SpacePosition of_b, SpacePosition of_a) {
  return {{true, std::nullopt, std::move(of_b)}, {false, std::nullopt, std::move(of_a)}};
}

/// The points of the same pair with the roles exchanged: of what was A, moved by p, and of what was B - p.
void exchange_roles(Answer& answer, const SpacePosition& p);

/// A least value that is taken at `at`; no position has less than `bound`. `way`: of one that is proven.
inline Answer least_answer(exact::Real value, exact::Real bound, bool proven, SpacePosition at, Way way = Way::kParts) {
  Answer out;
  if (!proven) out.enclosed = Enclosure{std::move(bound), value};
  out.value = std::move(value);
  out.at = std::move(at);
  out.way = proven ? way : Way::kSearch;
  if (!proven) out.set_unproven(Side::kInner);
  return out;
}

/// A signed distance whose zero set is nearest at q.
Answer signed_value(const SpacePosition& p, const SpacePosition& q, int sign);

/// max(0, v), or max(0, -v) if `negated`; nothing stands for +infinity.
template <class V>
std::optional<AnswerOf<V>> cut_off(std::optional<AnswerOf<V>> v, bool negated) {
  if (!v) return negated ? std::optional(AnswerOf<V>{}) : std::nullopt;
  if (v->minus_infinity) return negated ? std::nullopt : std::optional(AnswerOf<V>{});
  const auto cut = [](exact::Real& x) {
    if (x.sign() < 0) x = exact::Real();
  };
  if (negated) v = minus(*std::move(v));
  if (const Enclosure ends = v->bounds(); ends.upper && ends.upper->sign() < 0) {
    // What attains v does not attain 0.
    AnswerOf<V> none;
    none.way = v->way;
    return none;
  }
  cut(v->value);
  if (v->enclosed && v->enclosed->lower) cut(*v->enclosed->lower);
  if (v->enclosed && v->enclosed->upper) cut(*v->enclosed->upper);
  return v;
}

template <class V>
std::optional<AnswerOf<V>> cut_off(AnswerOf<V> v, bool negated) {
  return cut_off(std::optional(std::move(v)), negated);
}

/// The greater of two values.
template <class V>
AnswerOf<V> greater(AnswerOf<V> a, AnswerOf<V> b) {
  if (a.minus_infinity || (!b.minus_infinity && a.value < b.value)) std::swap(a, b);
  if (b.minus_infinity || (a.proven && b.proven)) return a;
  Enclosure ends = a.bounds(), other = b.bounds();
  const bool lower = !ends.lower || (other.lower && *ends.lower < *other.lower),
             upper = ends.upper && (!other.upper || *ends.upper < *other.upper), wider = upper || !ends.lower;
  if (lower) ends.lower = std::move(other.lower);
  if (upper) ends.upper = std::move(other.upper);
  if (a.error == 0 && !a.enclosed) a.error = a.slack();
  if (wider && ends.lower && ends.upper) a.error = std::max(a.error, ends.width());
  a.set_unproven();
  a.enclosed = std::move(ends);
  return a;
}

}  // namespace findspace::distance
