// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The binary space partition behind convex_parts.h: the cells inside and outside a surface as convex regions.
// Guarantee: exact; the interiors of the cells do not meet and their union is `bounds`. Cost: a cut looks at all pieces
// once, and at a sample of them for each of the planes it chooses from.
#pragma once

#include <optional>
#include <vector>

#include "space/polytope/convex_region.h"

namespace findspace::space {

/// A piece of a facet: its plane (outward) and its corners. Pieces may have bridges of no width along a cut.
struct FacetPiece {
  struct Corner {
    RealVector at;
    Vector near;  // rounded
    explicit Corner(RealVector place) : at(std::move(place)), near(rounded(at)) {}
  };
  Plane plane;
  std::vector<Corner> corners;
};

struct Cells {
  std::vector<ConvexRegion> inside, outside;
};

/// The cells of the surface `facets`, which is closed within `bounds`. Cells without interior may be among them where
/// the surface crosses itself. Nothing where that takes more than `most` looks at pieces, each a few signs.
std::optional<Cells> partition(std::vector<FacetPiece> facets, ConvexRegion bounds, long most);

}  // namespace findspace::space
