// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/partition.h"

#include <algorithm>

namespace findspace::space {
namespace {

using exact::Real;
using Corner = std::array<Real, 3>;

constexpr std::size_t kTried = 48;  // planes compared for one cut

Plane opposite(const Plane& p) { return {-p.normal, -p.offset}; }

Real height(const Plane& plane, const Corner& c) {
  return Real(plane.normal.x) * c[0] + Real(plane.normal.y) * c[1] + Real(plane.normal.z) * c[2] + Real(plane.offset);
}

struct Sides {
  bool above = false, below = false;
};

Sides sides(const Plane& plane, const FacetPiece& piece) {
  Sides s;
  for (const Corner& c : piece.corners) {
    const int sign = height(plane, c).sign();
    s.above = s.above || sign > 0;
    s.below = s.below || sign < 0;
  }
  return s;
}

/// The part of the piece on the side of the given sign, by cutting its circuit (Sutherland, Hodgman).
FacetPiece cut_off(const FacetPiece& piece, const Plane& plane, int side) {
  FacetPiece part{piece.plane, {}};
  for (std::size_t i = 0; i < piece.corners.size(); ++i) {
    const Corner &a = piece.corners[i], &b = piece.corners[(i + 1) % piece.corners.size()];
    const Real ha = height(plane, a), hb = height(plane, b);
    if (ha.sign() * side >= 0) part.corners.push_back(a);
    if (ha.sign() * hb.sign() >= 0) continue;
    const Real t = ha / (ha - hb);
    Corner c;
    for (int k = 0; k < 3; ++k) c[k] = a[k] + t * (b[k] - a[k]);
    part.corners.push_back(std::move(c));
  }
  return part;
}

class Partition {
 public:
  void run(std::vector<FacetPiece> facets, std::vector<Plane> bounds) {
    const Plane plane = choose(facets);
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
        solid_above = solid_above || piece.plane.normal == -plane.normal;
      }
    }
    std::vector<Plane> over = bounds;
    over.push_back(opposite(plane));
    bounds.push_back(plane);
    // A half without facets is all solid or all empty; the facets in the cut say which.
    if (below.empty()) {
      cells.push_back(std::move(bounds));
    } else {
      run(std::move(below), std::move(bounds));
    }
    if (!above.empty()) {
      run(std::move(above), std::move(over));
    } else if (solid_above) {
      cells.push_back(std::move(over));
    }
  }

  std::vector<std::vector<Plane>> cells;

 private:
  /// The facet plane that cuts the fewest pieces; at once one that has nothing above it and cuts nothing.
  static Plane choose(const std::vector<FacetPiece>& facets) {
    std::vector<Plane> planes;
    for (const FacetPiece& piece : facets) planes.push_back(piece.plane);
    std::sort(planes.begin(), planes.end());
    planes.erase(std::unique(planes.begin(), planes.end()), planes.end());
    const std::size_t stride = (planes.size() + kTried - 1) / kTried;
    const Plane* best = nullptr;
    long least = 0;
    for (std::size_t i = 0; i < planes.size(); i += stride) {
      long split = 0, above = 0, below = 0;
      for (const FacetPiece& piece : facets) {
        const Sides s = sides(planes[i], piece);
        split += s.above && s.below;
        above += s.above;
        below += s.below;
      }
      if (above == 0) return planes[i];
      const long cost = 8 * split + std::abs(above - below);
      if (best == nullptr || cost < least) best = &planes[i], least = cost;
    }
    return *best;
  }
};

}  // namespace

std::vector<std::vector<Plane>> partition(std::vector<FacetPiece> facets, std::vector<Plane> bounds) {
  Partition p;
  p.run(std::move(facets), std::move(bounds));
  return std::move(p.cells);
}

}  // namespace findspace::space
