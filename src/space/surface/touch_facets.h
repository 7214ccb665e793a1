// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The facets of the convolution of two solids that may hold positions of touching (ray_convolution.h), and what cuts
// one of them into cells: the planes of the facets that cross or touch it, and the edges of those in its plane. All
// positions of an open cell touch, or overlap, alike, as the frontier of the overlaps lies on these facets. Guarantee:
// exact; no cut is missing, and some may do nothing. Cost: the facets whose boxes meet. Keywords: reduced convolution,
// arrangement.
#pragma once

#include <array>
#include <deque>
#include <span>
#include <vector>

#include "space/convolution/ray_convolution.h"
#include "space/polytope/extent_tree.h"
#include "space/polytope/flat_piece.h"

namespace findspace::space {

/// A plane, and the part of it that is on another facet or an edge of one.
struct FacetCut {
  const HalfSpace* plane;
  std::array<Vector, 4> corner;
  int corners;

  /// False where the part is surely apart from the piece.
  bool meets(const FlatPiece& piece) const;

 private:
  std::span<const Vector> all() const { return {corner.data(), static_cast<std::size_t>(corners)}; }
};

class TouchFacets {
 public:
  /// What pieces and cuts point to beside the planes of the facets.
  using Planes = std::deque<HalfSpace>;

  explicit TouchFacets(const std::vector<RayFacet>& all);

  std::size_t count() const { return facets_.size(); }
  const Extent& box(std::size_t k) const { return tree_.extent(k); }
  /// The facets whose boxes meet its own.
  std::size_t meeting(std::size_t k) const;
  FlatPiece piece(std::size_t k, Planes& made) const;
  std::vector<FacetCut> cuts(std::size_t k, Planes& made) const;

 private:
  FacetCut cut_of(std::size_t k) const;
  void add_cuts(std::size_t k, std::size_t other, Planes& made, std::vector<FacetCut>& out) const;

  std::vector<RayFacet> facets_;
  std::vector<HalfSpace> planes_;
  ExtentTree tree_;
};

}  // namespace findspace::space
