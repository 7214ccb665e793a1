// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A plan is the expression graph below one Real as a flat list of steps, operands before their users, in which equal
// subexpressions are one step (value numbering). So evaluation is a loop, a root written twice counts once, and a graph
// of any depth needs no stack. The plan also knows the root separation bound of its value:
//
// BFMSS (ESA 2001, theorem 1). Rewriting without divisions, every step is U/L with algebraic integers U, L, all
// conjugates of which are at most u and l in magnitude:
//     (p + r sqrt n)/q:  u = |p| + |r| sqrt n,        l = q
//     a +- b:            u = ua lb + la ub,           l = la lb
//     a * b:             u = ua ub,                   l = la lb
//     a / b:             u = ua lb,                   l = la ub
//     sqrt(a):           u = sqrt(ua la), l = la   if ua >= la,   else  u = ua, l = sqrt(ua la)
// If the value is not 0 then |value| >= 1 / (l u^(D-1)), where D bounds the degree: 2 for every distinct root, nested
// ones as well; plain roots sqrt(n_i) count only as far as they are independent modulo squares.
// Logarithms of u and l are kept as doubles and rounded up by far more than the error of log2.
// Internal to src/exact. Keywords: common subexpression elimination, root bound.
#pragma once

#include <cstdint>
#include <vector>

#include "exact/real_node.h"

namespace findspace::exact::detail {

/// kSmall is an inline rational, kLeaf a closed form of a node; kPlainRoot is the sqrt(n) such leaves share.
enum class StepKind : std::uint8_t { kSmall, kLeaf, kPlainRoot, kNeg, kAdd, kSub, kMul, kDiv, kSqrt };

struct Step {
  StepKind kind = StepKind::kSmall;
  int a = -1, b = -1;            // operands; of a quadratic leaf, a is the step of its sqrt(n)
  const Closed* leaf = nullptr;  // of kLeaf, and of kPlainRoot the leaf whose n it is
  Interval interval;             // the known enclosure
  Small small;                   // of kSmall
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
  /// A value below 2^-result in magnitude is 0.
  double separation_bits() const;
  /// About log2 of the absolute error of the value in units of 2^-precision, from the doubles known; infinite where
  /// they tell nothing. A heuristic for choosing a precision.
  double error_bits() const;

 private:
  int build(const Real& x);
  int step_of(const Real& x);  // -1 if x is an operation not done yet
  int leaf_step(const Real& x);
  int small_step(const Small& value);
  int plain_root_step(const Closed& leaf);
  int operation_step(const OperationNode& node, int a, int b);
  double log2_degree() const;

  std::vector<Step> steps_;
  StepTable of_node_, leaves_, operations_;
  int root_ = 0;
};

}  // namespace findspace::exact::detail
