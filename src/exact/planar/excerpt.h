// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A few curves and points of a geometry, copied with what defines them, and new points beside them: what predicates
// need that compare cells of a large geometry, which stays as it is, with a point that is not in it. Guarantee: a copy
// is the same point or curve. Cost: a copy once for each curve and point asked for, found again by a look through those
// there are; memory for these alone. Keywords: sub-geometry, scratch.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "exact/planar/geometry.h"

namespace findspace::exact {

class Excerpt {
 public:
  /// Keeps a reference to the whole.
  explicit Excerpt(const Geometry& whole) : whole_(whole) {}

  /// The copy of a curve or a point of the whole.
  std::uint32_t curve(std::uint32_t of_whole);
  std::uint32_t point(std::uint32_t of_whole);
  std::uint32_t add_real_point(const RealPoint& p) { return copies_.add_real_point(p.x, p.y); }

  const Geometry& geometry() const { return copies_; }
  std::size_t size() const { return curves_.size() + points_.size(); }
  /// Forgets all there is, so that what is looked for among it stays little.
  void clear();

 private:
  using Copies = std::vector<std::pair<std::uint32_t, std::uint32_t>>;  // of the whole, its copy

  const Geometry& whole_;
  Geometry copies_;
  Copies curves_, points_;
};

}  // namespace findspace::exact
