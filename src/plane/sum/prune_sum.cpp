// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "plane/base/union_find.h"
#include "plane/complex/broad_phase.h"
#include "plane/complex/piece_meet.h"
#include "plane/grid/kept_parts.h"
#include "plane/sum/sum_mask.h"

namespace findspace::plane {
namespace {

using exact::Geometry;

/// The lattice's lines as supporting curves, made when they are first needed.
class BorderLines {
 public:
  BorderLines(Geometry& g, const InnerMask& mask) : g_(g), mask_(mask) {}

  /// Level ones are borders between rows.
  Index line(std::int64_t line, bool level) {
    const auto [known, is_new] = lines_.try_emplace({line, level}, kNone);
    if (is_new) known->second = g_.add_line(level ? 0 : 1, level ? 1 : 0, exact::int128(mask_.border(line)));
    return known->second;
  }

 private:
  Geometry& g_;
  const InnerMask& mask_;
  std::map<std::pair<std::int64_t, bool>, Index> lines_;
};

/// Where unmarked cells may be: beyond it either all cells are marked, or none is and no curve is there.
LatticeBox lattice_box(const InnerMask& mask, std::span<const PieceBox> boxes) {
  if (mask.within()) return *mask.within();
  PieceBox all = boxes[0];
  for (const PieceBox& b : boxes) all = joined(all, b);
  return {mask.line_of(all.y0) - 1, mask.line_of(all.y1) + 1, mask.line_of(all.x0) - 1, mask.line_of(all.x1) + 1};
}

/// One unmarked cell of each connected piece of them, in the middle of its longest row.
std::vector<CellPlace> free_places(const InnerMask& mask, const LatticeBox& box) {
  std::vector<LatticeRun> runs;
  std::vector<std::pair<Index, Index>> joined_runs;
  std::size_t above = 0, row_start = 0;  // the runs of the row before
  for (std::int64_t row = box.row0; row <= box.row1; ++row) {
    above = row_start;
    row_start = runs.size();
    for (std::int64_t c = box.column0; c <= box.column1; ++c) {
      if (const std::int64_t depth = mask.depth(c, row); depth > 0) {
        c += depth - 1;
        continue;
      }
      if (runs.size() > row_start && runs.back().last == c - 1)
        runs.back().last = c;
      else
        runs.push_back({row, c, c});
    }
    std::size_t i = above;
    for (std::size_t k = row_start; k < runs.size() && i < row_start;) {
      if (runs[i].first <= runs[k].last && runs[k].first <= runs[i].last) joined_runs.push_back({Index(i), Index(k)});
      if (runs[i].last < runs[k].last)
        ++i;
      else
        ++k;
    }
  }
  UnionFind same(runs.size());
  for (const auto& [i, k] : joined_runs) same.unite(i, k);
  std::vector<Index> longest(runs.size(), kNone);
  for (Index k = 0; k < runs.size(); ++k) {
    Index& best = longest[same.find(k)];
    if (best == kNone || runs[k].last - runs[k].first > runs[best].last - runs[best].first) best = k;
  }
  std::vector<CellPlace> out;
  for (Index k : longest)
    if (k != kNone) out.push_back({(runs[k].first + runs[k].last) / 2, runs[k].row});
  return out;
}

/// Counts the numbers of places by rays downwards.
class PlaceNumbers {
 public:
  PlaceNumbers(ConvolutionBuilder& c, std::span<const PieceBox> boxes, const InnerMask& mask)
      : c_(c), g_(c.curves.geometry), boxes_(boxes), mask_(mask) {}

  /// Nothing where a place that lies on no curve is not found.
  std::optional<std::vector<InnerPart::Seed>> at(const std::vector<CellPlace>& places, std::int32_t base) {
    std::vector<InnerPart::Seed> out;
    std::vector<CellPlace> left = places;
    constexpr int kTries = 8;
    for (int k = 0; k < kTries && !left.empty(); ++k) left = count(left, k, base, out);
    return left.empty() ? std::optional(std::move(out)) : std::nullopt;
  }

 private:
  struct Counted {
    double x, y;
    CellPlace cell;
    InnerPart::Seed seed;
    bool on_curve = false;
  };

