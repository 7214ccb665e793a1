// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/polytope/partition.h"

#include <algorithm>

namespace findspace::space {
namespace {

using exact::Real;
using FacetCorner = FacetPiece::Corner;

constexpr std::size_t kTried = 48;     // planes compared for one cut
constexpr std::size_t kSampled = 400;  // pieces that a plane is judged by

struct Sides {
  bool above = false, below = false;
};

Sides sides(const HalfSpace& plane, const FacetPiece& piece) {
  Sides s;
  for (const FacetCorner& c : piece.corners) {
    const int sign = plane.sign(c.at, c.near);
    s.above = s.above || sign > 0;
    s.below = s.below || sign < 0;
  }
  return s;
}

/// The part of the piece on the side of the given sign, by cutting its circuit (Sutherland, Hodgman).
FacetPiece cut_off(const FacetPiece& piece, const HalfSpace& plane, int side) {
  FacetPiece part{piece.plane, {}};
  for (std::size_t i = 0; i < piece.corners.size(); ++i) {
    const FacetCorner &a = piece.corners[i], &b = piece.corners[(i + 1) % piece.corners.size()];
    const int sa = plane.sign(a.at, a.near), sb = plane.sign(b.at, b.near);
    if (sa * side >= 0) part.corners.push_back(a);
    if (sa * sb >= 0) continue;
    const Real ha = plane.value(a.at), t = ha / (ha - plane.value(b.at));
    part.corners.emplace_back(along(a.at, t, minus(b.at, a.at)));
  }
  return part;
}

class Partition {
 public:
  void run(std::vector<FacetPiece> facets, ConvexRegion bounds) {
    const Plane chosen = choose(facets);
    const HalfSpace plane(chosen);
    std::vector<FacetPiece> above, below;
    bool solid_above = false;
    for (FacetPiece& piece : facets) {
      const Sides s = sides(plane, piece);
      if (s.above && s.below) {
        above.push_back(cut_off(piece, plane, 1));
        below.push_back(cut_off(piece, plane, -1));
      } else if (s.above || s.below) {
        (s.above ? above : below).push_back(std::move(piece));
      } else {
        solid_above = solid_above || piece.plane.normal == -chosen.normal;
      }
    }
    facets = {};
    ConvexRegion over = bounds;
    over.cut(plane.opposite());
    bounds.cut(plane);
    // A half without facets is all solid or all empty; the facets in the cut say which.
    if (below.empty()) {
      cells.inside.push_back(std::move(bounds));
    } else {
      run(std::move(below), std::move(bounds));
    }
    if (!above.empty()) {
      run(std::move(above), std::move(over));
    } else if (!over.empty()) {
      (solid_above ? cells.inside : cells.outside).push_back(std::move(over));
    }
  }

  Cells cells;

 private:
  static bool nothing_above(const HalfSpace& plane, const std::vector<FacetPiece>& facets) {
    return std::none_of(facets.begin(), facets.end(), [&](const FacetPiece& p) { return sides(plane, p).above; });
  }

  /// The facet plane that cuts the fewest pieces of a sample; at once one that has nothing above it.
  static Plane choose(const std::vector<FacetPiece>& facets) {
    std::vector<Plane> planes;
    for (const FacetPiece& piece : facets) planes.push_back(piece.plane);
    std::sort(planes.begin(), planes.end());
    planes.erase(std::unique(planes.begin(), planes.end()), planes.end());
    const std::size_t stride = (planes.size() + kTried - 1) / kTried, step = (facets.size() + kSampled - 1) / kSampled;
    const Plane* best = nullptr;
    long least = 0;
    for (std::size_t i = 0; i < planes.size(); i += stride) {
      const HalfSpace plane(planes[i]);
      long split = 0, above = 0, below = 0;
      for (std::size_t k = 0; k < facets.size(); k += step) {
        const Sides s = sides(plane, facets[k]);
        split += s.above && s.below;
        above += s.above;
        below += s.below;
      }
      if (above == 0 && nothing_above(plane, facets)) return planes[i];
      const long cost = 8 * split + std::abs(above - below);
      if (best == nullptr || cost < least) {
        best = &planes[i];
        least = cost;
      }
    }
    return *best;
  }
};

}  // namespace

Cells partition(std::vector<FacetPiece> facets, ConvexRegion bounds) {
  Partition p;
  p.run(std::move(facets), std::move(bounds));
  return std::move(p.cells);
}

}  // namespace findspace::space
