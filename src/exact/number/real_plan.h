// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A plan is the expression graph below one Real as a flat list of steps, operands before their users, in which equal
// subexpressions are one step (value numbering). So evaluation is a loop, a root written twice counts once, and a graph
// of any depth needs no stack. Its value's root separation bound: real_bound.h. Internal to src/exact. Keywords: common
// subexpression elimination, root bound.
#pragma once

#include <cstdint>
#include <vector>

#include "exact/number/real_node.h"

namespace findspace::exact::detail {

/// kSmall is an inline rational, kLeaf a closed form of a node; kPlainRoot is the sqrt(n) such leaves share.
enum class StepKind : std::uint8_t { kSmall, kLeaf, kPlainRoot, kPolynomialRoot, kNeg, kAdd, kSub, kMul, kDiv, kSqrt };

struct Step {
  StepKind kind = StepKind::kSmall;
  int a = -1, b = -1;               // operands; of a quadratic leaf, a is the step of its sqrt(n)
  const Quadratic* leaf = nullptr;  // of kLeaf, and of kPlainRoot the leaf whose n it is
  const RootNode* polynomial = nullptr;
  Interval interval;  // the known enclosure
  Small small;        // of kSmall
  int first = 0;      // of kPolynomialRoot: where its coefficients begin in Plan::coefficients()
};

/// From 64-bit keys to step numbers: open addressing, no deletion.
class StepTable {
 public:
  StepTable() : slots_(64) {}
  /// The first slot for which the key is new or `accept(step)` holds, as the step there, or -1 and `step` put there.
  template <class Accept>
  int find_or_put(std::uint64_t key, int step, Accept accept);
  int find(std::uint64_t key) const;  // -1 if absent; for tables whose keys are unique
  void put(std::uint64_t key, int step);

 private:
  struct Slot {
    std::uint64_t key = 0;
    int step = -1;
  };
  std::size_t start(std::uint64_t key) const { return (key * 0x9E3779B97F4A7C15ULL >> 20) & (slots_.size() - 1); }
  void grow();

  std::vector<Slot> slots_;
  std::size_t used_ = 0;
};

class Plan {
 public:
  explicit Plan(const Real& x);

  const std::vector<Step>& steps() const { return steps_; }
  int root() const { return root_; }
  bool is_zero() const;  // seen without arithmetic: x - x
  /// Of all polynomials, as steps.
  const std::vector<int>& coefficients() const { return coefficients_; }
  /// About log2 of the absolute error of the value in units of 2^-precision, from the doubles known; infinite where
  /// they tell nothing. A heuristic for choosing a precision.
  double error_bits() const;

 private:
  int build(const Real& x);
  int step_of(const Real& x);  // -1 if x is an operation not done yet
  int leaf_step(const Real& x);
  int small_step(const Small& value);
  int plain_root_step(const Quadratic& leaf);
  int operation_step(const OperationNode& node, int a, int b);
  int polynomial_step(const RootNode& node);
  bool operands_ready(const Node& node, std::vector<const Real*>& open);

  std::vector<Step> steps_;
  std::vector<int> coefficients_;
  StepTable of_node_, leaves_, operations_;
  int root_ = 0;
};

}  // namespace findspace::exact::detail