  /// Returns those that lie on a curve.
  std::vector<CellPlace> count(const std::vector<CellPlace>& places, int attempt, std::int32_t base,
                               std::vector<InnerPart::Seed>& out) {
    std::vector<Counted> all;
    for (const CellPlace& cell : places) {
      // About the middle of the cell, by fractions that curves between grid points hardly have.
      const double side = double(mask_.border(1)), off = (1 + attempt) / 512.0;
      const double x = double(mask_.border(cell.column)) + side / 2 + 37 * off,
                   y = double(mask_.border(cell.row)) + side / 2 + 101 * off;
      const Index point = g_.add_real_point(exact::Real::from_double(x), exact::Real::from_double(y));
      all.push_back({x, y, cell, {point, base}});
    }
    std::sort(all.begin(), all.end(),
              [](const Counted& p, const Counted& q) { return p.x != q.x ? p.x < q.x : p.y < q.y; });
    for (std::size_t k = 0; k < boxes_.size(); ++k) {
      auto p =
          std::lower_bound(all.begin(), all.end(), boxes_[k].x0, [](const Counted& c, double x) { return c.x < x; });
      for (; p != all.end() && p->x <= boxes_[k].x1; ++p) pass(k, *p);
    }
    std::vector<CellPlace> left;
    for (const Counted& p : all) {
      if (p.on_curve)
        left.push_back(p.cell);
      else
        out.push_back(p.seed);
    }
    return left;
  }

  void pass(std::size_t k, Counted& p) const {
    const Piece& piece = c_.curves.pieces[k];
    if (p.y < boxes_[k].y0 || compare_x(g_, piece.p0, p.seed.point) > 0) return;
    const int beyond = compare_x(g_, piece.p1, p.seed.point);
    if (beyond <= 0) {
      // What ends at the ray is counted where it goes on; but a vertical piece, or a tip to the right, may hold the
      // place.
      p.on_curve |= beyond == 0 && p.y <= boxes_[k].y1;
      return;
    }
    const int above = p.y > boxes_[k].y1 ? 1 : height(g_, piece, p.seed.point);
    const Chain& chain = c_.chains[k];
    if (above == 0) p.on_curve = true;
    if (above > 0) p.seed.number += chain.forward ? chain.weight : -chain.weight;
  }

  ConvolutionBuilder& c_;
  Geometry& g_;
  std::span<const PieceBox> boxes_;
  const InnerMask& mask_;
};

/// Keeps what of the curves lies outside the cells, and adds the border.
class Pruner {
 public:
  Pruner(ConvolutionBuilder& c, const InnerMask& mask)
      : c_(c), g_(c.curves.geometry), mask_(mask), lines_(c.curves.geometry, mask) {}

  void cut() {
    const std::vector<Piece>& pieces = c_.curves.pieces;
    first_.assign(pieces.size(), kNone);
    last_.assign(pieces.size(), kNone);
    std::vector<KeptPart> parts;
    for (Index k = 0; k < pieces.size(); ++k) {
      parts.clear();
      add_kept_parts({g_, pieces[k]}, mask_, k, parts);
      for (const KeptPart& part : parts) keep(part);
    }
    for (Corner& corner : c_.corners) move(corner);
    std::erase_if(c_.corners, [](const Corner& corner) { return corner.in == kNone; });
  }

  void add_border(const LatticeBox& box, InnerPart& out) {
    out.first_border = Index(pieces_.size());
    for (std::int64_t row = box.row0; row <= box.row1 + 1; ++row)
      add_border_along(box.column0, box.column1, true, row, out);
    for (std::int64_t column = box.column0; column <= box.column1 + 1; ++column)
      add_border_along(box.row0, box.row1, false, column, out);
  }

  void finish() {
    c_.curves.pieces = std::move(pieces_);
    c_.chains = std::move(chains_);
    c_.curves.forward.clear();
  }

 private:
  void keep(const KeptPart& part) {
    const Piece& whole = c_.curves.pieces[part.piece];
    const auto place = [&](std::int64_t line, Index end) {
      return line == KeptPart::kEnd ? end : crossing(whole, lines_.line(line, part.steep));
    };
    Piece kept = whole;
    kept.p0 = place(part.reversed ? part.to : part.from, whole.p0);
    kept.p1 = place(part.reversed ? part.from : part.to, whole.p1);
    const Index number = Index(pieces_.size());
    if (kept.p0 == whole.p0) first_[part.piece] = number;
    if (kept.p1 == whole.p1) last_[part.piece] = number;
    kept.smooth0 &= kept.p0 == whole.p0;
    kept.smooth1 &= kept.p1 == whole.p1;
    pieces_.push_back(kept);
    chains_.push_back(c_.chains[part.piece]);
  }

