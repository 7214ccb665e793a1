// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The Phi-function of two finite unions of convex polytopes, A = union A_i and B = union B_j: the minimum of the pairs'
// Phi-functions. Its sign is right in all three states, seams included (phi.md 10, theorem); parts may share faces or
// overlap. Guarantee: exact sign. The normalised form is the exact distance outside. Inside, minus the value is the
// greatest depth of a pair: zero only in contact, a lower bound of the true depth, and it depends on the cut into
// parts. Cost: pairs times the cost of a pair; pairs that bounding boxes show to be farther than the best so far are
// skipped. Keywords: non-convex, phi-function of composed objects.
#pragma once

#include <span>
#include <vector>

#include "space/phi/phi_exact.h"

namespace findspace::space {

class PhiUnion {
 public:
  PhiUnion(std::span<const Polytope> a, std::span<const Polytope> b);

  int pair_count() const { return static_cast<int>(pairs_.size()); }
  /// Pair i * (number of parts of B) + j belongs to A_i and B_j.
  const PhiFunction& pair(int k) const { return pairs_[k].phi; }

  double max_form(const Vector& u) const;
  double normalised(const Vector& u) const;
  int sign(const Vector& u) const;
  /// The unit normal of the highest facet of the lowest pair.
  Vector gradient(const Vector& u) const;
  void evaluate(std::span<const Vector> at, std::span<double> values) const;

  /// Exact at real positions. `pair` is the one whose max form is least, whose facets `at.active` counts.
  struct At {
    PhiAt at;
    int pair = 0;
  };
  At at(const RealVector& u) const;
  int sign_at(const RealVector& u) const;
  exact::Real squared_distance(const RealVector& u) const;

 private:
  struct Pair {
    PhiFunction phi;
    Vector low, high;  // bounding box of A_i - B_j
    /// The normalised form is at least this at u, for the box holds A_i - B_j; and so its sign, exactly.
    double at_least(const Vector& u) const;
  };
  std::vector<Pair> pairs_;
};

}  // namespace findspace::space
