// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/grid/prune_inside.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "exact/planar/geometry_signs.h"
#include "plane/base/parallel.h"
#include "plane/grid/inner_mask.h"
#include "plane/grid/kept_parts.h"

namespace findspace::plane {
namespace {

using exact::Geometry;
using exact::SupportingCurve;

constexpr std::size_t kFewPieces = 150;
constexpr double kManyCrossings = 1;  // a piece
constexpr double kFewRuns = 3;        // of cells in a row

/// What a mask may cost: the number of its lines, by the cube root of the crossings, and words for each of these.
struct Effort {
  double lines, words;
};
// The time grows with the third power of the lines, or with the second where the rows of one set are of few runs.
constexpr Effort kOfPair{6.5, 60}, kOfPlainPair{9, 60};
// An arrangement numbers its vertices by where curves are cut. Its lines are those by which results have been compared.
constexpr Effort kOfArrangement{5.5, 10};

constexpr std::size_t kManyToCut = 2500;  // curves: from here on ranges of them are cut at once
/// A range of pieces, cut.
struct CutRange {
  std::vector<KeptPart> parts;
  std::int64_t low = INT64_MAX, high = INT64_MIN;  // lines on which they are cut
  std::size_t first_crossing = 0;                  // number of the first point made by cutting
  std::vector<Index> borders;                      // of each of these, the line on which it lies
  std::vector<Piece> pieces;
  std::vector<InnerSide> sides;

  void note_lines() {
    for (const KeptPart& p : parts)
      for (const std::int64_t line : {p.from, p.to}) {
        if (line == KeptPart::kEnd) continue;
        low = std::min(low, line);
        high = std::max(high, line);
      }
  }
};

/// Cuts away what lies in masked cells. Ranges of pieces are worked on at once, but the lines on which they are cut are
/// added in the order of the cuts.
class Cutter {
 public:
  explicit Cutter(ReducedConvolution& c) : c_(c), g_(c.geometry), mask_(*c.mask) {}

  std::vector<CutRange> run() {
    std::vector<CutRange> ranges(range_count(c_.pieces.size(), kManyToCut));
    each_range(ranges.size(), [&](std::size_t k) {
      const IndexRange pieces = range(k, ranges.size(), c_.pieces.size());
      for (auto i = Index(pieces.first); i < pieces.end; ++i)
        add_kept_parts({c_.geometry, c_.pieces[i]}, mask_, i, ranges[k].parts);
      ranges[k].note_lines();
    });
    make_tables(ranges);
    std::size_t points = g_.points.size();
    for (CutRange& r : ranges) {
      r.first_crossing = points;
      add_borders(r);
      points += r.borders.size();
    }
    g_.points.resize(points);
    each_range(ranges.size(), [&](std::size_t k) { add_pieces(ranges[k]); });
    return ranges;
  }

 private:
  void make_tables(std::span<const CutRange> ranges) {
    std::int64_t high = INT64_MIN;
    for (const CutRange& r : ranges) {
      low_ = std::min(low_, r.low);
      high = std::max(high, r.high);
    }
    if (low_ <= high) lines_.assign(2 * std::size_t(high - low_ + 1), kNone);
  }

  void add_borders(CutRange& r) {
    r.borders.reserve(2 * r.parts.size());
    for (const KeptPart& p : r.parts)
      for (const std::int64_t line : {p.from, p.to})
        if (line != KeptPart::kEnd) r.borders.push_back(border(line, p.steep));
  }

  Index border(std::int64_t line, bool steep) {
    Index& known = lines_[2 * std::size_t(line - low_) + steep];
    if (known == kNone)
      known = g_.add(SupportingCurve::line(steep ? 0 : 1, steep ? 1 : 0, exact::int128(mask_.border(line))));
    return known;
  }

