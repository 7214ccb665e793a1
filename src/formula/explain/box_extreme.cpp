// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "formula/explain/box_extreme.h"

#include <algorithm>
#include <array>

#include "space/box/box_operations.h"

namespace findspace::formula {

using distance::Sense;
using exact::Real;
using space::BoxComplex;
using space::IntervalBox;
using space::Mark;
using space::RealVector;
using End = std::optional<Real>;

namespace {

BoxComplex without(const BoxComplex& a, const BoxComplex& b) {
  return overlay(std::array<const BoxComplex*, 2>{&a, &b}, [](std::span<const Mark> m) { return Mark(m[0] && !m[1]); });
}

BoxComplex both(const BoxComplex& a, const BoxComplex& b) {
  return overlay(std::array<const BoxComplex*, 2>{&a, &b}, [](std::span<const Mark> m) { return Mark(m[0] && m[1]); });
}

/// The one nearer to 0 of two ends; of none the other one.
End least(const End& a, const End& b) { return !a || (b && *b < *a) ? b : a; }
End greatest(const End& a, const End& b) { return !a || (b && *a < *b) ? b : a; }

/// A number from one end to the other.
Real between(const End& from, const End& to) {
  return from && to ? (*from + *to) / Real(2) : from ? *from : to ? *to : Real();
}

struct Pair {
  Real square;
  RealVector at;  // of the first box
};

Pair nearest_of(const IntervalBox& a, const IntervalBox& b) {
  Pair out;
  for (std::size_t k = 0; k < 3; ++k) {
    if (a[k].to && b[k].from && *a[k].to < *b[k].from) {
      out.at[k] = *a[k].to;
      out.square += (*b[k].from - *a[k].to) * (*b[k].from - *a[k].to);
    } else if (a[k].from && b[k].to && *b[k].to < *a[k].from) {
      out.at[k] = *a[k].from;
      out.square += (*a[k].from - *b[k].to) * (*a[k].from - *b[k].to);
    } else {
      out.at[k] = between(greatest(a[k].from, b[k].from), least(a[k].to, b[k].to));
    }
  }
  return out;
}

std::optional<BoxExtreme> apart(const BoxComplex& set, const BoxComplex& from) {
  std::optional<BoxExtreme> out;
  const std::vector<IntervalBox> far = from.boxes();
  for (const IntervalBox& a : set.boxes()) {
    for (const IntervalBox& b : far) {
      const Pair pair = nearest_of(a, b);
      if (out && pair.square > out->value) continue;
      const bool attained = set.mark(pair.at) != 0;
      if (out && pair.square == out->value && (out->attained || !attained)) continue;
      out = {pair.square, pair.at, attained};
    }
  }
  if (out) out->value = sqrt(out->value);
  return out;
}

bool is_open(const IntervalBox& box) {
  return std::all_of(box.begin(), box.end(), [](const space::Interval& i) {
    return !i.from_in && !i.to_in && !(i.from && i.to && !(*i.from < *i.to));
  });
}

/// How deep a place of one box lies in an open one, at most; nothing where they do not meet or there is no end.
std::optional<BoxExtreme> deepest_of(const IntervalBox& a, const IntervalBox& open) {
  End depth;
  for (std::size_t k = 0; k < 3; ++k) {
    const space::Interval &i = a[k], &o = open[k];
    if (o.from && i.to) depth = least(depth, *i.to - *o.from);
    if (o.to && i.from) depth = least(depth, *o.to - *i.from);
    if (o.from && o.to) depth = least(depth, (*o.to - *o.from) / Real(2));
  }
  if (!depth || depth->sign() <= 0) return std::nullopt;
  BoxExtreme out{*depth, {}, false};
  for (std::size_t k = 0; k < 3; ++k) {
    const space::Interval &i = a[k], &o = open[k];
    out.at[k] = between(greatest(i.from, o.from ? End(*o.from + *depth) : End()),
                        least(i.to, o.to ? End(*o.to - *depth) : End()));
  }
  return out;
}

std::optional<BoxExtreme> deepest(const BoxComplex& set, const BoxComplex& open) {
  const std::vector<IntervalBox> around = open.simplified().boxes();
  if (!std::all_of(around.begin(), around.end(), is_open)) return std::nullopt;
  const auto bounded = [](const space::Interval& i) { return i.from && i.to; };
  std::optional<BoxExtreme> out;
  for (const IntervalBox& a : set.boxes()) {
    for (const IntervalBox& b : around) {
      // Without an end there might be no deepest place.
      if (!std::any_of(b.begin(), b.end(), bounded) && !std::all_of(a.begin(), a.end(), bounded)) return std::nullopt;
      auto found = deepest_of(a, b);
      if (!found) continue;
      found->attained = set.mark(found->at) != 0;
      if (!out || out->value < found->value || (out->value == found->value && found->attained)) out = found;
    }
  }
  return out;
}

}  // namespace

std::optional<BoxExtreme> box_extreme(const SpaceSolver& solver, const Distance& distance, const BoxComplex& set,
                                      Sense sense) {
  if (distance.kind != formula::Kind::kGamma1 && distance.kind != formula::Kind::kEta1 &&
      distance.kind != formula::Kind::kDelta1)
    return std::nullopt;
  const bool least_wanted = sense == Sense::kMinimum;
  const auto side = [&](Relation relation) {
    return solver.try_feasible(Formula(compare(distance, relation, Real())));
  };
  // What follows is about the least value of the distance, or of minus the distance.
  const auto in = side(least_wanted ? Relation::kLessEqual : Relation::kGreaterEqual),
             out = side(least_wanted ? Relation::kGreaterEqual : Relation::kLessEqual);
  if (!in || !out) return std::nullopt;
  const BoxComplex inner = without(*in, *out), within = both(set, inner), at_level = both(set, both(*in, *out));
  const Real sign(least_wanted ? 1 : -1);
  std::optional<BoxExtreme> found;
  if (!within.empty()) {
    found = deepest(within, inner);
    if (found) found->value = -found->value;
  } else if (!at_level.empty()) {
    const IntervalBox box = at_level.boxes().front();
    found = BoxExtreme{Real(), {}, true};
    for (std::size_t k = 0; k < 3; ++k) found->at[k] = between(box[k].from, box[k].to);
  } else {
    found = apart(set, *in);
  }
  if (found) found->value *= sign;
  return found;
}

}  // namespace findspace::formula
