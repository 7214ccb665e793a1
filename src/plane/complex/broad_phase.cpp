// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/complex/broad_phase.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "exact/margins/plane.h"
#include "plane/base/small_sort.h"

namespace findspace::plane {
namespace {

/// Up to here a sweep along x costs less than the cells.
constexpr std::size_t kFewPieces = 256;
constexpr std::size_t kFewToSort = 8;       // that start in one column are inserted one by one
constexpr std::size_t kManyToEnter = 6000;  // from here on ranges of pieces are entered at once

/// y of the supporting curve at x, clamped into the piece's box by the caller.
double y_at(const exact::Geometry& g, const Piece& p, double x) {
  const exact::SupportingCurve& k = g.supporting_curves[p.supporting_curve];
  if (!k.circle) {
    const exact::Point &a = g.points[p.p0], &b = g.points[p.p1];
    double w = b.x - a.x;
    return w > 0 ? a.y + (b.y - a.y) * ((x - a.x) / w) : a.y;
  }
  double dx = x - k.x().value, h = k.z().value * k.z().value - dx * dx;
  double s = h > 0 ? std::sqrt(h) : 0;
  return k.y().value + (p.half > 0 ? s : -s);
}

constexpr PieceBox kNoBox{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
                          -std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

/// Of the ends of pieces, and of points.
struct Ends {
  double error = 0;
  PieceBox box = kNoBox;
  bool of_arcs = false;  // some

  void take(const exact::Point& p) {
    error = std::max(error, double(p.error));
    box = joined(box, {p.x, p.y, p.x, p.y});
  }
  void take(const Ends& o) {
    error = std::max(error, o.error);
    box = joined(box, o.box);
    of_arcs |= o.of_arcs;
  }
  double slack() const {
    if (box.x0 > box.x1) return 0;  // there are none
    return box_slack(
        error, std::max(std::max(std::abs(box.x0), std::abs(box.x1)), std::max(std::abs(box.y0), std::abs(box.y1))));
  }
};

PieceBox widened(const PieceBox& b, double by) { return {b.x0 - by, b.y0 - by, b.x1 + by, b.y1 + by}; }

std::span<const Piece> items_of(std::span<const Piece> pieces, std::size_t k, std::size_t ranges) {
  const IndexRange some = range(k, ranges, pieces.size());
  return pieces.subspan(some.first, some.size());
}

/// What work(k) gives for each of `ranges`, in one.
template <class Result, class Work, class Take>
Result of_all_ranges(std::size_t ranges, Work&& work, Take&& take) {
  if (ranges == 1) return work(0);
  std::array<Result, kRanges> of_range;
  parallel_for(ranges, [&](std::size_t k) { of_range[k] = work(k); });
  for (std::size_t k = 1; k < ranges; ++k) take(of_range[0], of_range[k]);
  return of_range[0];
}

/// Sets the boxes of the ends of some pieces.
Ends set_boxes_of_ends(const exact::Geometry& g, std::span<const Piece> pieces, PieceBox* box) {
  Ends all;
  for (const Piece& p : pieces) {
    const exact::Point &a = g.points[p.p0], &b = g.points[p.p1];
    *box = segment_box(a, b, 0);
    all.error = std::max(all.error, std::max(double(a.error), double(b.error)));
    all.box = joined(all.box, *box++);
    all.of_arcs |= p.half != 0;
  }
  return all;
}

/// Of the boxes of some arcs, the one around them.
PieceBox set_boxes_of_arcs(const exact::Geometry& g, std::span<const Piece> pieces, double slack, PieceBox* boxes) {
  PieceBox all = kNoBox;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    if (pieces[k].half == 0) continue;
    boxes[k] = box_of(g, pieces[k], slack);
    all = joined(all, boxes[k]);
  }
  return all;
}

}  // namespace

double box_slack(double error, double largest) { return error * 2 + largest * margin::kPieceBoxSlack; }

PieceBox box_of(const exact::Geometry& g, const Piece& p, double slack) {
  const exact::Point &a = g.points[p.p0], &b = g.points[p.p1];
  PieceBox box = segment_box(a, b, slack);
  if (p.half == 0) return box;
  const exact::SupportingCurve& k = g.supporting_curves[p.supporting_curve];
  if (k.x().value > box.x1 || k.x().value < box.x0) return box;  // monotone on this part: the ends bound it
  double e = slack + k.z().error + k.y().error + std::abs(k.z().value) * margin::kPieceBoxSlack;
  if (p.half > 0)
    box.y1 = std::max(box.y1, k.y().value + k.z().value + e);
  else
    box.y0 = std::min(box.y0, k.y().value - k.z().value - e);
  return box;
}

CellGrid::CellGrid(const exact::Geometry& g, std::span<const Piece> pieces, std::span<const Index> extra, Memory memory)
    : boxes_(memory),
      sorted_(memory),
      first_column_(memory),
      rows_start_(memory),
      piece_rows_(memory),
      start_(memory),
      items_(memory) {
  set_boxes(g, pieces, extra);
  if (pieces.size() <= kFewPieces) {
    enter_sorted();
  } else {
    set_resolution(pieces.size());
    enter(g, pieces);
  }
}

void CellGrid::enter_sorted() {
  column_scale_ = 1 / std::max(box_.x1 - box_.x0, 1e-300);  // no sign: keeps the scale of a flat box finite
  row_scale_ = 1 / std::max(box_.y1 - box_.y0, 1e-300);     // no sign: keeps the scale of a flat box finite
  const auto n = Index(boxes_.size());
  const PieceBox* const boxes = boxes_.data();
  sorted_.resize(n);
  items_.resize(n);
  if (enter_by_columns(n) <= kFewToSort) {
    // Numbers alone are moved: what has just been written in two parts is slow to read as a whole.
    insert_all(items_.data(), items_.data() + n, [boxes](Index p, Index q) { return boxes[p].x0 < boxes[q].x0; });
    for (Index k = 0; k < n; ++k) sorted_[k] = {boxes[items_[k]].x0, items_[k]};
  } else {
    for (Index i = 0; i < n; ++i) sorted_[i] = {boxes[i].x0, i};
    std::sort(sorted_.begin(), sorted_.end(),
              [](const Left& p, const Left& q) { return p.x0 != q.x0 ? p.x0 < q.x0 : p.piece < q.piece; });
    for (Index k = 0; k < n; ++k) items_[k] = sorted_[k].piece;
  }
}

Index CellGrid::enter_by_columns(Index n) {
  std::array<std::uint16_t, kFewPieces> column_of, end;  // of a piece; of the pieces before a column, then in it
  std::fill_n(end.begin(), n, std::uint16_t(0));
  const PieceBox* const boxes = boxes_.data();
  const double origin = box_.x0, scale = column_scale_ * n;
  for (Index i = 0; i < n; ++i) ++end[column_of[i] = std::uint16_t(clamp(boxes[i].x0, origin, scale, n))];
  Index before = 0, most = 0;
  for (Index c = 0; c < n; ++c) {
    const Index count = end[c];
    end[c] = std::uint16_t(before);
    before += count;
    most = std::max(most, count);
  }
  Index* const items = items_.data();
  for (Index i = 0; i < n; ++i) items[end[column_of[i]]++] = i;
  return most;
}

void CellGrid::set_boxes(const exact::Geometry& g, std::span<const Piece> pieces, std::span<const Index> extra) {
  const std::size_t ranges = range_count(pieces.size(), kManyToEnter);
  boxes_.resize(pieces.size());
  const auto first_box = [&](std::size_t k) { return boxes_.data() + range(k, ranges, pieces.size()).first; };
  Ends ends = of_all_ranges<Ends>(
      ranges, [&](std::size_t k) { return set_boxes_of_ends(g, items_of(pieces, k, ranges), first_box(k)); },
      [](Ends& all, const Ends& more) { all.take(more); });
  for (Index p : extra) ends.take(g.points[p]);
  slack_ = ends.slack();
  PieceBox all = widened(ends.box, slack_);
  const PieceBox of_arcs = of_all_ranges<PieceBox>(
      ranges,
      [&](std::size_t k) {
        const auto some = items_of(pieces, k, ranges);
        PieceBox* const boxes = first_box(k);
        for (std::size_t i = 0; i < some.size(); ++i) boxes[i] = widened(boxes[i], slack_);
        return ends.of_arcs ? set_boxes_of_arcs(g, some, slack_, boxes) : kNoBox;
      },
      [](PieceBox& around, const PieceBox& more) { around = joined(around, more); });
  all = joined(all, of_arcs);
  if (all.x0 <= all.x1) box_ = all;
}

void CellGrid::set_resolution(std::size_t pieces) {
  constexpr double kFlat = 1e-300;  // no sign: keeps the scale of a flat box finite
  double w = std::max(box_.x1 - box_.x0, kFlat), h = std::max(box_.y1 - box_.y0, kFlat);
  double cells = std::clamp(double(pieces), 1.0, 4.0e6), aspect = std::sqrt(w / h);
  double side = std::sqrt(cells);
  columns_ = Index(std::clamp(side * aspect, 1.0, cells));
  rows_ = Index(std::clamp(side / aspect, 1.0, cells));
  column_scale_ = columns_ / w;
  row_scale_ = rows_ / h;
}

CellGrid::Rows CellGrid::rows_in(Index c, const exact::Geometry& g, const Piece& piece, const PieceBox& b) const {
  const exact::SupportingCurve& k = g.supporting_curves[piece.supporting_curve];
  const double xa = std::clamp(box_.x0 + c / column_scale_ - 2 * slack_, b.x0, b.x1);
  const double xb = std::clamp(box_.x0 + (c + 1) / column_scale_ + 2 * slack_, b.x0, b.x1);
  if (piece.half != 0 && xa <= k.x().value && k.x().value <= xb) return {row(b.y0), row(b.y1)};
  const double ya = y_at(g, piece, xa), yb = y_at(g, piece, xb), lo = std::min(ya, yb), hi = std::max(ya, yb);
  const double tolerance = 4 * slack_ + (piece.half == 0 ? 0 : k.z().error + k.y().error);
  return {row(std::max(lo - tolerance, b.y0)), row(std::min(hi + tolerance, b.y1))};
}

/// Appends the rows of some pieces; those of each end at its place in rows_start_.
void CellGrid::find_rows(const exact::Geometry& g, std::span<const Piece> pieces, IndexRange some,
                         ArenaVector<Rows>& to) {
  to.reserve(2 * some.size());
  for (auto i = Index(some.first); i < some.end; ++i) {
    const PieceBox& b = boxes_[i];
    const Index c0 = column(b.x0), c1 = column(b.x1);
    first_column_[i] = c0;
    const bool thin = c0 == c1 || b.x1 - b.x0 < 8 * slack_;
    for (Index c = c0; c <= c1; ++c) to.push_back(thin ? Rows{row(b.y0), row(b.y1)} : rows_in(c, g, pieces[i], b));
    rows_start_[i + 1] = Index(to.size());
  }
}

void CellGrid::find_rows(const exact::Geometry& g, std::span<const Piece> pieces) {
  first_column_.resize(pieces.size());
  rows_start_.resize(pieces.size() + 1);
  const std::size_t ranges = range_count(pieces.size(), kManyToEnter);
  std::vector<ArenaVector<Rows>> more(ranges - 1);
  each_range(ranges, [&](std::size_t k) {
    find_rows(g, pieces, range(k, ranges, pieces.size()), k == 0 ? piece_rows_ : more[k - 1]);
  });
  for (std::size_t k = 1; k < ranges; ++k) {
    const auto before = Index(piece_rows_.size());
    piece_rows_.insert(piece_rows_.end(), more[k - 1].begin(), more[k - 1].end());
    const IndexRange some = range(k, ranges, pieces.size());
    for (std::size_t i = some.first; i < some.end; ++i) rows_start_[i + 1] += before;
  }
}

void CellGrid::enter(const exact::Geometry& g, std::span<const Piece> pieces) {
  find_rows(g, pieces);
  start_.assign(std::size_t(columns_) * rows_ + 1, 0);
  each_cell([&](Index, std::size_t cell) { ++start_[cell + 1]; });
  for (std::size_t k = 1; k < start_.size(); ++k) start_[k] += start_[k - 1];
  items_.resize(start_.back());
  ArenaVector<Index> at(start_.begin(), start_.end() - 1, start_.get_allocator());
  each_cell([&](Index piece, std::size_t cell) { items_[at[cell]++] = piece; });
}

template <class Visit>
void CellGrid::each_cell(Visit&& visit) const {
  for (Index i = 0; i < first_column_.size(); ++i)
    for (Index k = rows_start_[i]; k < rows_start_[i + 1]; ++k) {
      const std::size_t column_base = std::size_t(first_column_[i] + (k - rows_start_[i])) * rows_;
      for (Index y = piece_rows_[k].lo; y <= piece_rows_[k].hi; ++y) visit(i, column_base + y);
    }
}

std::vector<IndexRange> CellGrid::strips(std::size_t count) const {
  if (count == 1) return {{0, columns_}};
  const auto pairs_in = [&](std::size_t k) {
    const double items = double(start_[k + 1] - start_[k]);
    return items * items;
  };
  std::vector<double> pairs{0};  // up to each column
  for (std::size_t c = 0; c < columns_; ++c) {
    double more = 0;
    for (std::size_t k = c * rows_; k < (c + 1) * rows_; ++k) more += pairs_in(k);
    pairs.push_back(pairs.back() + more);
  }
  std::vector<IndexRange> out;
  std::size_t at = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const double share = pairs.back() * double(k + 1) / double(count);
    const auto end = std::size_t(std::lower_bound(pairs.begin(), pairs.end(), share) - pairs.begin());
    out.push_back({at, k + 1 == count ? columns_ : std::clamp<std::size_t>(end, at, columns_)});
    at = out.back().end;
  }
  return out;
}

std::vector<Index> CellGrid::pieces_in(IndexRange columns) const {
  std::vector<char> is_in(boxes_.size(), 0);
  std::size_t count = 0;
  for (std::size_t k = start_[columns.first * rows_]; k < start_[columns.end * rows_]; ++k)
    count += std::exchange(is_in[items_[k]], 1) == 0;
  std::vector<Index> found;
  found.reserve(count);
  for (Index i = 0; i < is_in.size(); ++i)
    if (is_in[i] != 0) found.push_back(i);
  return found;
}

bool CellGrid::first_common_cell(Index i, Index j, Index column, Index row) const {
  const Rows& a = piece_rows_[rows_start_[i] + column - first_column_[i]];
  const Rows& b = piece_rows_[rows_start_[j] + column - first_column_[j]];
  if (row != std::max(a.lo, b.lo)) return false;
  if (column == first_column_[i] || column == first_column_[j]) return true;
  const Rows& p = piece_rows_[rows_start_[i] + column - 1 - first_column_[i]];
  const Rows& q = piece_rows_[rows_start_[j] + column - 1 - first_column_[j]];
  return std::max(p.lo, q.lo) > std::min(p.hi, q.hi);
}

}  // namespace findspace::plane
