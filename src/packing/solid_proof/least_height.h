// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// That no layout of a few solids is lower, by branch and bound to a proof (height_tree.h): a tree for each way in which
// the copies can stand, but for the exchange of equal ones. Guarantee: the bound is proved in interval arithmetic. Gaps
// and conditions of pairs only make layouts higher, and are not looked at. The same for any number of threads. Cost:
// exponential: 7 parts of twenty facets in one orientation half a second, 8 two minutes. Source:
// phi.md 2. Keywords: global optimum, disjunctive programming, certificate of optimality.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "packing/solid_proof/height_tree.h"

namespace findspace::packing {

/// Whether a proof is tried: not too many copies nor ways in which they can stand, of forms that are exact and without
/// balls; no containers.
bool is_provable(const SolidProblem& problem, const SolidTable& table);

class LeastHeight {
 public:
  /// There is a layout of this height. Both must live as long.
  LeastHeight(const SolidProblem& problem, const SolidTable& table, double height);

  /// Goes on for a while. A lower layout, in doubles and without overlaps, where one was found.
  std::optional<std::vector<SolidPose>> search();
  /// What was found is proved, at this height.
  void set_height(double height) { below_ = std::min(below_, below(height)); }

  bool is_over() const { return trees_.empty(); }
  /// Whether none is lower than the height by more than a ten millionth of it.
  bool is_proved() const { return is_over() && over_ >= below_; }
  /// No layout is lower. When all is over it is less than the height by a ten millionth of it, or what was found last
  /// was not proved.
  double bound() const;
  /// The linear programs solved.
  std::uint64_t programs() const;

 private:
  static double below(double height);
  void divide();
  /// The lowest layout that was found; trees that are over are no more.
  std::optional<std::vector<SolidPose>> collect();

  std::vector<std::unique_ptr<const HeightChoices>> choices_;
  std::vector<HeightTree> trees_;
  double below_, over_ = exact::kInfinity;  // the least bound of trees that are over,
  std::uint64_t programs_ = 0;              // and their programs
};

}  // namespace findspace::packing
