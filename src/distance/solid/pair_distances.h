// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// All T-distances of a moving solid B and a fixed solid A at a position p (distances.md 3.1 to 3.4), whatever holds the
// two: six questions, which a provider answers of the sets of positions it knows, and the one table that says how every
// distance follows from them. Providers are box_pair.h, solid_pair.h, surface_pair.h and csg_pair.h.
//   gap        gamma1;  d1, penetration from it
//   reach      gamma2;  diameter
//   fit        eta1, delta1;  dstar from it
//   farthest   eta2, delta2
//   protrusion mu;  h, hausdorff from it
// Guarantee: that of the provider. What it does not answer is refused, so that the next one can be asked. Keywords:
// signed distance, Hausdorff distance.
#pragma once

#include <optional>

#include "distance/answer/answer.h"
#include "distance/planar/shape_pair.h"

namespace findspace::distance {

/// The same distance with the roles of the two exchanged.
Which exchanged(Which which);

/// A distance that is max(0, base), or max(0, -base) if negated.
struct CutOff {
  Which base;
  bool negated;
};
std::optional<CutOff> cut_off_of(Which which);

class PairDistances {
 public:
  virtual ~PairDistances() = default;
  TriedAnswer try_value(Which which, const SpacePosition& p) const;
  /// The same; Error(kUnsupported) instead of a refusal.
  std::optional<Answer> value(Which which, const SpacePosition& p) const { return try_value(which, p).or_throw(); }

 protected:
  /// Which one is to lie in the other.
  enum class Inner { kB, kA };
  /// Where a value below 0 need only be known to be so, it may be any up to 0.
  enum class Depth { kValue, kSign };

  virtual TriedAnswer gap(const SpacePosition& p, Depth depth) const = 0;
  virtual TriedAnswer reach(const SpacePosition& p) const = 0;
  virtual TriedAnswer diameter(const SpacePosition& p) const = 0;
  virtual TriedAnswer fit(Inner inner, const SpacePosition& p) const = 0;
  virtual TriedAnswer farthest_fit(Inner inner, const SpacePosition& p) const = 0;
  virtual TriedAnswer protrusion(Inner inner, const SpacePosition& p, Depth depth) const = 0;
  /// max(0, -fit), also where the fit itself is not decided.
  virtual TriedAnswer clearance(Inner inner, const SpacePosition& p) const;
  virtual TriedAnswer hausdorff(const SpacePosition& p) const;

  /// What was said of A moved by -p against B, said of B moved by p.
  static TriedAnswer exchanged_back(TriedAnswer v, const SpacePosition& p);
};

}  // namespace findspace::distance
