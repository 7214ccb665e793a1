// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "space/box/box_operations.h"

#include <algorithm>

namespace findspace::space {

using exact::Real;

namespace {

/// Which cells of a set lie along an axis of a grid that has all its coordinates.
std::vector<int> cells_under(const BoxComplex& set, int k, const Axis& fine) {
  std::vector<int> out{0};
  for (const Real& c : fine) {
    // A new coordinate lies in some old cell; an open interval lies where the coordinate before it does, or beyond
    // that.
    const int cell = set.cell_of(k, c);
    out.push_back(cell);
    out.push_back(cell % 2 == 1 ? cell + 1 : cell);
  }
  return out;
}

/// The runs of equal marks of a set along the rows of a finer grid.
class FineRows {
 public:
  FineRows(const BoxComplex& set, const Axes& fine) : set_(set) {
    for (int k = 0; k < 3; ++k) cells_[std::size_t(k)] = cells_under(set, k, fine[std::size_t(k)]);
    first_ = first_cells(cells_[0], set.cells(0));
  }

  /// Goes to a row; whether its marks may be others than those of the row before.
  bool go(int y, int z) {
    const std::array<int, 2> row{cells_[1][std::size_t(y)], cells_[2][std::size_t(z)]};
    if (row == row_) return false;
    row_ = row;
    runs_.clear();
    for (int x = 0; x < set_.cells(0);) {
      const Mark mark = set_.mark(x, row[0], row[1]);
      x = set_.run_end(x, row[0], row[1]);
      runs_.push_back({first_[std::size_t(x)], mark});
    }
    return true;
  }
  void restart() { run_ = runs_.begin(); }
  Mark mark() const { return run_->mark; }
  int end() const { return run_->end; }
  void pass(int x) {
    if (run_->end <= x) ++run_;
  }

 private:
  struct Run {
    int end;
    Mark mark;
  };
  const BoxComplex& set_;
  CellNumbers cells_;  // of the set, by those of the finer grid
  std::vector<int> first_;
  std::array<int, 2> row_{-1, -1};
  std::vector<Run> runs_;
  std::vector<Run>::const_iterator run_;
};

/// What is made of the marks of several sets, asked once for the same marks.
class Combined {
 public:
  using Combine = std::function<Mark(std::span<const Mark>)>;
  Combined(std::size_t sets, const Combine& combine) : combine_(combine) {
    constexpr std::size_t kMostSets = 8;
    if (sets > kMostSets) return;
    std::size_t count = 1;
    for (std::size_t k = 0; k < sets; ++k) count *= 3;
    known_.resize(count);
  }
  Mark of(std::span<const Mark> marks) {
    if (known_.empty()) return combine_(marks);
    std::size_t number = 0;
    for (const Mark m : marks) number = 3 * number + static_cast<std::size_t>(m + 1);
    if (!known_[number]) known_[number] = combine_(marks);
    return *known_[number];
  }

 private:
  const Combine& combine_;
  std::vector<std::optional<Mark>> known_;
};

/// One row of the common grid.
void overlay_row(std::vector<FineRows>& sets, Combined& combined, std::vector<Mark>& marks, int y, int z,
                 BoxComplex& out) {
  for (FineRows& set : sets) set.restart();
  for (int x = 0, end = 0; x < out.cells(0); x = end) {
    end = out.cells(0);
    for (std::size_t i = 0; i < sets.size(); ++i) {
      marks[i] = sets[i].mark();
      end = std::min(end, sets[i].end());
    }
    if (const Mark mark = combined.of(marks); mark != 0) out.mark_run(y, z, x, end, mark);
    if (end == out.cells(0)) return;
    for (FineRows& set : sets) set.pass(end);
  }
}

bool too_fine(const BoxComplex* set) { return set->too_fine(); }

}  // namespace

BoxComplex overlay(std::span<const BoxComplex* const> sets, const std::function<Mark(std::span<const Mark>)>& combine) {
  if (std::any_of(sets.begin(), sets.end(), too_fine)) return BoxComplex::without_cells();
  Axes all;
  for (const BoxComplex* s : sets) {
    for (int k = 0; k < 3; ++k) all[k].insert(all[k].end(), s->at()[k].begin(), s->at()[k].end());
  }
  for (Axis& axis : all) sort_axis(axis);
  BoxComplex out(all);
  if (out.too_fine()) return out;
  if (sets.empty()) return BoxComplex({}, combine({}));
  std::vector<FineRows> fine;
  for (const BoxComplex* s : sets) fine.emplace_back(*s, all);
  Combined combined(sets.size(), combine);
  std::vector<Mark> marks(sets.size());
  for (int z = 0; z < out.cells(2); ++z) {
    for (int y = 0; y < out.cells(1); ++y) {
      bool other = y == 0;
      for (FineRows& set : fine) other |= set.go(y, z);
      if (other)
        overlay_row(fine, combined, marks, y, z, out);
      else
        out.repeat_row(y, z);
    }
  }
  return out;
}

BoxComplex united(std::span<const BoxComplex* const> sets) {
  if (std::any_of(sets.begin(), sets.end(), too_fine)) return BoxComplex::without_cells();
  std::vector<IntervalBox> boxes;
  for (const BoxComplex* s : sets) {
    for (IntervalBox& box : s->boxes()) boxes.push_back(std::move(box));
  }
  return BoxComplex::of_boxes(boxes);
}

BoxComplex mirrored(const BoxComplex& set) {
  if (set.too_fine()) return set;
  Axes at;
  for (int k = 0; k < 3; ++k) {
    for (auto it = set.at()[k].rbegin(); it != set.at()[k].rend(); ++it) at[k].push_back(-*it);
  }
  return set.reversed(std::move(at));
}

BoxComplex translated(const BoxComplex& set, const RealVector& by) {
  if (set.too_fine()) return set;
  Axes at = set.at();
  for (int k = 0; k < 3; ++k) {
    for (Real& c : at[k]) c += by[k];
  }
  return set.moved_to(std::move(at));
}

namespace {

/// Where along an axis the sums of two lists of intervals of cells lie: an interval of cells for each pair.
class SummedAxis {
 public:
  SummedAxis(const BoxComplex& a, std::span<const CellRange> of_a, const BoxComplex& b, std::span<const CellRange> of_b,
             int k)
      : k_(std::size_t(k)), last_a_(a.cells(k) - 1), last_b_(b.cells(k) - 1), width_(b.at()[k_].size()) {
    for (const int side : {0, 1}) {
      const std::vector<int> ends_a = ends(of_a, side, last_a_), ends_b = ends(of_b, side, last_b_);
      for (const int p : ends_a) {
        for (const int q : ends_b) sums_.push_back({a.at()[k_][std::size_t(p)] + b.at()[k_][std::size_t(q)], p, q});
      }
    }
    std::sort(sums_.begin(), sums_.end(), [](const Sum& s, const Sum& t) { return s.at < t.at; });
    cells_.resize(a.at()[k_].size() * width_);
    for (const Sum& s : sums_) {
      if (axis_.empty() || axis_.back() < s.at) axis_.push_back(s.at);
      cells_[std::size_t(s.a) * width_ + std::size_t(s.b)] = 2 * static_cast<int>(axis_.size()) - 1;
    }
  }
  const Axis& axis() const { return axis_; }

