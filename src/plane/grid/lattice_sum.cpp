// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/grid/lattice_sum.h"

#include <algorithm>
#include <bit>
#include <optional>
#include <vector>

#include "plane/base/parallel.h"

namespace findspace::plane {
namespace {

using Two [[gnu::vector_size(16), gnu::aligned(8), gnu::may_alias]] = std::uint64_t;

/// Words first to last of to |= from << up.
inline void or_shifted(std::uint64_t* to, const std::uint64_t* from, std::int64_t first, std::int64_t last,
                       unsigned up) {
  const unsigned down = 63 - up;  // by one more, in two steps, so that it may be by 64
  std::int64_t k = first;
  for (; k < last; k += 2) {
    Two low = *reinterpret_cast<const Two*>(from + k - 1), high = *reinterpret_cast<const Two*>(from + k);
    *reinterpret_cast<Two*>(to + k) |= high << up | low >> down >> 1;
  }
  if (k == last) to[k] |= from[k] << up | from[k - 1] >> down >> 1;
}

constexpr std::size_t kManyRows = 200, kManyRuns = 200;  // of the sum, of points: from here on rows are made at once

std::int64_t longest(std::span<const LatticeRun> runs) {
  std::int64_t most = 0;
  for (const LatticeRun& r : runs) most = std::max(most, r.last - r.first + 1);
  return most;
}

/// Cells and, for every power of two up to a length, as many cells less one more to the right of each.
class WidenedCells {
 public:
  WidenedCells(std::span<const LatticeRun> cells, std::int64_t length)
      : box_(LatticeBox::around(cells)), used_(std::size_t(box_.row1 - box_.row0 + 1)) {
    Bitmap narrow(box_);
    for (const LatticeRun& c : cells) {
      narrow.add(c);
      Columns& used = used_[std::size_t(c.row - box_.row0)];
      if (used.first <= used.last) used.gap = std::max(used.gap, c.first - used.last - 1);
      used.first = std::min(used.first, c.first);
      used.last = std::max(used.last, c.last);
    }
    widened_.push_back(std::move(narrow));
    for (std::int64_t width = 1; 2 * width <= length; width *= 2) widen(width);
  }

  struct Columns {
    std::int64_t first = INT64_MAX, last = INT64_MIN;
    std::int64_t gap = 0;  // the most columns that lie free between them
  };
  const LatticeBox& box() const { return box_; }
  /// Of a row; none if its last is below its first.
  const Columns& used(std::int64_t row) const { return used_[std::size_t(row - box_.row0)]; }
  /// And 2^k - 1 more to the right of each.
  const Bitmap& widened(int k) const { return widened_[std::size_t(k)]; }

 private:
  void widen(std::int64_t width) {
    const Bitmap& from = widened_.back();
    LatticeBox box = from.box();
    box.column1 += width;
    Bitmap next(box);
    for (std::int64_t r = box.row0; r <= box.row1; ++r) {
      or_shifted(next.line(r), from.line(r), 0, from.words() - 1, 0);
      or_shifted(next.line(r) + width / 64, from.line(r), 0, from.words() - 1, unsigned(width % 64));
    }
    widened_.push_back(std::move(next));
  }

  LatticeBox box_;
  std::vector<Columns> used_;
  std::vector<Bitmap> widened_;
};

/// A run of points as two of a power of two, maybe the same, and the cells widened by it.
struct Step {
  std::int64_t first, last, second;  // columns; the second of the two starts at `second`
  std::int64_t grown;                // by so much
  const Bitmap* cells;
};

/// One row of the sum. A long stretch of it is known to be filled and is written last, as most of what is added lies in
/// it or makes it longer.
class RowOfSums {
 public:
  RowOfSums(const WidenedCells& cells, Bitmap& to, std::int64_t row)
      : cells_(cells), to_(to.line(row)), words_(to.words()), column0_(to.box().column0) {
    note_full();
  }
  ~RowOfSums() { fill(full_); }
  RowOfSums(const RowOfSums&) = delete;
  RowOfSums& operator=(const RowOfSums&) = delete;

  /// Adds a row of cells, moved by a row of points.
  void add(std::span<const Step> points, std::int64_t row) {
    const auto& used = cells_.used(row);
    if (used.last < used.first) return;
    const std::int64_t first = used.first - column0_, end = used.last + 1 - column0_;
    auto from = points.end(), till = from;  // those between add nothing
    if (full_.first < full_.end) {
      const std::int64_t low = full_.first - first, high = full_.end - end;
      from = std::partition_point(points.begin(), points.end(), [&](const Step& p) { return p.first < low; });
      till = std::partition_point(from, points.end(), [&](const Step& p) { return p.last <= high; });
    }
    const auto add_step = [&](const Step& p) {
      if (p.last - p.first >= used.gap)
        add_run({p.first + first, p.last + end});
      else
        add(p, row, used);
    };
    for (auto p = points.begin(); p != from; ++p) add_step(*p);
    for (auto p = till; p != points.end(); ++p) add_step(*p);
    if (done_ > kRowsOfWork * words_) note_full();
  }

 private:
  /// Words or columns of the row.
  struct Stretch {
    std::int64_t first, end;
    std::int64_t size() const { return end - first; }
  };
  static constexpr std::int64_t kRowsOfWork = 4;  // before the words that are all ones are looked for again

