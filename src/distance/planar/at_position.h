// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Every distance of a pair of shapes at one position p, with its witness: the two points, one of B + p and one of A,
// that attain it, and the vertices, edges or arcs they lie on. For the distances that are translations to a contact
// (gamma1 < 0, eta, delta) the pair are the points that come together: B + p moved by (point of A) - (point of B)
// touches A there, and the move is as long as the value. Values come from the boundaries alone where these decide:
// shapes that are clearly apart or clearly inside each other, gamma2, mu, h, Hausdorff and diameter; gamma1 < 0, eta1 >
// 0 and delta1 > 0 from the boundary of the sum near p (penetration_depth.h) where its map is large; else from the
// map of the family (t_distance.h), which is made once. Guarantee: as the families'. Cost: about log n boxes for
// boundaries, a map where these meet; of d1 where a vertex is found inside the other shape, not even trees are made.
// Prepared once, asked at many positions; threads: safe. Keywords: witness, closest
// features, contact, clearance, measure.
#pragma once

#include <memory>

#include "distance/planar/contact_values.h"
#include "distance/planar/directed_values.h"
#include "distance/planar/pair_boundaries.h"
#include "distance/planar/shape_pair.h"

namespace findspace::distance {

class AtPosition {
 public:
  explicit AtPosition(std::shared_ptr<const ShapePair> pair);
  AtPosition(const AtPosition&) = delete;
  AtPosition& operator=(const AtPosition&) = delete;

  const ShapePair& pair() const { return *pair_; }
  /// The size of the numbers of a search at p.
  double scale(const exact::RealPoint& p) const;
  /// f(p), its witness with B's feature first (of a diameter within one shape both of that); nothing if undefined.
  std::optional<PlanarAnswer> measure(Which which, const exact::RealPoint& p) const;

 private:
  /// An answer, where it was asked for.
  struct Known {
    Which which;
    exact::RealPoint at;
    std::optional<PlanarAnswer> answer;
  };
  std::optional<PlanarAnswer> measured_there(Which which, const exact::RealPoint& p) const;
  std::optional<PlanarAnswer> measured(Which which, const exact::RealPoint& p) const;
  std::optional<PlanarAnswer> plain(const exact::RealPoint& p) const;

  std::shared_ptr<const ShapePair> pair_, searched_;  // as given; near the origin: the others speak of that
  PairBoundaries boundaries_;
  ContactValues contacts_;
  DirectedValues directed_;
  mutable std::mutex guard_;
  mutable std::optional<Known> last_;  // a check, and the search for what is nearest, ask about the same place
};

}  // namespace findspace::distance
