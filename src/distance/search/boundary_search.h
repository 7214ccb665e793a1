// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The place of a domain nearest to a convex set, or farthest from a union of such, among those that convex functions
// allow: each of `reverse_convex` is to be at least 0 there (the place is outside a grown set), each of `convex` at
// most 0 (inside one). So distances to and from round boundaries are found, of which planes alone are not enough.
// Branch and bound over tetrahedra: over a cell a convex function is at most the mean of its values at the corners, and
// at least what its tangent is there; weights for which no place of the cell can be allowed and better than the best
// one known are a linear program, whose other side is a place to try. Both bounds are off by the square of a cell's
// size, so smooth boundaries cost a few cells a halving. Guarantee: doubles; `place` is allowed, by more than rounding;
// no allowed place is better than `bound`. Passages and places of zero clearance, which numbers cannot tell from closed
// ones, make `bound` differ from `value` (or nothing is found), unless such a place is known: `unresolved` is one.
// Cost: some hundred to some thousand cells, each as many values as functions are near 0 in it. Keywords: reverse
// convex programming, penetration depth, global optimisation.
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "distance/search/boundary_cells.h"
#include "distance/search/solid_max_min.h"
#include "exact/margins/space_distance.h"
#include "exact/number/interval.h"

namespace findspace::distance {

/// A convex function at x: value + slope . (y - x) is nowhere more than it. No step changes it by more than its length.
struct Touching {
  double value = 0;
  space::Vector slope;
};
using TouchingConstraint = std::function<Touching(const space::Vector&)>;

struct Constraints;

/// What else places have to keep out of, which no few convex functions say: each cell is decided those that count
/// there.
class LazyConstraints {
 public:
  virtual ~LazyConstraints() = default;
  /// This, and convex functions that count in all cells.
  virtual Constraints constraints() = 0;
  /// By number a function that is at least 0 at all allowed places. Numbers of one search stay.
  virtual double beyond(int number, const space::Vector& x) const = 0;
  /// At the corners of a cell, what is linear between them and there nowhere less than the function, or another one
  /// that is at least 0 at all allowed places.
  virtual std::array<double, 4> column(int number, const Tetrahedron& cell) const {
    return {beyond(number, cell[0]), beyond(number, cell[1]), beyond(number, cell[2]), beyond(number, cell[3])};
  }
  /// Those for a cell, with its longest edge, of one that had those of `known`: the numbers.
  virtual std::vector<int> near(const Tetrahedron& cell, double edge, std::span<const int> known) = 0;
  /// Whether the place keeps all of them, known or not; `known` may tell at once that it does not.
  virtual bool allows(const space::Vector& x, std::span<const int> known) const = 0;
  /// Places of such a cell that are known to be allowed.
  virtual std::vector<space::Vector> places(const Tetrahedron& /*cell*/) const { return {}; }
  /// Whether so much was done that the search is to end.
  virtual bool spent() const = 0;
  /// Of the sizes: what is better by less is not looked for; where a cell of this size is left the search ends.
  virtual double nearer() const { return margin::kNearerAtAll; }
  virtual double last_cell() const { return 0; }
};

struct Constraints {
  std::vector<ConvexDistance> reverse_convex;
  std::vector<TouchingConstraint> convex;
  LazyConstraints* more = nullptr;
};

/// The objective at a place of zero clearance that is known to be allowed; asked once, where the search comes to one or
/// is long, or first where there are LazyConstraints or a FarEnd is coarse.
using Incumbent = std::function<std::optional<double>()>;

inline constexpr int kMostSearchCells = 60000;

struct BoundaryPlace {
  bool found = false;
  double value = 0, bound = 0;
  space::Vector place;
  std::optional<space::Vector> unresolved;
  bool known = false;    // instead of `found`: the value is that at the place asked for
  bool complete = true;  // false: ended at a limit of cells
};

/// A search that need not end: it may where how far the value is from the level, and on which side, is known but for
/// that share, or where it is within `blur` of the level. With `blur` it does not matter how much more than that the
/// value is. It may also end at so many cells, those of searches within it included (search_work.h).
struct Until {
  double level = 0, share = 0, blur = 0;
  long cells = std::numeric_limits<long>::max();
};

/// `size`: of the coordinates and of what the functions are made of. `floor`: no allowed place is nearer.
BoundaryPlace nearest_allowed(std::span<const Tetrahedron> domain, const Constraints& constraints,
                              const TouchingConstraint& distance, double size, double floor,
                              const Incumbent& known = {}, const Until* until = nullptr);
/// What a search for the farthest place knows: no place is farther than `ceiling`. What is farther than the best by
/// less than `nearer` of the sizes is not looked for.
struct FarEnd {
  double ceiling = exact::kInfinity, nearer = margin::kNearerAtAll;
};
/// At which the least of the distances is greatest: farthest from a union.
BoundaryPlace farthest_allowed(std::span<const Tetrahedron> domain, const Constraints& constraints,
                               std::span<const ConvexDistance> distances, double size, const Incumbent& known = {},
                               const FarEnd& end = {});

/// The most slack of what functions allow: the greatest t with each of `reverse_convex` at least t and each of `convex`
/// at most -t. More than 0 says that the allowed places have interior. The search is tetrahedral_max_min.h; the slack
/// in a cell is at most a linear program of what the functions are at most and of their tangents. `value` is that at
/// `place`, no place of the domain has more than `bound`.
struct Slack {
  double value = 0, bound = 0;
  space::Vector place;
  int cells = 0;  // that were divided
};

struct SlackEnd {
  double enough = 0;   // the bound need not be less
  double share = 0.5;  // of the bound: a value that is more than enough and so much of it need not be more
  double blur = 0;     // as near as the bound has to come to the value
};
Slack most_slack(std::span<const Tetrahedron> domain, const Constraints& constraints, const SlackEnd& end);

}  // namespace findspace::distance
