// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/grid/prune_inside.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "exact/planar/geometry_signs.h"
#include "plane/grid/inner_mask.h"

namespace findspace::plane {
namespace {

using exact::Geometry;
using exact::SupportingCurve;

constexpr std::size_t kFewPieces = 150;
constexpr double kManyCrossings = 1;  // a piece
constexpr double kLines = 5.5;        // the mask costs about the third power of their number
constexpr double kWordsPerCrossing = 10;

/// A segment along its longer axis u.
struct Run {
  double u0, v0, u1, v1;
  bool steep, reversed;

  static Run of(const LatticeEdge& e) {
    const bool steep = std::abs(e.y1 - e.y0) > std::abs(e.x1 - e.x0);
    Run run{steep ? e.y0 : e.x0, steep ? e.x0 : e.y0, steep ? e.y1 : e.x1, steep ? e.x1 : e.y1, steep, false};
    if (run.u1 >= run.u0) return run;
    std::swap(run.u0, run.u1);
    std::swap(run.v0, run.v1);
    run.reversed = true;
    return run;
  }

  /// How many lines from this one on it passes in masked cells only; its slope is at most one.
  std::int64_t depth(const InnerMask& mask, std::int64_t line) const {
    double low = std::max(u0, double(mask.border(line))), high = std::min(u1, double(mask.border(line + 1)));
    double slope = u1 > u0 ? (v1 - v0) / (u1 - u0) : 0, va = v0 + slope * (low - u0), vb = v0 + slope * (high - u0);
    // Two grid steps are far more than the rounding of these doubles (2^43 steps at most).
    std::int64_t c0 = mask.line_of(std::min(va, vb) - 2), c1 = mask.line_of(std::max(va, vb) + 2);
    std::int64_t least = INT64_MAX;
    for (std::int64_t c = c0; c <= c1; ++c) least = std::min(least, steep ? mask.depth(c, line) : mask.depth(line, c));
    return least;
  }
};

/// Cuts away what lies in masked cells. A piece is followed along its longer axis; it is cut where it passes from a
/// line of cells that are all masked to one that is not, on the border between them, which is a grid line.
class Cutter {
 public:
  Cutter(Geometry& g, const InnerMask& mask) : g_(g), mask_(mask) {}

  void cut(const Piece& piece, std::vector<Piece>& out) {
    const exact::Point a = g_.points[piece.p0], b = g_.points[piece.p1];
    const Run run = Run::of({a.x, a.y, b.x, b.y});
    const bool steep = run.steep, reversed = run.reversed;
    Index from = reversed ? piece.p1 : piece.p0, to = reversed ? piece.p0 : piece.p1;
    std::int64_t first = mask_.line_of(run.u0), last = mask_.line_of(run.u1);
    Index open = kNone;  // start of the part that is kept at present
    for (std::int64_t line = first; line <= last;) {
      std::int64_t depth = run.depth(mask_, line);
      if (depth == 0 && open == kNone) open = line == first ? from : border(piece, line, steep);
      if (depth > 0 && open != kNone) {
        keep(piece, open, border(piece, line, steep), reversed, out);
        open = kNone;
      }
      line += std::max<std::int64_t>(depth, 1);
    }
    if (open != kNone) keep(piece, open, to, reversed, out);
  }

 private:
  Index border(const Piece& piece, std::int64_t line, bool steep) {
    auto [at, fresh] = lines_.try_emplace(2 * line + steep, 0);
    if (fresh)
      at->second = g_.add(SupportingCurve::line(steep ? 0 : 1, steep ? 1 : 0, exact::int128(mask_.border(line))));
    return g_.add_crossing(piece.supporting_curve, at->second, 0);
  }

  void keep(const Piece& piece, Index from, Index to, bool reversed, std::vector<Piece>& out) const {
    if (compare_xy(g_, from, to) == 0) return;
    Piece part = piece;
    part.p0 = reversed ? to : from;
    part.p1 = reversed ? from : to;
    out.push_back(part);
  }

