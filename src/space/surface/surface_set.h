// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A closed bounded set as it is given: closed surfaces of triangles, each with a tree of boxes, and balls; the set is
// their union. Nothing is cut into convex parts. Guarantee: exact; none where a body has other round parts or
// coordinates are beyond what ray_sign.h takes. Cost: O(n log n). Keywords: boundary representation, bounding volume
// hierarchy.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "space/body/body.h"
#include "space/convolution/ray_solids.h"

namespace findspace::space {

class SurfaceSet {
 public:
  using Sheet = RaySheet;
  struct Ball {
    Point center;
    exact::Real radius;
  };

  SurfaceSet() = default;
  /// In grid steps, taken times `scale`; false where one is too far out.
  bool add(const std::vector<RaySolid>& solids, std::int64_t scale);
  /// The boundaries of the parts, at that scale; false where a part is round and no ball, or too far out.
  bool add(const Body& body, std::int64_t scale);

  const std::vector<std::shared_ptr<const Sheet>>& sheets() const { return sheets_; }
  const std::vector<Ball>& balls() const { return balls_; }
  bool one_sheet() const { return sheets_.size() == 1 && balls_.empty(); }
  /// One sheet, and all of it is frontier of the set.
  bool one_frontier() const { return one_sheet() && !inner_walls_; }
  /// There are surfaces, and no balls.
  bool has_hull() const { return balls_.empty() && !sheets_.empty(); }
  /// About the surfaces, where there are some.
  Bounds3 box() const;
  /// The convex hull; null where has_hull() does not hold. `scale` of the coordinates.
  std::shared_ptr<const Body> hull(std::int64_t scale) const;

 private:
  std::vector<std::shared_ptr<const Sheet>> sheets_;
  std::vector<Ball> balls_;
  bool inner_walls_ = false;
};

/// Whether any edge of a solid bends inwards, or there is more than one solid.
bool seen_not_convex(const std::vector<RaySolid>& solids);

}  // namespace findspace::space