  void add_run(Stretch columns) {
    if (columns.first <= full_.end && full_.first <= columns.end) {
      full_ = {std::min(full_.first, columns.first), std::max(full_.end, columns.end)};
      return;
    }
    if (columns.size() > full_.size()) std::swap(columns, full_);
    fill(columns);
  }

  void fill(const Stretch& columns) {
    if (columns.first >= columns.end) return;
    const std::int64_t first = columns.first / 64, last = (columns.end - 1) / 64;
    const std::uint64_t from = ~0ull << (columns.first % 64), till = ~0ull >> (63 - (columns.end - 1) % 64);
    if (first == last) {
      to_[first] |= from & till;
    } else {
      to_[first] |= from;
      std::fill(to_ + first + 1, to_ + last, ~0ull);
      to_[last] |= till;
    }
    done_ += last - first + 1;
  }

  void add(const Step& p, std::int64_t row, const WidenedCells::Columns& used) {
    const std::int64_t column0 = cells_.box().column0;
    const Stretch of_cells{(used.first - column0) >> 6, ((used.last + p.grown - column0) >> 6) + 2};
    const std::uint64_t* from = p.cells->line(row);
    add(from, of_cells, column0 + p.first - column0_);
    if (p.second != p.first) add(from, of_cells, column0 + p.second - column0_);
  }

  void add(const std::uint64_t* from, const Stretch& words, std::int64_t shift) {
    Stretch full{(full_.first + 63) / 64, full_.end / 64};
    if (full.first >= full.end) full = {0, 0};
    const std::int64_t base = shift >> 6, first = std::max(words.first, full.end - base);
    const unsigned up = unsigned(shift & 63);
    or_shifted(to_ + base, from, first, words.end - 1, up);
    if (first > words.first) or_shifted(to_ + base, from, words.first, std::min(words.end, full.first - base) - 1, up);
    done_ += words.size();
  }

  /// The longest stretch.
  void note_full() {
    fill(full_);
    Stretch words{0, 0};
    for (std::int64_t k = 0, first = 0; k < words_; ++k) {
      if (~to_[k] != 0) first = k + 1;
      if (k + 1 - first > words.size()) words = {first, k + 1};
    }
    if (64 * words.size() > full_.size()) full_ = {64 * words.first, 64 * words.end};
    done_ = 0;
  }

  const WidenedCells& cells_;
  std::uint64_t* to_;
  const std::int64_t words_, column0_;
  Stretch full_{0, 0};     // columns
  std::int64_t done_ = 0;  // words, since these were looked for
};

struct RowOfPoints {
  std::int64_t row;
  std::span<const Step> steps;
};

std::vector<Step> steps(std::span<const LatticeRun> points, const WidenedCells& cells) {
  std::vector<Step> out;
  out.reserve(points.size());
  for (const LatticeRun& p : points) {
    const int k = std::bit_width(std::uint64_t(p.last - p.first + 1)) - 1;
    const std::int64_t width = std::int64_t(1) << k;
    out.push_back({p.first, p.last, p.last + 1 - width, width - 1, &cells.widened(k)});
  }
  return out;
}

/// Those of all parts of the set early, so that the middle of the sum fills early.
std::vector<RowOfPoints> scattered_rows(std::span<const LatticeRun> points, std::span<const Step> steps) {
  constexpr std::size_t kStride = 16;
  std::vector<RowOfPoints> rows, out;
  for (std::size_t k = 0, first = 0; k < points.size(); ++k) {
    if (k + 1 < points.size() && points[k + 1].row == points[first].row) continue;
    rows.push_back({points[first].row, steps.subspan(first, k + 1 - first)});
    first = k + 1;
  }
  out.reserve(rows.size());
  for (std::size_t start = 0; start < kStride; ++start)
    for (std::size_t k = start; k < rows.size(); k += kStride) out.push_back(rows[k]);
  return out;
}

/// What the rows of a sum are made of.
class Terms {
 public:
  explicit Terms(const LatticeSum& sum)
      : widened_(sum.cells, longest(sum.points)),
        steps_(steps(sum.points, widened_)),
        rows_(scattered_rows(sum.points, steps_)) {}
  Terms(const Terms&) = delete;
  Terms& operator=(const Terms&) = delete;

  void add_row(Bitmap& to, std::int64_t row) const {
    const LatticeBox& box = widened_.box();
    RowOfSums sums(widened_, to, row);
    for (const RowOfPoints& p : rows_)
      if (box.row0 <= row - p.row && row - p.row <= box.row1) sums.add(p.steps, row - p.row);
  }

 private:
  WidenedCells widened_;
  std::vector<Step> steps_;
  std::vector<RowOfPoints> rows_;
};

}  // namespace

void add_sums(std::span<const LatticeSum> sums, Bitmap& to) {
  std::size_t points = 0;
  for (const LatticeSum& sum : sums) points += sum.points.size();
  const std::size_t many_rows = points < kManyRuns ? SIZE_MAX : kManyRows;
  const auto count = std::size_t(to.box().row1 - to.box().row0 + 1);
  std::vector<std::optional<Terms>> terms(sums.size());
  at_once(sums.size(), count, many_rows, [&](std::size_t k) { terms[k].emplace(sums[k]); });
  in_ranges(count, many_rows, [&](IndexRange some) {
    for (std::size_t k = some.first; k < some.end; ++k)
      for (const std::optional<Terms>& t : terms) t->add_row(to, to.box().row0 + std::int64_t(k));
  });
}

}  // namespace findspace::plane
