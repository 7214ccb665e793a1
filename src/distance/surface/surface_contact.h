// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The position q at which two solids given by their surfaces do not overlap and that is nearest to p: C = {q : the
// interiors of A and B + q do not meet}, or, with the complement of A for A, C = {q : B + q lies in A}; of the latter
// also the farthest. Neither is cut into convex parts. Boxes of positions are divided, nearest first. A box is passed
// over where a place of the one solid lies deeper in the other than the box is wide; where few planes of contact pass
// it (contact_planes.h), the projections of p on these, on their lines and points are tested exactly, nearest first
// (real_overlap.h): C is closed and bounded by these planes, so its nearest place is such a projection. Guarantee:
// exact; single positions and slits of no width are found; of equally near places the lexicographically least. Where
// very many planes pass near one place, and not through it, the answer may only be bounded: `error` is then more than
// 0. Cost: some hundred boxes of some ten microseconds to a millisecond; later searches know these. Threads: safe, each
// search with boxes of its own. Source: docs/decisions/0019. Keywords: penetration depth of non-convex meshes,
// containment distance, branch and bound.
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "space/surface/real_overlap.h"
#include "space/surface/surface_set.h"

namespace findspace::distance {

class ContactBoxes;

struct SurfaceContact {
  bool decided = false;
  std::optional<space::RealVector> place;  // nothing: C is empty
  double error = 0;                        // nothing is nearer (farther) by more
};

class SurfaceContacts {
 public:
  /// Of one sheet each. Outside: the interiors do not meet. Inside: B + q lies in A. Keeps references.
  SurfaceContacts(const space::SurfaceSet& b, const space::SurfaceSet& a, space::TouchSide side);
  ~SurfaceContacts();

  /// p is not in C.
  SurfaceContact nearest(const space::RealVector& p) const;
  /// Of C where B lies in A.
  SurfaceContact farthest(const space::RealVector& p) const;

 private:
  SurfaceContact search(const space::RealVector& p, bool farthest) const;

  const space::SurfaceSet& b_;
  const space::SurfaceSet& a_;
  space::TouchSide side_;
  mutable std::mutex guard_;
  mutable std::vector<std::unique_ptr<ContactBoxes>> free_;
};

}  // namespace findspace::distance
