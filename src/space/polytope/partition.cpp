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
constexpr long kLooksOfCut = 8;        // for each piece

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

/// A cut leaves bridges of no width along itself; a later cut may part one from what it joins.
bool has_area(const FacetPiece& piece) {
  RealVector area;
  for (std::size_t i = 2; i < piece.corners.size(); ++i) {
    const RealVector &o = piece.corners[0].at, &a = piece.corners[i - 1].at, &b = piece.corners[i].at;
    area = plus(area, cross(minus(a, o), minus(b, o)));
  }
  return dot(area, real(piece.plane.normal)).sign() != 0;
}

class Partition {
 public:
  /// A half without facets is all solid or all empty; the facets in the cut say which. Calls itself for the lower half
  /// alone, where both halves have facets: else a round surface would take a level for each of its planes.
  void run(std::vector<FacetPiece> facets, ConvexRegion bounds) {
    std::vector<Half> bare;  // upper halves without facets; they come after all that is below them
    while (!facets.empty() && !spent()) {
      const Plane chosen = choose(facets);
      Cut cut = cut_by(chosen, std::move(facets));
      ConvexRegion over = bounds;
      over.cut(cut.plane.opposite());
      bounds.cut(cut.plane);
      if (cut.below.empty()) cells.inside.push_back(bounds);
      if (cut.above.empty()) {
        bare.push_back({std::move(over), cut.solid_above});
        facets = std::move(cut.below);
        continue;
      }
      if (!cut.below.empty()) run(std::move(cut.below), std::move(bounds));
      facets = std::move(cut.above);
      bounds = std::move(over);
    }
    for (auto half = bare.rbegin(); half != bare.rend(); ++half) {
      if (!half->region.empty()) (half->solid ? cells.inside : cells.outside).push_back(std::move(half->region));
    }
  }

  Cells cells;

  explicit Partition(long most) : left_(most) {}
  bool spent() const { return left_ < 0; }

 private:
  struct Half {
    ConvexRegion region;
    bool solid = false;
  };
  struct Cut {
    HalfSpace plane;
    std::vector<FacetPiece> above{}, below{};
    bool solid_above = false;  // as facets in the plane say
  };

  Cut cut_by(const Plane& chosen, std::vector<FacetPiece> facets) {
    left_ -= kLooksOfCut * static_cast<long>(facets.size());
    Cut out{HalfSpace(chosen)};
    for (FacetPiece& piece : facets) {
      const Sides s = sides(out.plane, piece);
      if (s.above && s.below) {
        for (const int side : {1, -1}) {
          FacetPiece part = cut_off(piece, out.plane, side);
          if (has_area(part)) (side > 0 ? out.above : out.below).push_back(std::move(part));
        }
      } else if (s.above || s.below) {
        (s.above ? out.above : out.below).push_back(std::move(piece));
      } else {
        out.solid_above = out.solid_above || piece.plane.normal == -chosen.normal;
      }
    }
    return out;
  }

  static bool nothing_above(const HalfSpace& plane, const std::vector<FacetPiece>& facets) {
    return std::none_of(facets.begin(), facets.end(), [&](const FacetPiece& p) { return sides(plane, p).above; });
  }

  /// The facet plane that cuts the fewest pieces of a sample; at once one that has nothing above it.
  Plane choose(const std::vector<FacetPiece>& facets) {
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
      left_ -= static_cast<long>(facets.size() / step);
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

  long left_;  // looks at pieces
};

}  // namespace

std::optional<Cells> partition(std::vector<FacetPiece> facets, ConvexRegion bounds, long most) {
  Partition p(most);
  p.run(std::move(facets), std::move(bounds));
  if (p.spent()) return std::nullopt;
  return std::move(p.cells);
}

}  // namespace findspace::space
