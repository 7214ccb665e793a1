// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A formula read as a monotone function of its demands: an atom demands its relation, or under `not` the opposite one.
// The more demands hold or are dropped, the larger is the set of positions. So "which atoms contradict each other" has
// an answer for every formula, not only for a conjunction. Guarantee: exact, Boolean algebra alone. Cost: linear in the
// formula. Keywords: negation normal form, literal, monotone Boolean function, polarity.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "formula/language/formula.h"

namespace findspace::formula {

/// The relation that holds where `relation` does not.
Relation opposite(Relation relation);

class Demands {
 public:
  explicit Demands(const Formula& formula);

  const Formula& formula() const { return formula_; }
  /// One for each atom of the formula, in order.
  std::size_t size() const { return relations_.size(); }
  /// What atom k demands of its distance.
  Relation relation(std::size_t k) const { return relations_[k]; }
  /// The demand has a level that can be moved: not `-> min`, not `!=`.
  bool has_level(std::size_t k) const;
  /// Its level is one of degrees: its distance is in rotation.
  bool in_degrees(std::size_t k) const { return formula_.atoms()[k].distance.mode == Mode::kRotation; }
  bool holds(std::size_t k, std::int8_t sign) const;

  /// The truth of the formula where demand k is met if met[k].
  bool truth(const std::vector<bool>& met) const;
  /// The least number of each `and`, the greatest of each `or`: of numbers that are not negative where demands are met
  /// one that is not negative where the formula holds.
  double measure(const std::vector<double>& numbers) const;
  /// The demand alone.
  Formula demand(std::size_t k) const;
  /// The same relation at another level.
  Formula demand(std::size_t k, const exact::Real& level) const;
  /// The formula with every demand k replaced by part(k).
  Formula with(const std::function<Formula(std::size_t)>& part) const;
  /// The formula with demand k replaced.
  Formula with(std::size_t k, const Formula& part) const;

 private:
  Formula formula_;
  std::vector<bool> positive_;
  std::vector<Relation> relations_;
};

}  // namespace findspace::formula
