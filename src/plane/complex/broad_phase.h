// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Which pieces may meet: a uniform grid of cells, every piece entered in the cells it may cross, column by column. Few
// pieces share a single cell, sorted by their left ends and swept. Guarantee: two pieces with a common point share a
// cell; a pair may be reported although the pieces do not meet, and (rarely) twice. Everything here is conservative
// double arithmetic; no sign is decided. Cost: O(cells crossed + pairs). Keywords: uniform grid, broad phase, spatial
// hashing.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "plane/base/arena.h"
#include "plane/base/parallel.h"
#include "plane/complex/arrangement.h"

namespace findspace::plane {

struct PieceBox {
  double x0, y0, x1, y1;
  bool meets(const PieceBox& o) const { return x0 <= o.x1 && o.x0 <= x1 && y0 <= o.y1 && o.y0 <= y1; }
};

inline PieceBox joined(const PieceBox& a, const PieceBox& b) {
  return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
}

class CellGrid {
 public:
  /// All points that will ever be asked about must be ends of the pieces or `extra`.
  CellGrid(const exact::Geometry& g, std::span<const Piece> pieces, std::span<const Index> extra, Memory memory);

  /// Calls f(i, j), i < j, for every pair of pieces whose boxes meet in a common cell.
  template <class F>
  void pairs(F&& f) const {
    pairs({0, columns_}, f);
  }
  /// The same for the cells of some columns: for ranges of columns one after the other, the same pairs in their order.
  template <class F>
  void pairs(IndexRange columns, F&& f) const {
    pairs(
        columns, [](Index) { return kNone; }, f);
  }
  /// Pieces that follow each other in a cell and are of one group(i), not kNone, are passed over.
  template <class Group, class F>
  void pairs(IndexRange columns, Group&& group, F&& f) const;
  IndexRange columns() const { return {0, columns_}; }
  /// All columns in so many ranges that take about the same time; some may be empty.
  std::vector<IndexRange> strips(std::size_t count) const;
  /// The pieces in the cells of some columns, in their order.
  std::vector<Index> pieces_in(IndexRange columns) const;

  Index column(double x) const { return clamp(x, box_.x0, column_scale_, columns_); }
  Index row(double y) const { return clamp(y, box_.y0, row_scale_, rows_); }
  double row_top(Index r) const { return box_.y0 + (r + 1) / row_scale_; }
  std::span<const Index> cell(Index column, Index row) const {
    if (start_.empty()) return items_;
    std::size_t k = std::size_t(column) * rows_ + row;
    return {items_.data() + start_[k], start_[k + 1] - start_[k]};
  }
  const PieceBox& box(Index piece) const { return boxes_[piece]; }
  /// No coordinate of a known point is off by more than this.
  double slack() const { return slack_; }

 private:
  struct Rows {
    Index lo, hi;
  };
  struct Left {
    double x0;
    Index piece;
  };
  static Index clamp(double v, double origin, double scale, Index count) {
    double k = (v - origin) * scale;
    return k <= 0 ? 0 : k >= double(count - 1) ? count - 1 : Index(k);
  }
  void set_boxes(const exact::Geometry& g, std::span<const Piece> pieces, std::span<const Index> extra);
  void set_resolution(std::size_t pieces);
  void enter_sorted();
  /// Few pieces, in the order of the columns that they start in, of n; the most in one column.
  Index enter_by_columns(Index n);
  void enter(const exact::Geometry& g, std::span<const Piece> pieces);
  void find_rows(const exact::Geometry& g, std::span<const Piece> pieces);
  void find_rows(const exact::Geometry& g, std::span<const Piece> pieces, IndexRange some, ArenaVector<Rows>& to);
  /// Calls visit(piece, cell) for the cells that each piece may cross, one piece after the other.
  template <class Visit>
  void each_cell(Visit&& visit) const;
  /// Of one column, those that a piece may cross.
  Rows rows_in(Index column, const exact::Geometry& g, const Piece& piece, const PieceBox& box) const;
  bool first_common_cell(Index i, Index j, Index column, Index row) const;

  ArenaVector<PieceBox> boxes_;
  ArenaVector<Left> sorted_;  // the left ends of few pieces
  PieceBox box_{0, 0, 1, 1};
  double slack_ = 0, column_scale_ = 1, row_scale_ = 1;
  Index columns_ = 1, rows_ = 1;
  ArenaVector<Index> first_column_, rows_start_;  // per piece
  ArenaVector<Rows> piece_rows_;                  // per piece and column
  ArenaVector<Index> start_, items_;              // cell -> pieces; of few pieces only items_
};

/// How far off a box of pieces may be, from the largest error and the largest coordinate of their ends.
double box_slack(double error, double largest);
inline PieceBox segment_box(const exact::Point& a, const exact::Point& b, double slack) {
  return {a.x - slack, std::min(a.y, b.y) - slack, b.x + slack, std::max(a.y, b.y) + slack};
}
/// Holds the piece.
PieceBox box_of(const exact::Geometry& g, const Piece& piece, double slack);

template <class Group, class F>
void CellGrid::pairs(IndexRange columns, Group&& group, F&& f) const {
  if (columns.size() == 0) return;
  if (columns_ * rows_ == 1) {
    const Left* const end = sorted_.data() + sorted_.size();
    const PieceBox* const boxes = boxes_.data();
    for (const Left* s = sorted_.data(); s != end; ++s) {
      const PieceBox b = boxes[s->piece];
      for (const Left* t = s + 1; t != end && t->x0 <= b.x1; ++t)
        if (b.y0 <= boxes[t->piece].y1 && boxes[t->piece].y0 <= b.y1)
          f(std::min(s->piece, t->piece), std::max(s->piece, t->piece));
    }
    return;
  }
  for (Index c = Index(columns.first); c < columns.end; ++c)
    for (Index r = 0; r < rows_; ++r) {
      auto in = cell(c, r);
      std::size_t end = 0;  // of the pieces of one group about s
      for (std::size_t s = 0; s + 1 < in.size(); ++s) {
        const PieceBox& b = boxes_[in[s]];
        if (s >= end)
          for (end = s + 1; end < in.size() && group(in[s]) != kNone && group(in[end]) == group(in[s]);) ++end;
        for (std::size_t t = end; t < in.size(); ++t)
          if (b.meets(boxes_[in[t]]) && first_common_cell(in[s], in[t], c, r)) f(in[s], in[t]);
      }
    }
}

}  // namespace findspace::plane
