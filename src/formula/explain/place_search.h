// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The least value, over places of space that belong to a set, of a function that changes by at most the length of a
// step. The set is a union of boxes, or in them what a second such function leaves: its places have 0 or more there.
// Best first: boxes of least bound are divided, a fixed number at a time whatever the number of threads. Numbers bound
// them; a place is looked at exactly where these leave open whether it is the best one yet. Guarantee: no place has
// less than `bound`; `at` belongs and has `least`, exactly. Ends within `tolerance`, after kMostDivisions divisions, or
// after as many cells of searches as a question has. Coordinates in grid steps. Source: subdivide.h; Piyavskii 1972.
// Keywords: Lipschitz optimisation, branch and bound.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "exact/number/interval.h"
#include "space/polytope/real_vector.h"

namespace findspace::formula {

inline constexpr long kMostDivisions = 12000;

struct PlaceBox {
  space::Vector center, half;
};

/// What is seen at a place.
struct PlaceSeen {
  exact::Interval value;
  double inside = exact::kInfinity;  // not less than the second function
  bool belongs = true;               // certainly
  bool open = false;                 // `inside` may be less, which an exact look tells
};

struct PlaceSearch {
  std::function<PlaceSeen(const space::RealVector&)> look;  // called from many threads, as the next one
  /// What numbers tell of a place. It may end where what is known so far makes the rest needless.
  using Needless = std::function<bool(const PlaceSeen&)>;
  std::function<PlaceSeen(const space::Vector&, const Needless&)> glance;
  std::vector<space::RealVector> first{};  // looked at before all others
  double tolerance = 0;
  double enough = -exact::kInfinity;  // any place that belongs with no more will do
  double beyond = exact::kInfinity;   // places with more do not matter
};

struct PlaceFound {
  std::optional<space::RealVector> at;  // nothing: no place that was seen belongs
  double least = exact::kInfinity;      // its value is not above this
  double bound = exact::kInfinity;      // infinite: certainly no place belongs and has no more than `beyond`
  space::RealVector nearly{};           // where `inside` was greatest
};
PlaceFound find_place(const PlaceSearch& search, const std::vector<PlaceBox>& boxes);

}  // namespace findspace::formula