  Geometry& g_;
  const InnerMask& mask_;
  std::unordered_map<std::int64_t, Index> lines_;
};

Outline outline(const GridFace& face) {
  Outline out;
  for (const GridCorner& c : face.corners) {
    GridPoint to = face.corners[c.next].at;
    out.push_back({double(c.at.x), double(c.at.y), double(to.x), double(to.y)});
  }
  return out;
}

/// An unbounded face as far as it can matter: up to a frame further out than the other set is large.
Outline framed(const GridFace& face, const GridOperand& other) {
  Outline out = outline(face);
  const GridBox p = box_of(std::span(&face, 1)), q = box_of(other.faces);
  const double far = double(q.x1 - q.x0) + double(q.y1 - q.y0) + 2;
  const double x0 = double(p.x0) - far, y0 = double(p.y0) - far, x1 = double(p.x1) + far, y1 = double(p.y1) + far;
  out.insert(out.end(), {{x0, y0, x1, y0}, {x1, y0, x1, y1}, {x1, y1, x0, y1}, {x0, y1, x0, y0}});
  return out;
}

std::vector<Outline> outlines(const GridOperand& o, const GridOperand& other) {
  std::vector<Outline> out;
  for (const GridFace& f : o.faces)
    if (!f.corners.empty()) out.push_back(f.unbounded ? framed(f, other) : outline(f));
  return out;
}

/// Of the curves of a convolution.
CurveExtent extent_of(const ReducedConvolution& c) {
  double x0 = 1e300, y0 = 1e300, x1 = -1e300, y1 = -1e300, length = 0;
  const auto& points = c.geometry.points;
  for (const Piece& p : c.pieces) {
    const exact::Point &a = points[p.p0], &b = points[p.p1];
    x0 = std::min(x0, a.x);
    x1 = std::max(x1, b.x);
    y0 = std::min({y0, a.y, b.y});
    y1 = std::max({y1, a.y, b.y});
    length += std::sqrt((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y));
  }
  return {c.pieces.size(), length, x1 - x0, y1 - y0};
}

}  // namespace

double estimated_crossings(const CurveExtent& c) {
  return c.length * c.length / (3.14 * std::max(c.width * c.height, 1.0));
}

bool pruning_pays(const CurveExtent& c) {
  return c.count >= kFewPieces && estimated_crossings(c) > kManyCrossings * double(c.count);
}

InnerMask mask_for(const CurveExtent& c, const GridOperand& a, const GridOperand& b) {
  std::vector<Outline> p = outlines(a, b), q = outlines(b, a);
  std::vector<InnerMask::Pair> pairs;
  for (const Outline& x : p)
    for (const Outline& y : q) pairs.push_back({&x, &y});
  const double crossings = estimated_crossings(c), lines = std::clamp(kLines * std::cbrt(crossings), 64.0, 4000.0);
  const auto side = std::max<std::int64_t>(std::int64_t(std::max(c.width, c.height) / lines), 16);
  return InnerMask(pairs, side, kWordsPerCrossing * crossings);
}

std::optional<InnerMask> mask_that_pays(const ReducedConvolution& c, const GridOperand& a, const GridOperand& b) {
  if (c.pieces.size() < kFewPieces) return std::nullopt;
  const CurveExtent extent = extent_of(c);
  return pruning_pays(extent) ? std::optional(mask_for(extent, a, b)) : std::nullopt;
}

bool lies_in(const InnerMask& mask, const LatticeEdge& segment) {
  const Run run = Run::of(segment);
  const std::int64_t last = mask.line_of(run.u1);
  for (std::int64_t line = mask.line_of(run.u0); line <= last;) {
    const std::int64_t depth = run.depth(mask, line);
    if (depth == 0) return false;
    line += depth;
  }
  return true;
}

ReducedConvolution prune_inside(ReducedConvolution c) {
  ReducedConvolution out;
  Cutter cutter(c.geometry, *c.mask);
  for (std::size_t k = 0; k < c.pieces.size(); ++k) {
    std::size_t first = out.pieces.size();
    cutter.cut(c.pieces[k], out.pieces);
    for (std::size_t i = first; i < out.pieces.size(); ++i) {
      InnerSide& side = out.sides.emplace_back(c.sides[k]);  // ends made by cutting lie inside the sum anyway
      side.hides_at_p0 |= out.pieces[i].p0 != c.pieces[k].p0;
      side.hides_at_p1 |= out.pieces[i].p1 != c.pieces[k].p1;
    }
  }
  out.geometry = std::move(c.geometry);
  return out;
}

}  // namespace findspace::plane
