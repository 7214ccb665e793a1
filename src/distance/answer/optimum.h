// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What `minimize`, `maximize` and `distance -> min` find: the best value over a set of positions, of angles or of
// places on lines, and where it is taken, in whatever form the set is. One type from the searches to C++, JSON and
// text. Lengths in the steps of the asker. Guarantee: the best value lies between the bounds of the answer, and is its
// value where `proven()`. Keywords: constrained minimum, argmin, infimum.
#pragma once

#include <optional>
#include <utility>

#include "distance/answer/answer.h"

namespace findspace::distance {

enum class Sense { kMinimum, kMaximum };
inline Sense opposite(Sense s) { return s == Sense::kMinimum ? Sense::kMaximum : Sense::kMinimum; }

struct OptimalValue {
  Sense sense = Sense::kMinimum;
  /// Nothing where there is none: the set is empty, or unbounded in this sense, or the distance undefined. If it is not
  /// proven, it is enclosed: on the one side by value(), where its side is kInner, on the other by bound(). Of kOuter
  /// there is a bound alone. Of kNone the value is that of a place near the set, and perhaps of none in it.
  std::optional<SceneAnswer> answer;
  bool unbounded = false;  // no bound in this sense; or -infinity everywhere
  bool attained = false;   // by a place of the set; else an infimum (supremum)
  double within = 0;       // where not proven: every best place is as near as that to a given one; infinite: not known

  bool maximum() const { return sense == Sense::kMaximum; }
  bool proven() const { return !answer || answer->proven; }
  /// There is a best value, or -infinity, and a place of the set, of its closure or near it has it.
  bool exists() const;
  /// A finite one.
  std::optional<exact::Real> value() const;
  /// Where not proven: no place has a better value. Nothing: no bound is known.
  std::optional<exact::Real> bound() const;

  void set_exact(exact::Real value, Way way);
  /// `reached`: by a place of the set or of its closure.
  void set_enclosed(std::optional<exact::Real> reached, std::optional<exact::Real> bound, Way way);
  /// The value of a place that need not be of the set.
  void set_nearby(exact::Real value, std::optional<exact::Real> bound, Way way);
  /// A least value as a search has found it, with its place and witness.
  void set_found(SceneAnswer least);
  /// -infinity is taken everywhere.
  void set_lowest(Way way);
  /// Of minus the objective, in the other sense.
  void negate();
  /// In another unit of values: `unit` of the old ones are one of the new ones.
  void scale(const exact::Real& unit);
};

template <class Set>
struct OptimumOf : OptimalValue {
  Set at;  // in grid steps: of the set, or of its closure if not attained
};

/// None found yet, or `unbounded`.
template <class Set>
OptimumOf<Set> no_optimum(Sense sense, bool unbounded = false, Set at = Set()) {
  OptimumOf<Set> out{{}, std::move(at)};
  out.sense = sense;
  out.unbounded = unbounded;
  return out;
}

}  // namespace findspace::distance
