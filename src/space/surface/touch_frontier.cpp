// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/surface/touch_frontier.h"

#include <algorithm>
#include <cmath>

#include "plane/base/parallel.h"

namespace findspace::space {
namespace {

using exact::Real;
using Corner = FlatPiece::Corner;

/// The units of parallel work: fixed, so that the order of pieces does not depend on the number of threads.
constexpr std::size_t kFacetsAtOnce = 64;

bool same(const Corner& a, const Corner& b) {
  const double apart = size_of(a.near - b.near);
  return apart <= margin::kRoundings8 * (size_of(a.near) + 1) && a.at == b.at;
}

bool has(const FlatPiece& piece, const Corner& c) {
  return std::any_of(piece.corners.begin(), piece.corners.end(), [&](const Corner& other) { return same(c, other); });
}

Vector middle(const FlatPiece& piece) {
  Vector sum{};
  for (const Corner& c : piece.corners) sum = plus(sum, c.near);
  return scaled(1 / static_cast<double>(piece.corners.size()), sum);
}

RealVector exact_middle(const FlatPiece& piece) {
  RealVector sum{};
  for (const Corner& c : piece.corners) sum = plus(sum, c.at);
  return scaled(Real::ratio(1, static_cast<std::int64_t>(piece.corners.size())), sum);
}

/// The place of the plane beside x along an axis that crosses it best.
RealVector on_plane(const HalfSpace& plane, const Vector& x) {
  const Vector size{std::fabs(plane.unit.x), std::fabs(plane.unit.y), std::fabs(plane.unit.z)};
  const std::size_t axis = size.z >= size.x && size.z >= size.y ? 2 : size.y >= size.x ? 1 : 0;
  RealVector out = real(x);
  out[axis] = Real();
  out[axis] = -plane.value(out) / plane.normal[axis];
  return out;
}

/// Whether the place of its plane lies within the edges of a polygon.
bool inside(const FlatPiece& polygon, const RealVector& p) {
  const Vector near = rounded(p);
  return std::all_of(polygon.corners.begin(), polygon.corners.end(), [&](const Corner& c) {
    int sign = 0;
    for (std::size_t k = 0; sign == 0; ++k) sign = c.side->sign(polygon.corners[k].at, polygon.corners[k].near);
    return c.side->sign(p, near) == sign;
  });
}

/// A place in the inside of a polygon, of few digits.
RealVector inner_place(const FlatPiece& polygon) {
  const Vector m = middle(polygon);
  for (const Vector& x : {Vector{std::round(m.x), std::round(m.y), std::round(m.z)}, m}) {
    RealVector p = on_plane(*polygon.plane, x);
    if (inside(polygon, p)) return p;
  }
  return exact_middle(polygon);
}

/// The touching positions on some facets.
class Finder {
 public:
  Finder(const RealOverlap& overlap, const TouchFacets& facets, const BoxQuery& wanted)
      : overlap_(overlap), facets_(facets), wanted_(wanted) {}

  std::vector<FlatPiece> pieces;
  TouchFacets::Planes planes;

  void add(std::size_t facet) {
    FlatPiece whole = facets_.piece(facet, planes);
    if (covered(whole.corners)) return;
    first_ = pieces.size();
    overlapping_.clear();
    const std::vector<FacetCut> cuts = facets_.cuts(facet, planes);
    add_cells(std::move(whole), cuts);
    last_ = pieces.size();
    for (const FlatPiece& piece : overlapping_) add_rim(piece);
  }

 private:
  /// Adds the cells of the part that touch. Whether all of it does; then it is one piece.
  bool add_cells(FlatPiece part, std::span<const FacetCut> cuts) {
    if (!wanted(part)) return false;
    const auto halves = first_split(part, cuts);
    if (!halves) return add_cell(std::move(part));
    const std::size_t before = pieces.size();
    const bool below = add_cells((*halves)[0], cuts), above = add_cells((*halves)[1], cuts);
    // What was not wanted is asked only where a piece may grow by it.
    if (!(below || (above && !wanted((*halves)[0]) && touches((*halves)[0], cuts))) ||
        !(above || (!wanted((*halves)[1]) && touches((*halves)[1], cuts))))
      return false;
    pieces.resize(before);
    pieces.push_back(std::move(part));
    return true;
  }

  /// Whether all of it touches.
  bool touches(const FlatPiece& part, std::span<const FacetCut> cuts) {
    if (covered(part.corners)) return false;
    const auto halves = first_split(part, cuts);
    if (!halves) return !overlap_.interiors_meet(inner_place(part), recent_);
    return touches((*halves)[0], cuts) && touches((*halves)[1], cuts);
  }

