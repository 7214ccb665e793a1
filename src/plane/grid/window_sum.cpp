// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/grid/window_sum.h"

#include <array>
#include <cmath>
#include <optional>

#include "exact/planar/geometry_signs.h"
#include "plane/grid/merged_curves.h"

namespace findspace::plane {
namespace {

using Curve = ConvolutionIndex::Curve;
using exact::Geometry;
using exact::int128;
using exact::SupportingCurve;

constexpr std::size_t kCurvesToMerge = 400;  // of fewer it does not pay

Range range(const GridBox& w) { return {double(w.x0), double(w.y0), double(w.x1), double(w.y1)}; }

/// The line of the curve passes the window on one side; certain where true.
bool misses(const ConvolutionIndex& index, const Curve& c, const GridBox& w) {
  const GridCorner& e = index.edge(c);
  const GridPoint p = index.from(c);
  double nx = -double(e.dy), ny = double(e.dx);
  double mx = (double(w.x0) + double(w.x1)) / 2 - double(p.x), my = (double(w.y0) + double(w.y1)) / 2 - double(p.y);
  double reach = std::abs(nx) * double(w.x1 - w.x0) + std::abs(ny) * double(w.y1 - w.y0);
  double tolerance = (std::abs(nx * mx) + std::abs(ny * my) + reach) * exact::Approx::kUnit * 16;
  return std::abs(nx * mx + ny * my) > reach / 2 + tolerance;
}

/// A curve as it is, its ends in order.
struct WholeCurve {
  Piece piece;
  GridPoint from, to;
  InnerSide side;
};

WholeCurve whole_curve(Geometry& g, const ConvolutionIndex& index, const Curve& c) {
  const GridCorner& e = index.edge(c);
  GridPoint p = index.from(c), q = index.to(c);
  const bool right = e.dx > 0 || (e.dx == 0 && e.dy > 0), hides = e.turn < 0;
  if (!right) std::swap(p, q);
  WholeCurve out{{}, p, q, {.left = right, .hides_at_p0 = !right || hides, .hides_at_p1 = right || hides}};
  out.piece.supporting_curve =
      g.add_parallel(index.operand(c.side).geometry.supporting_curves[e.supporting_curve], p.x, p.y);
  out.piece.p0 = g.add_grid_point(p.x, p.y);
  out.piece.p1 = g.add_grid_point(q.x, q.y);
  return out;
}

/// Those that overlap on one line as one, where they are many.
std::optional<ReducedConvolution> merged_where_it_pays(const ConvolutionIndex& index, std::span<const Curve> curves) {
  if (curves.size() < kCurvesToMerge) return std::nullopt;
  ReducedConvolution out;
  for (const Curve& c : curves) {
    const WholeCurve whole = whole_curve(out.geometry, index, c);
    out.pieces.push_back(whole.piece);
    out.sides.push_back(whole.side);
  }
  if (!merging_pays(out)) return std::nullopt;
  return merged_curves(std::move(out));
}

WholeCurve copied(Geometry& g, const ReducedConvolution& from, std::size_t k) {
  const Piece& piece = from.pieces[k];
  const exact::Point &p = from.geometry.points[piece.p0], &q = from.geometry.points[piece.p1];
  WholeCurve out{{}, {p.gx, p.gy}, {q.gx, q.gy}, from.sides[k]};
  out.piece.supporting_curve = g.add(exact::SupportingCurve(from.geometry.supporting_curves[piece.supporting_curve]));
  out.piece.p0 = g.add_grid_point(p.gx, p.gy);
  out.piece.p1 = g.add_grid_point(q.gx, q.gy);
  return out;
}

/// Collects the curves, cut to the window.
class Clipped {
 public:
  explicit Clipped(const GridBox& w) : w_(w) {
    auto& g = out.geometry;
    for (auto [x, y] : {std::pair{w.x0, w.y0}, {w.x1, w.y0}, {w.x1, w.y1}, {w.x0, w.y1}}) g.add_grid_point(x, y);
    border_ = {g.add_line(1, 0, w.x0), g.add_line(1, 0, w.x1), g.add_line(0, 1, w.y0), g.add_line(0, 1, w.y1)};
  }

