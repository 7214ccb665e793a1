// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The positions of a moving shape B against a fixed shape A, both with axis-parallel faces, as exact sets
// (distances.md 1.3, 1.4):
//   X = A (+) -B,  U = (int A (+) -B) u (A (+) -int B),  E = (A^c (+) -B)^c,  int E = (cl(A^c) (+) -B)^c,
//   D, int D: the same with the roles exchanged, reflected.
// With them the sign map at level 0 of every distance, and the values of gamma1, eta1, delta1, gamma2, eta2, delta2 at
// a position: the shapes may have sheets, lines and points, and may be unbounded. Guarantee: exact; what needs a grid
// of more than BoxComplex::kMostCells cells is refused. Other levels have round boundaries; where the '-' set is made
// of separate boxes, levels below 0 have not and are exact too. Cost: pairs of boxes, painted on one grid. Keywords:
// configuration space, slots, exact fit.
#pragma once

#include <memory>
#include <optional>

#include "distance/solid/pair_distances.h"
#include "plane/base/lazy.h"
#include "space/box/box_complex.h"

namespace findspace::distance {

class BoxMaps {
 public:
  /// Closed sets; B bounded.
  BoxMaps(space::BoxComplex b, space::BoxComplex a);

  /// The sign of distance - level at every position; refused where that has no axis-parallel form.
  exact::Tried<space::BoxComplex> sign_map(Which which, const exact::Real& level) const;
  /// The same of one of the six distances along an axis, both ways (`way` 0) or up or down it (1, -1), at any level.
  exact::Tried<space::BoxComplex> directional_map(Which which, const exact::Real& level, int axis, int way) const;
  /// A provider of pair_distances.h, which keeps a reference.
  PairDistances distances() const;
  /// What it does not answer.
  static bool protrudes(Which which) {
    return which == Which::kMu || which == Which::kMuBack || which == Which::kH || which == Which::kHBack ||
           which == Which::kHausdorff;
  }
  /// What bodies tell faster.
  static bool is_reach(Which which) { return which == Which::kGamma2 || which == Which::kDiameter; }

  /// The least value of gamma1, eta1 or delta1 and where it is taken, if the '-' set is made of separate boxes or
  /// empty.
  struct Least {
    exact::Real value;
    space::BoxComplex at;  // empty if the distance is undefined
  };
  exact::Tried<std::optional<Least>> least(Which which) const;
  /// The same of one of the six distances along an axis; an infimum that no position takes has an empty `at`. Nothing
  /// where the distance is undefined, or -infinity somewhere.
  exact::Tried<std::optional<Least>> directional_least(Which which, int axis, int way) const;

 private:
  class Side;
  struct Signs {  // of gamma1, eta1 or delta1 at level 0
    space::BoxComplex map;
    std::vector<space::IntervalBox> closed, rest;  // where it is <= 0, and where it is >= 0
    std::vector<space::IntervalBox> negative;      // the '-' set, if it is made of separate open boxes
    bool defined = true, has_negative = false;
  };
  const exact::Tried<Signs>& signs(Which base) const;
  exact::Tried<Signs> made(Which base) const;
  exact::Tried<space::BoxComplex> base_map(Which base, const exact::Real& level) const;
  static std::optional<Answer> signed_value(const Signs& s, const space::RealVector& p);
  static std::optional<Answer> farthest_value(const Signs& s, const space::RealVector& p);
  TriedAnswer signed_value(Which base, const space::RealVector& p) const;
  TriedAnswer farthest_value(Which base, const space::RealVector& p) const;
  TriedAnswer diameter(const space::RealVector& p) const;
  static std::optional<Least> least(const Signs& s);

  space::BoxComplex b_, a_;
  std::array<plane::Lazy<exact::Tried<Signs>>, 3> signs_;
};

}  // namespace findspace::distance