  std::array<int, 2> sum(const CellRange& a, const CellRange& b) const {
    const auto& [from_a, to_a] = a[k_];
    const auto& [from_b, to_b] = b[k_];
    std::array<int, 2> out{0, 2 * static_cast<int>(axis_.size())};
    if (from_a > 0 && from_b > 0)
      out[0] = cell((from_a - 1) / 2, (from_b - 1) / 2) + (from_a % 2 == 1 && from_b % 2 == 1 ? 0 : 1);
    if (to_a < last_a_ && to_b < last_b_) out[1] = cell(to_a / 2, to_b / 2) - (to_a % 2 == 1 && to_b % 2 == 1 ? 0 : 1);
    return out;
  }

 private:
  struct Sum {
    Real at;
    int a, b;  // the numbers of the coordinates
  };

  int cell(int p, int q) const { return cells_[std::size_t(p) * width_ + std::size_t(q)]; }

  /// The coordinates at which ranges begin, or end, each once.
  std::vector<int> ends(std::span<const CellRange> ranges, int side, int last) const {
    std::vector<int> out;
    for (const CellRange& r : ranges) {
      const int c = r[k_][std::size_t(side)];
      if (side == 0 ? c > 0 : c < last) out.push_back(side == 0 ? (c - 1) / 2 : c / 2);
    }
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
  }

  std::size_t k_;
  int last_a_, last_b_;
  std::size_t width_;
  std::vector<Sum> sums_;
  Axis axis_;
  std::vector<int> cells_;  // of the sum of a coordinate of one with one of the other
};

}  // namespace

BoxComplex sum(const BoxComplex& a, const BoxComplex& b) {
  if (a.too_fine() || b.too_fine()) return BoxComplex::without_cells();
  const std::vector<CellRange> of_a = a.ranges(), of_b = b.ranges();
  const auto along = [&](int k) { return SummedAxis(a, of_a, b, of_b, k); };
  const std::array<SummedAxis, 3> axes{along(0), along(1), along(2)};
  BoxComplex out({axes[0].axis(), axes[1].axis(), axes[2].axis()});
  if (out.too_fine()) return out;
  for (const CellRange& p : of_a) {
    for (const CellRange& q : of_b) out.paint({axes[0].sum(p, q), axes[1].sum(p, q), axes[2].sum(p, q)}, 1);
  }
  return out;
}

std::optional<RealVector> nearest(std::span<const IntervalBox> boxes, const RealVector& p) {
  std::optional<RealVector> best;
  Real least;
  for (const IntervalBox& box : boxes) {
    RealVector q = p;
    for (int k = 0; k < 3; ++k) {
      if (box[k].from && q[k] < *box[k].from) q[k] = *box[k].from;
      if (box[k].to && *box[k].to < q[k]) q[k] = *box[k].to;
    }
    const RealVector off = minus(q, p);
    const Real square = dot(off, off);
    if (best && !(square < least)) continue;
    best = q;
    least = square;
  }
  return best;
}

std::optional<RealVector> farthest(std::span<const IntervalBox> boxes, const RealVector& p) {
  std::optional<RealVector> best;
  Real most;
  for (const IntervalBox& box : boxes) {
    RealVector q;
    for (int k = 0; k < 3; ++k) {
      if (!box[k].from || !box[k].to) return std::nullopt;
      q[k] = *box[k].to - p[k] < p[k] - *box[k].from ? *box[k].from : *box[k].to;
    }
    const RealVector off = minus(q, p);
    const Real square = dot(off, off);
    if (best && !(most < square)) continue;
    best = q;
    most = square;
  }
  return best;
}

}  // namespace findspace::space
