// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The directed distances of a pair at a position: mu(B + p, A), mu(A, B + p) and the greater of both, the Hausdorff
// distance. Outside from the place farthest from the other shape, inside from the nearest boundaries or the distance to
// a contact. Guarantee: as the families'. Threads: safe. Keywords: directed Hausdorff distance, protrusion.
#pragma once

#include <memory>
#include <mutex>

#include "distance/planar/contact_values.h"
#include "distance/planar/farthest_from_set.h"

namespace findspace::distance {

class DirectedValues {
 public:
  /// Both have to outlive it.
  DirectedValues(const PairBoundaries& boundaries, const ContactValues& contacts)
      : boundaries_(boundaries), contacts_(contacts) {}

  /// mu(B + p, A), or mu(A, B + p) if `back`. A value of `floor` or less may come out as 0.
  std::optional<PlanarAnswer> directed(bool back, const exact::RealPoint& p, double floor = 0) const;
  /// The greater of the two directed ones, the one that promises more first; of the other only what could be greater is
  /// looked for.
  std::optional<PlanarAnswer> hausdorff(const exact::RealPoint& p) const;

 private:
  /// Of a pair with arcs: the place of B + p farthest from A, or of A from B + p if `back`.
  const FarthestFromSet& farthest_search(bool back) const;
  std::optional<FarthestPlace> place(bool back, const exact::RealPoint& by, double least) const;
  /// How far B + p (or A, if `back`) protrudes from the other along the line through the middles of their boxes.
  double protrudes(bool back, double px, double py) const;

  const PairBoundaries& boundaries_;
  const ContactValues& contacts_;
  mutable std::array<std::once_flag, 2> searches_made_;
  mutable std::array<std::unique_ptr<const FarthestFromSet>, 2> searches_;
};

}  // namespace findspace::distance
