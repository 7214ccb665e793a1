// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The demands of a formula at positions of space: how far each is from being met, and whether it is. Lengths and
// positions in grid steps. Guarantee: numbers lie between the given bounds; what is said to be met is. Plain distances,
// and with them these numbers, change by at most the length of a step of the moving shape. Cost: an exact value for
// each distance; of `within` doubles, which is a hundredth of it. Threads: any number. Keywords: constraint violation,
// slack.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "exact/number/interval.h"
#include "formula/explain/conflict.h"
#include "formula/solid/solve_space.h"

namespace findspace::formula {

struct DemandsAt {
  std::vector<exact::Interval> distance;  // of each demand; +infinity where it is undefined
  std::vector<exact::Interval> slack;     // how far the distance lies on the side of its level that is demanded
  MetDemands met;                         // certainly
  bool open = false;                      // how far one is from being met has no bound, and a value may tell one
};

class DemandValues {
 public:
  /// Keeps references. Throws Error(kUnsupported) for distances along a direction, and for `-> min`.
  DemandValues(const SpaceSolver& solver, const Demands& demands);

  /// Throws the error of a distance that is not computed.
  DemandsAt at(const space::RealVector& p) const;
  /// What numbers tell of it. The distances of large meshes come last, and none that is left where enough(what is
  /// known).
  DemandsAt within(const space::Vector& p, const std::function<bool(const DemandsAt&)>& enough) const;
  /// The value of the distance of demand k, nothing where it is infinite.
  std::optional<distance::Answer> value(std::size_t k, const space::RealVector& p) const;

 private:
  const SpaceSolver& solver_;
  const Demands& demands_;
  void set(DemandsAt& here, std::size_t k, const exact::Interval& distance) const;

  std::vector<exact::Real> levels_;  // in grid steps
  std::vector<exact::Interval> near_levels_;
  /// A distance and the demands on it; those of large meshes last.
  struct Asked {
    SpaceSolver::QuickDistance distance;
    std::vector<std::size_t> demands;
  };
  std::vector<Asked> asked_;
};

}  // namespace findspace::formula
