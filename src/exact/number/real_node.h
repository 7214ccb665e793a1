// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The nodes behind Real and the way in for the other files of src/exact. Internal: brings in GMP.
#pragma once

#include <memory>
#include <vector>

#include "exact/number/quadratic.h"
#include "exact/number/real.h"
#include "exact/number/real_small.h"

namespace findspace::exact::detail {

/// kRational and kQuadratic.
struct QuadraticNode : Node {
  QuadraticNode(NodeKind kind_of, Interval enclosure, Quadratic held, bool was_cancelled)
      : Node(kind_of, enclosure), value(std::move(held)), cancelled(was_cancelled) {}
  Quadratic value;
  bool cancelled;  // doubles alone would not have decided the sign
};

/// All other kinds; b is 0 and unused for kNeg and kSqrt. Divisors are not 0 and arguments of roots are positive,
/// which was proved when the node was made.
struct OperationNode : Node {
  OperationNode(NodeKind kind_of, Interval enclosure, Real left, Real right)
      : Node(kind_of, enclosure), a(std::move(left)), b(std::move(right)) {}
  Real a, b;
  Node* next_to_destroy = nullptr;
};

class RootBalls;

/// kPolynomialRoot: the one root of c0 + c1 x + c2 x^2 + ... in an interval; no other root of the polynomial, with all
/// its multiplicity, coincides with it. The coefficients contain no such root.
struct RootNode : Node {
  RootNode(Interval enclosure, std::vector<Real> polynomial, std::unique_ptr<RootBalls> found);
  ~RootNode();
  std::vector<Real> coefficients;
  std::unique_ptr<RootBalls> balls;
};

struct Access {
  static Node* node(const Real& x) { return x.node_; }
  static Small small(const Real& x) { return {x.numerator_, x.denominator_}; }  // where there is no node
  static Real make(const Small& x) { return Real(x.p, x.q); }
  static Real adopt(Node* node) { return Real(node); }
  static Node* take(Real& x) { return std::exchange(x.node_, nullptr); }
};

inline bool is_closed(const Node& node) { return node.kind <= NodeKind::kQuadratic; }
inline const Quadratic& closed(const Node& node) { return static_cast<const QuadraticNode&>(node).value; }
inline bool is_unary(NodeKind kind) { return kind == NodeKind::kNeg || kind == NodeKind::kSqrt; }
inline const OperationNode& operation(const Node& node) { return static_cast<const OperationNode&>(node); }

/// The simplest form of a closed value.
Real make_real(Quadratic value);

}  // namespace findspace::exact::detail
