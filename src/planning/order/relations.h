// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The sets behind the conditions of a placement: N_i = {p : the condition holds for body i at p} for conditions on one
// body, and N_ij = {q : it holds where p_i - p_j = q} for conditions on two; seen from the other body that is -N_ij, so
// the direction of directed distances is kept (distances.md 6.1). Each is made once for a formula and two rotated
// shapes, the one with i and the one with j, and then only moved. Guarantee: exact sets, open, closed or neither.
// Threads: safe. Keywords: no-fit map, relative position.
#pragma once

#include <memory>
#include <mutex>
#include <set>
#include <tuple>
#include <vector>

#include "plane/complex/broad_phase.h"
#include "planning/order/problem.h"

namespace findspace::planning {

/// A set with the box outside which it is all or nothing; no box: it is the plane or empty.
struct BoxedRegion {
  plane::Region region;
  std::optional<plane::PieceBox> box;
};
using BoxedPointer = std::shared_ptr<const BoxedRegion>;

/// The bodies that a formula's distances speak of, in ascending order.
std::vector<std::size_t> bodies_of(const formula::Formula& formula, const Roles& roles);
/// Whether every distance is between the same two bodies, or all are between one body and what stands still: the
/// condition is one set of (relative) positions.
bool is_single(const Condition& condition);

class Relations {
 public:
  /// Keeps a reference to the problem.
  explicit Relations(const Problem& problem);

  const Problem& problem() const { return problem_; }
  const formula::Solver& solver() const { return solver_; }

  /// Of a single condition: the positions of its one body; or the relative positions p_i - p_j of its two bodies i < j.
  BoxedPointer set(const Condition& condition, const Poses& angles) const;

  /// The positions of body i, at its angle in `poses`, at which the condition holds, the other bodies standing where
  /// `poses` says.
  plane::Region allowed(const Condition& condition, std::size_t body, const Poses& poses) const;
  /// The same where only positions within `where` matter: outside it the set may be anything. Nothing: every position
  /// there.
  std::optional<plane::Region> allowed_within(const Condition& condition, std::size_t body, const Poses& poses,
                                              const std::optional<plane::PieceBox>& where) const;

  /// A distance as the solver knows it, and the bodies of its arguments (none: it stands still).
  struct Bound {
    formula::Distance distance;
    std::optional<std::size_t> first, second;
  };
  Bound bind(const formula::Distance& distance, const Roles& roles, const Poses& angles) const;

 private:
  using Key = std::tuple<const formula::Formula*, std::vector<std::string>, std::vector<bool>>;

  plane::SignMap sign_map(const formula::Distance& distance, const formula::SignMap& wanted) const;
  plane::Region relative(const Condition& condition, const Poses& angles) const;
  plane::SignMap seen(const formula::SignMap& map, const Condition& condition, std::size_t body,
                      const Poses& poses) const;
  plane::Region general(const Condition& condition, std::size_t body, const Poses& poses) const;

  const Problem& problem_;
  formula::Solver solver_;
  mutable std::mutex guard_;
  mutable std::map<Key, BoxedPointer> sets_;
};

}  // namespace findspace::planning