  Index crossing(const Piece& piece, Index border) {
    if (piece.half == 0) return g_.add_crossing(piece.supporting_curve, border, 0);
    const exact::Meeting m = meet(g_, piece.supporting_curve, border);
    const Index first = g_.add_crossing(piece.supporting_curve, border, m.root[0]);
    return above_center(g_, first, piece.supporting_curve) == piece.half
               ? first
               : g_.add_crossing(piece.supporting_curve, border, m.root[1]);
  }

  /// To the pieces that are left; `in` is kNone where one is missing, and then the other is smooth there no more.
  void move(Corner& corner) {
    const bool in_forward = c_.chains[corner.in].forward, out_forward = c_.chains[corner.out].forward;
    const Index in = (in_forward ? last_ : first_)[corner.in], out = (out_forward ? first_ : last_)[corner.out];
    corner.in = in;
    corner.out = out;
    if (in != kNone && out != kNone) return;
    corner.in = kNone;
    if (in != kNone) (in_forward ? pieces_[in].smooth1 : pieces_[in].smooth0) = false;
    if (out != kNone) (out_forward ? pieces_[out].smooth0 : pieces_[out].smooth1) = false;
  }

  bool marked(std::int64_t column, std::int64_t row) const { return mask_.depth(column, row) > 0; }

  /// On the lower side of a row, or the left side of a column, from cell `first` to `last` of it.
  void add_border_along(std::int64_t first, std::int64_t last, bool level, std::int64_t line, InnerPart& out) {
    const auto side = [&](std::int64_t k) {
      const bool beyond = level ? marked(k, line) : marked(line, k);
      const bool before = level ? marked(k, line - 1) : marked(line - 1, k);
      return int(beyond) - int(before);
    };
    int open = 0;
    std::int64_t from = first;
    for (std::int64_t k = first; k <= last + 1; ++k) {
      const int now = k <= last ? side(k) : 0;
      if (now == open) continue;
      // To the right the left side is beyond the line, upwards it is before it.
      if (open != 0) add_border_piece(from, k, level, line, (open > 0) == level, out);
      from = k;
      open = now;
    }
  }

  void add_border_piece(std::int64_t from, std::int64_t to, bool level, std::int64_t line, bool left_inside,
                        InnerPart& out) {
    const auto point = [&](std::int64_t k) {
      const std::int64_t along = mask_.border(k), across = mask_.border(line);
      return level ? g_.add_grid_point(along, across) : g_.add_grid_point(across, along);
    };
    const Index p0 = point(from), p1 = point(to);
    pieces_.push_back({.supporting_curve = lines_.line(line, level), .p0 = p0, .p1 = p1});
    chains_.push_back({.weight = 0});
    out.left_inside.push_back(left_inside);
  }

  ConvolutionBuilder& c_;
  Geometry& g_;
  const InnerMask& mask_;
  BorderLines lines_;
  std::vector<Piece> pieces_;
  std::vector<Chain> chains_;
  std::vector<Index> first_, last_;  // of each piece before, what is left of it at p0 and at p1
};

}  // namespace

std::optional<InnerPart> prune(ConvolutionBuilder& convolution, const InnerMask& mask, std::int32_t base) {
  if (convolution.curves.pieces.empty()) return std::nullopt;
  const Geometry& g = convolution.curves.geometry;
  double error = 0, largest = 0;
  for (const exact::Point& p : g.points) {
    error = std::max(error, double(p.error));
    largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  }
  if (!(error < double(mask.border(1)))) return std::nullopt;  // boxes would be far too large
  std::vector<PieceBox> boxes;
  boxes.reserve(convolution.curves.pieces.size());
  const double slack = box_slack(error, largest);
  for (const Piece& piece : convolution.curves.pieces) boxes.push_back(box_of(g, piece, slack));
  const LatticeBox box = lattice_box(mask, boxes);
  InnerPart out;
  auto seeds = PlaceNumbers(convolution, boxes, mask).at(free_places(mask, box), base);
  if (!seeds) return std::nullopt;
  out.seeds = *std::move(seeds);
  Pruner pruner(convolution, mask);
  pruner.cut();
  pruner.add_border(box, out);
  pruner.finish();
  return out;
}

}  // namespace findspace::plane