  /// The geometry ends with its line and its ends.
  void add(const WholeCurve& c) {
    auto& g = out.geometry;
    Piece piece = c.piece;
    if (!cut_x(piece, c.from.x, c.to.x) || !cut_y(piece) || compare_xy(g, piece.p0, piece.p1) == 0) return;
    out.pieces.push_back(piece);
    InnerSide side = c.side;
    side.hides_at_p0 |= piece.p0 != c.piece.p0;
    side.hides_at_p1 |= piece.p1 != c.piece.p1;
    out.sides.push_back(side);
  }

  /// The border; after all curves, as it has no inner side.
  void close() {
    auto& pieces = out.pieces;
    pieces.push_back({.supporting_curve = border_[0], .p0 = kSouthWest, .p1 = kNorthWest});
    pieces.push_back({.supporting_curve = border_[1], .p0 = kSouthEast, .p1 = kNorthEast});
    pieces.push_back({.supporting_curve = border_[2], .p0 = kSouthWest, .p1 = kSouthEast});
    pieces.push_back({.supporting_curve = border_[3], .p0 = kNorthWest, .p1 = kNorthEast});
  }

  ReducedConvolution out;

 private:
  static constexpr Index kSouthWest = 0, kSouthEast = 1, kNorthEast = 2, kNorthWest = 3;

  bool cut_x(Piece& piece, std::int64_t left, std::int64_t right) {
    if (right < w_.x0 || left > w_.x1) return false;
    auto& g = out.geometry;
    if (left < w_.x0) piece.p0 = g.add_crossing(piece.supporting_curve, border_[0], 0);
    if (right > w_.x1) piece.p1 = g.add_crossing(piece.supporting_curve, border_[1], 0);
    return true;
  }

  bool cut_y(Piece& piece) {
    auto& g = out.geometry;
    for (bool top : {false, true}) {
      const Index corner = top ? kNorthWest : kSouthWest;
      auto beyond = [&](Index p) { return compare_y(g, p, corner) == (top ? 1 : -1); };
      const bool first = beyond(piece.p0), last = beyond(piece.p1);
      if (first && last) return false;
      if (first || last)
        (first ? piece.p0 : piece.p1) = g.add_crossing(piece.supporting_curve, border_[top ? 3 : 2], 0);
    }
    return true;
  }

  GridBox w_;
  std::array<Index, 4> border_{};  // left, right, bottom, top
};

}  // namespace

std::vector<Curve> curves_in(const ConvolutionIndex& index, const GridBox& w, std::size_t most) {
  std::vector<Curve> out;
  index.visit_convex(range(w), [&](const Curve& c) {
    if (!misses(index, c, w)) out.push_back(c);
    return out.size() < most;
  });
  return out;
}

std::vector<Curve> curves_in(const ConvolutionIndex& index, const GridBox& w, std::span<const Curve> among) {
  std::vector<Curve> out;
  const Range r = range(w);
  for (const Curve& c : among) {
    const GridPoint p = index.from(c), q = index.to(c);
    if (double(std::max(p.x, q.x)) >= r.x0 && double(std::min(p.x, q.x)) <= r.x1 &&
        double(std::max(p.y, q.y)) >= r.y0 && double(std::min(p.y, q.y)) <= r.y1 && !misses(index, c, w))
      out.push_back(c);
  }
  return out;
}

SignMap window_sum(const ConvolutionIndex& index, const GridBox& w, std::span<const Curve> curves,
                   const InsideTest& inside) {
  Clipped clipped(w);
  Geometry& g = clipped.out.geometry;
  if (const std::optional<ReducedConvolution> merged = merged_where_it_pays(index, curves)) {
    for (std::size_t k = 0; k < merged->pieces.size(); ++k) clipped.add(copied(g, *merged, k));
  } else {
    for (const Curve& c : curves) clipped.add(whole_curve(g, index, c));
  }
  clipped.close();
  Arena arena(clipped.out.pieces.size());
  Arrangement arrangement = arrange(std::move(clipped.out.geometry), std::move(clipped.out.pieces), {}, arena.memory());
  return labelled_sum(std::move(arrangement), clipped.out.sides, true, inside);
}

}  // namespace findspace::plane
