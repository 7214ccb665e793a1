// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Whether a formula holds in cells, from the demands that fail in each: mostly few do, and what they make fail is
// followed upwards from them (counters at each `and` and `or`). Guarantee: exact, Boolean algebra alone; the work is
// counted, and Error(kLimit) ends it. Cost: of a cell, the demands that fail there and what fails because of them. Not
// for several threads at once. Keywords: unit propagation, counter-based evaluation, watched operands.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "formula/explain/demands.h"
#include "plane/base/allowed_work.h"

namespace findspace::formula {

using MetDemands = std::vector<bool>;  // for each demand, whether a cell meets it

/// What costs more units than the asker allows.
inline constexpr std::string_view kManyDemands = "an explanation of so many conditions";

/// The parts of a formula that fail because demands do.
class FailingParts {
 public:
  explicit FailingParts(const Demands& demands);

  /// One more demand fails. Whether the formula does.
  bool fail(std::size_t k) { return always_ || climb(demand_[k]); }
  /// Now no demand fails. How many parts were looked at since the last time.
  std::size_t forget();
  bool always() const { return always_; }

 private:
  void add(const Node& node, bool positive, std::uint32_t parent);
  bool climb(std::uint32_t part);

  // Of each part, the formula first.
  std::vector<std::uint32_t> parent_, need_, failures_;  // it fails where `need` operands do
  std::vector<std::uint32_t> demand_;                    // the parts that are demands
  std::vector<std::uint32_t> never_;                     // those that are false
  std::vector<std::uint32_t> touched_;
  bool always_ = false;
};

class FailingCells {
 public:
  static constexpr std::size_t kNoDemand = std::size_t(-1);

  FailingCells(const Demands& demands, const std::vector<MetDemands>& cells);

  std::size_t size() const { return start_.size() - 1; }
  std::size_t demands() const { return demands_; }
  /// The demands that fail in a cell, in order.
  std::span<const std::uint32_t> failing(std::size_t cell) const {
    return {failing_.data() + start_[cell], start_[cell + 1] - start_[cell]};
  }

  /// Whether the formula holds in each cell where only the demands k with counts(k) do.
  template <class Counts>
  std::vector<bool> where(const Counts& counts) {
    std::vector<bool> out(size());
    for (std::size_t cell = 0; cell < size(); ++cell) out[cell] = holds(cell, counts, kNoDemand);
    pay();
    return out;
  }
  /// The first cell where it does and demand `also` fails, too; size() if there is none.
  template <class Counts>
  std::size_t first(const Counts& counts, std::size_t also = kNoDemand) {
    std::size_t cell = 0;
    while (cell < size() && !holds(cell, counts, also)) ++cell;
    pay();
    return cell;
  }
  /// Whether what is left of the work allows to look at all cells.
  bool allows_a_pass() const { return work_.left() > most_ / kLooksAUnit; }

 private:
  static constexpr std::uint64_t kLooksAUnit = 32;

  template <class Counts>
  bool holds(std::size_t cell, const Counts& counts, std::size_t also) {
    bool fails = parts_.always() || (also != kNoDemand && parts_.fail(also));
    for (const std::uint32_t k : failing(cell)) {
      if (fails) break;
      ++looks_;
      fails = counts(k) && parts_.fail(k);
    }
    looks_ += 1 + parts_.forget();
    return !fails;
  }
  void pay();

  FailingParts parts_;
  std::size_t demands_;
  std::vector<std::uint32_t> failing_;  // cell after cell
  std::vector<std::size_t> start_{0};   // where those of a cell begin
  std::uint64_t most_ = 0;              // looks that a pass may take
  std::uint64_t looks_ = 0;             // not yet paid
  plane::WorkBudget work_ = plane::allowed_work();
};

}  // namespace findspace::formula