  /// By the first of the cuts that splits it; those left are the ones after it.
  static std::optional<std::array<FlatPiece, 2>> first_split(const FlatPiece& part, std::span<const FacetCut>& cuts) {
    while (!cuts.empty()) {
      const FacetCut& cut = cuts.front();
      cuts = cuts.subspan(1);
      if (!cut.meets(part)) continue;
      if (auto halves = split(part, *cut.plane)) return halves;
    }
    return std::nullopt;
  }

  bool add_cell(FlatPiece piece) {
    if (covered(piece.corners)) return false;
    if (!overlap_.interiors_meet(inner_place(piece), recent_)) {
      pieces.push_back(std::move(piece));
      return true;
    }
    if (!covered(piece.corners)) overlapping_.push_back(std::move(piece));
    return false;
  }

  /// The touching positions on the edges of a cell in which the interiors meet, but those of cells of its facet.
  void add_rim(const FlatPiece& cell) {
    for (std::size_t k = 0; k < cell.corners.size(); ++k) {
      const Corner &a = cell.corners[k], &b = cell.corners[(k + 1) % cell.corners.size()];
      if (!known(a, a) && !covered(std::array{a}) && !overlap_.interiors_meet(a.at, recent_))
        pieces.push_back({cell.plane, {a}});
      if (known(a, b) || covered(std::array{a, b})) continue;
      FlatPiece edge{cell.plane, {a, b}};
      if (!overlap_.interiors_meet(exact_middle(edge), recent_)) pieces.push_back(std::move(edge));
    }
  }

  /// Whether both are corners of a cell that touches.
  bool known(const Corner& a, const Corner& b) const {
    return std::any_of(pieces.begin() + static_cast<std::ptrdiff_t>(first_),
                       pieces.begin() + static_cast<std::ptrdiff_t>(last_),
                       [&](const FlatPiece& piece) { return has(piece, a) && has(piece, b); });
  }

  /// Whether a pair of triangles that crossed lately does in all of the convex hull.
  bool covered(std::span<const Corner> corners) const {
    std::vector<Vector> hull;
    double size = 0;
    for (const Corner& c : corners) {
      hull.push_back(c.near);
      size = std::max(size, size_of(c.near));
    }
    return overlap_.surely_meet(hull, margin::kRoundings8 * size, recent_);
  }

  const RealOverlap& overlap_;
  bool wanted(const FlatPiece& piece) const {
    std::vector<Vector> corners;
    for (const Corner& c : piece.corners) corners.push_back(c.near);
    const Extent box = extent_of(corners);
    return wanted_(box.low, box.high);
  }

  const TouchFacets& facets_;
  const BoxQuery& wanted_;
  RealOverlap::Recent recent_;
  std::vector<FlatPiece> overlapping_;  // cells of the facet at hand
  std::size_t first_ = 0, last_ = 0;    // and the pieces that are such
};

bool more_meet(const TouchFacets& facets, const BoxQuery& wanted, std::size_t most_pairs) {
  std::size_t pairs = 0;
  for (std::size_t k = 0; k < facets.count() && pairs <= most_pairs; ++k) {
    if (wanted(facets.box(k).low, facets.box(k).high)) pairs += facets.meeting(k);
  }
  return pairs > most_pairs;
}

}  // namespace

std::optional<TouchFrontier> touch_frontier(const RaySheet& a, const RaySheet& b, TouchSide side,
                                            const BoxQuery& wanted, std::size_t most_pairs) {
  const RealOverlap overlap(a, b, side == TouchSide::kInside);
  const RayBody reflected(scaled(Triangles{b.body.points, b.body.faces}, -1));
  TouchFrontier out{{}, std::make_shared<const TouchFacets>(convolution(overlap.a(), reflected)), {}};
  const TouchFacets& facets = *out.facets;
  if (more_meet(facets, wanted, most_pairs)) return std::nullopt;
  const std::size_t blocks = (facets.count() + kFacetsAtOnce - 1) / kFacetsAtOnce;
  std::vector<std::vector<FlatPiece>> found(blocks);
  out.planes.resize(blocks);
  plane::parallel_for(blocks, [&](std::size_t block) {
    Finder finder(overlap, facets, wanted);
    for (std::size_t k = block * kFacetsAtOnce; k < std::min(facets.count(), (block + 1) * kFacetsAtOnce); ++k) {
      if (wanted(facets.box(k).low, facets.box(k).high)) finder.add(k);
    }
    found[block] = std::move(finder.pieces);
    out.planes[block] = std::move(finder.planes);
  });
  for (auto& part : found) std::move(part.begin(), part.end(), std::back_inserter(out.pieces));
  return out;
}

}  // namespace findspace::space
