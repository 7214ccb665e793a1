// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// All T-distances of a moving solid B and a fixed solid A at a position p (distances.md 3.1 to 3.4), whatever holds the
// two. A provider answers questions of a solid that moves and one that is fixed; one of B in A and one of A in B make a
// pair, and one table says how every distance follows from them.
//   gap        gamma1;  d1, penetration from it
//   reach      gamma2;  diameter
//   fit        eta1, and of A in B delta1;  dstar from it
//   farthest   eta2, delta2
//   protrusion mu;  h, hausdorff from it
// Providers are solid_pair.h (and complements), surface_pair.h, csg_pair.h and box_maps.h. Guarantee: that of the
// provider. What it does not answer is refused, so that the next one can be asked. Searches that ask at thousands of
// positions first ask `within`, in doubles. Keywords: signed distance, Hausdorff distance.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "distance/answer/answer.h"
#include "distance/planar/shape_pair.h"
#include "exact/number/interval.h"
#include "space/polytope/vector.h"

namespace findspace::distance {

/// The same distance with the roles of the two exchanged.
Which exchanged(Which which);

/// A distance that is max(0, base), or max(0, -base) if negated.
struct CutOff {
  Which base;
  bool negated;
};
std::optional<CutOff> cut_off_of(Which which);

/// What a solid that moves tells against one that is fixed, at a position of it. A provider says what it knows or
/// refuses; this one is of solids for which no distance is defined.
class PairSide {
 public:
  /// Where a value below 0 need only be known to be so, it may be any up to 0.
  enum class Depth { kValue, kSign };

  virtual ~PairSide() = default;
  virtual TriedAnswer gap(const SpacePosition& /*p*/, Depth /*depth*/) const { return std::nullopt; }
  virtual TriedAnswer reach(const SpacePosition& /*p*/) const { return std::nullopt; }
  virtual TriedAnswer diameter(const SpacePosition& /*p*/) const { return std::nullopt; }
  virtual TriedAnswer fit(const SpacePosition& /*p*/) const { return std::nullopt; }
  virtual TriedAnswer farthest_fit(const SpacePosition& /*p*/) const { return std::nullopt; }
  virtual TriedAnswer protrusion(const SpacePosition& /*p*/, Depth /*depth*/) const { return std::nullopt; }
  /// max(0, -fit), also where the fit itself is not decided.
  virtual TriedAnswer clearance(const SpacePosition& p) const;
  /// Numbers between which the value lies (+infinity where it is undefined), as far as they are quickly known.
  virtual exact::Interval gap_within(const space::Vector& /*p*/) const { return exact::whole_line(); }
  virtual exact::Interval reach_within(const space::Vector& /*p*/) const { return exact::whole_line(); }
  virtual exact::Interval fit_within(const space::Vector& /*p*/) const { return exact::whole_line(); }
  virtual exact::Interval protrusion_within(const space::Vector& /*p*/) const { return exact::whole_line(); }
  /// No point of the moving one is farther from the fixed one; a number that is quickly known.
  virtual double protrudes_at_most(const SpacePosition& /*p*/) const { return exact::kInfinity; }
};

class PairDistances {
 public:
  using SidePointer = std::shared_ptr<const PairSide>;
  /// Of B in A, and of A in B: gap, reach and diameter are asked of the first.
  PairDistances(SidePointer forth, SidePointer back) : forth_(std::move(forth)), back_(std::move(back)) {}

  TriedAnswer try_value(Which which, const SpacePosition& p) const;
  /// The same; Error(kUnsupported) instead of a refusal.
  std::optional<Answer> value(Which which, const SpacePosition& p) const { return try_value(which, p).or_throw(); }
  /// Numbers between which the value lies, quickly: the whole line where nothing is known so.
  exact::Interval within(Which which, const space::Vector& p) const;

 private:
  TriedAnswer hausdorff(const SpacePosition& p) const;

  SidePointer forth_, back_;
};

/// Of what answers by values alone, of B moved by p in A.
PairDistances pair_by_values(std::function<TriedAnswer(Which, const SpacePosition&)> value);
/// Of A that moves in B, from that of B that moves in A.
PairDistances exchanged(PairDistances pair);

/// The greater of two values, by itself where the other one is surely less.
Answer greatest(Answer a, Answer b);

/// What was said of A moved by -p against B, said of B moved by p.
TriedAnswer exchanged_back(TriedAnswer v, const SpacePosition& p);

}  // namespace findspace::distance