  void add_pieces(CutRange& r) {
    std::size_t cut = 0;
    for (const KeptPart& p : r.parts) {
      const Piece& piece = c_.pieces[p.piece];
      const auto place = [&](std::int64_t line, Index end) {
        if (line == KeptPart::kEnd) return end;
        const std::size_t point = r.first_crossing + cut;
        g_.points[point] = g_.crossing(piece.supporting_curve, r.borders[cut++], 0);
        return Index(point);
      };
      const Index from = place(p.from, p.reversed ? piece.p1 : piece.p0);
      const Index to = place(p.to, p.reversed ? piece.p0 : piece.p1);
      if (compare_xy(g_, from, to) != 0) keep(p, p.reversed ? to : from, p.reversed ? from : to, r);
    }
  }

  void keep(const KeptPart& p, Index p0, Index p1, CutRange& r) const {
    const Piece& piece = c_.pieces[p.piece];
    InnerSide& side = r.sides.emplace_back(c_.sides[p.piece]);  // ends made by cutting lie inside the sum anyway
    side.hides_at_p0 |= p0 != piece.p0;
    side.hides_at_p1 |= p1 != piece.p1;
    Piece& part = r.pieces.emplace_back(piece);
    part.p0 = p0;
    part.p1 = p1;
  }

  ReducedConvolution& c_;
  Geometry& g_;
  const InnerMask& mask_;
  std::int64_t low_ = INT64_MAX;  // the first line
  std::vector<Index> lines_;      // of it and those after it, borders between columns and between rows
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

/// About how many runs of cells a row has in the mean.
double runs_in_row(const Outline& outline) {
  double low = INFINITY, high = -INFINITY, way = 0;
  for (const LatticeEdge& e : outline) {
    low = std::min(low, e.y0);
    high = std::max(high, e.y0);
    way += std::abs(e.y1 - e.y0);
  }
  return way / 2 / std::max(high - low, 1.0);
}

bool has_few_runs(std::span<const Outline> outlines) {
  return std::all_of(outlines.begin(), outlines.end(), [](const Outline& o) { return runs_in_row(o) < kFewRuns; });
}

bool is_bounded_face(const GridOperand& o) { return o.faces.size() == 1 && !o.faces[0].unbounded; }

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
  const Effort effort = !is_bounded_face(a) || !is_bounded_face(b) ? kOfArrangement
                        : has_few_runs(p) || has_few_runs(q)       ? kOfPlainPair
                                                                   : kOfPair;
  const double crossings = estimated_crossings(c);
  const double lines = std::clamp(effort.lines * std::cbrt(crossings), 64.0, 4000.0);
  const auto side = std::max<std::int64_t>(std::int64_t(std::max(c.width, c.height) / lines), 16);
  return InnerMask(pairs, side, effort.words * crossings);
}

std::optional<InnerMask> mask_that_pays(const ReducedConvolution& c, const GridOperand& a, const GridOperand& b) {
  if (c.pieces.size() < kFewPieces) return std::nullopt;
  const CurveExtent extent = extent_of(c);
  return pruning_pays(extent) ? std::optional(mask_for(extent, a, b)) : std::nullopt;
}

bool lies_in(const InnerMask& mask, const LatticeEdge& segment) {
  const LatticeRunner run(segment);
  const std::int64_t last = mask.line_of(run.end());
  for (std::int64_t line = mask.line_of(run.start()); line <= last;) {
    const std::int64_t depth = run.depth(mask, line);
    if (depth == 0) return false;
    line += depth;
  }
  return true;
}

ReducedConvolution prune_inside(ReducedConvolution c) {
  std::vector<CutRange> ranges = Cutter(c).run();
  ReducedConvolution out;
  out.geometry = std::move(c.geometry);
  out.pieces = std::move(ranges[0].pieces);
  out.sides = std::move(ranges[0].sides);
  for (std::size_t k = 1; k < ranges.size(); ++k) {
    out.pieces.insert(out.pieces.end(), ranges[k].pieces.begin(), ranges[k].pieces.end());
    out.sides.insert(out.sides.end(), ranges[k].sides.begin(), ranges[k].sides.end());
  }
  return out;
}

}  // namespace findspace::plane
