// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Boxes that hold all positions at which a body B lies in a body A, {p : B + p in A}. What is connected lies in one
// connected piece of A, so B's pieces say each for itself in which boxes the positions are; what all of them say is
// left. A piece is made of parts that meet. Guarantee: no such position is outside the boxes, which are a hair wider
// than doubles say; where there would be very many, they are larger than need be. Cost: the pairs of parts whose boxes
// meet, and the pairs of pieces. And boxes of positions at which B does not fit, as one of its corners is out of all
// parts of A: so whole boxes are told that no difference of a cell outside A and a part of B covers alone. Keywords:
// connected components, containment, bounding boxes.
#pragma once

#include <optional>
#include <vector>

#include "distance/search/convex_distance.h"
#include "space/body/body.h"
#include "space/polytope/extent.h"
#include "space/polytope/extent_tree.h"

namespace findspace::distance {

/// Neither body is `outside`. No box where B fits nowhere; nothing where A is one piece, which says no more than the
/// boxes of both bodies do, and where parts of A were rounded: those that touched may be apart (outside_cells.h).
std::optional<std::vector<space::Extent>> fitting_places(const space::Body& b, const space::Body& a);

/// Neither body is `outside`, nor has a radius.
class CornersOut {
 public:
  CornersOut(const space::Body& b, const space::Body& a);
  /// Beyond the box one of the corners is out of A's box.
  const space::Extent& around() const { return around_; }
  /// Whether at every position of the box the same corner of B is out of A. By numbers: false where these do not tell.
  bool at(const space::Extent& positions) const;

 private:
  bool out(const space::Extent& places) const;

  space::Extent around_;
  std::vector<space::Vector> corners_;  // of B, those that are farthest in some direction
  space::ExtentTree parts_;             // of A
  std::vector<std::vector<NearPlane>> planes_;
};

}  // namespace findspace::distance
