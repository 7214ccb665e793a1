// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/box/box_summary.h"

#include <algorithm>
#include <span>

#include "space/box/box_topology.h"

namespace findspace::space {

using exact::Real;

namespace {

/// The cells of a set (or of its complement) with their components, by runs of cells along x.
class Components {
 public:
  struct Run {
    int from, to;  // its first and last cell
    int component;
  };

  Components(const BoxComplex& set, bool of_set) : set_(set) {
    CellBits cells = set.in();
    if (!of_set) cells.turn();
    find_runs(cells);
    for (int z = 0; z < set.cells(2); ++z) {
      for (int y = 0; y < set.cells(1); ++y) join_around(y, z);
    }
    number();
  }
  int count() const { return static_cast<int>(unbounded_.size()); }
  int bounded_count() const { return static_cast<int>(std::count(unbounded_.begin(), unbounded_.end(), 0)); }
  std::span<const Run> row(int y, int z) const {
    const std::size_t k = row_number(y, z);
    return std::span(runs_).subspan(starts_[k], starts_[k + 1] - starts_[k]);
  }

 private:
  std::size_t row_number(int y, int z) const {
    return static_cast<std::size_t>(z) * static_cast<std::size_t>(set_.cells(1)) + static_cast<std::size_t>(y);
  }

  void find_runs(const CellBits& cells) {
    for (int z = 0; z < cells.cells(2); ++z) {
      for (int y = 0; y < cells.cells(1); ++y) {
        starts_.push_back(runs_.size());
        const ConstBitRow row = cells.row(y, z);
        for (int x = 0; (x = next_bit(row, x, cells.cells(0), true)) < cells.cells(0);) {
          const int end = next_bit(row, x, cells.cells(0), false);
          runs_.push_back({x, end - 1, static_cast<int>(runs_.size())});
          x = end;
        }
      }
    }
    starts_.push_back(runs_.size());
  }

  /// A run to those that lie in its closure in other rows: around it along the axes in which its row is of open
  /// intervals.
  void join_around(int y, int z) {
    const int ry = y % 2 == 0 ? 1 : 0, rz = z % 2 == 0 ? 1 : 0;
    for (int dz = -rz; dz <= rz; ++dz) {
      for (int dy = -ry; dy <= ry; ++dy) {
        const int v = y + dy, w = z + dz;
        if ((dy != 0 || dz != 0) && v >= 0 && v < set_.cells(1) && w >= 0 && w < set_.cells(2))
          join_rows(row_number(y, z), row_number(v, w));
      }
    }
  }

  /// Those of a row with those of another that lie in their closures.
  void join_rows(std::size_t larger, std::size_t smaller) {
    std::size_t j = starts_[smaller];
    for (std::size_t i = starts_[larger]; i < starts_[larger + 1]; ++i) {
      const Run& r = runs_[i];
      const int from = r.from - (r.from % 2 == 0 ? 1 : 0), to = r.to + (r.to % 2 == 0 ? 1 : 0);
      while (j < starts_[smaller + 1] && runs_[j].to < from) ++j;
      for (std::size_t k = j; k < starts_[smaller + 1] && runs_[k].from <= to; ++k)
        join(static_cast<int>(i), static_cast<int>(k));
    }
  }

  /// The first run known to be of its component; till number() a run's component is a run of it before, or itself.
  int root(int run) {
    while (true) {
      int& next = runs_[std::size_t(run)].component;
      if (next == run) return run;
      next = runs_[std::size_t(next)].component;
      run = next;
    }
  }
  void join(int a, int b) {
    a = root(a);
    b = root(b);
    runs_[std::size_t(std::max(a, b))].component = std::min(a, b);
  }

  /// Components by the order of their first cells.
  void number() {
    for (int z = 0; z < set_.cells(2); ++z) {
      for (int y = 0; y < set_.cells(1); ++y) {
        const std::size_t row = row_number(y, z);
        const bool at_end = y == 0 || y == set_.cells(1) - 1 || z == 0 || z == set_.cells(2) - 1;
        for (std::size_t k = starts_[row]; k < starts_[row + 1]; ++k) {
          Run& r = runs_[k];
          // One before has its number already.
          const bool first = r.component == static_cast<int>(k);
          r.component = first ? count() : runs_[std::size_t(r.component)].component;
          if (first) unbounded_.push_back(0);
          if (at_end || r.from == 0 || r.to == set_.cells(0) - 1) unbounded_[std::size_t(r.component)] = 1;
        }
      }
    }
  }

  const BoxComplex& set_;
  std::vector<Run> runs_;            // row by row
  std::vector<std::size_t> starts_;  // of each row, and one beyond the last
  std::vector<char> unbounded_;
};

int dimension(int x, int y, int z) { return 3 - x % 2 - y % 2 - z % 2; }

/// The size of a cell: volume, area, length, or 1; nothing where it is infinite.
std::optional<Real> size(const BoxComplex& set, const std::array<int, 3>& cell) {
  Real out(1);
  for (int k = 0; k < 3; ++k) {
    const int c = cell[std::size_t(k)];
    if (c % 2 == 1) continue;
    const Interval i = set.interval(k, c, c);
    if (!i.from || !i.to) return std::nullopt;
    out *= *i.to - *i.from;
  }
  return out;
}

/// A point of the cell: its middle, or a step from its finite end.
RealVector middle(const BoxComplex& set, const std::array<int, 3>& cell) {
  RealVector p;
  for (int k = 0; k < 3; ++k) {
    const Interval i = set.interval(k, cell[std::size_t(k)], cell[std::size_t(k)]);
    if (i.from && i.to)
      p[std::size_t(k)] = (*i.from + *i.to) / Real(2);
    else if (i.from)
      p[std::size_t(k)] = *i.from + Real(1);
    else if (i.to)
      p[std::size_t(k)] = *i.to - Real(1);
  }
  return p;
}

/// How long the cells along an axis are.
class CellLengths {
 public:
  explicit CellLengths(const Axis& at) : at_(at), length_(at.size() + 1) {
    for (std::size_t i = 1; i < at.size(); ++i) length_[i] = at[i] - at[i - 1];
    Axis sorted = length_;
    sort_axis(sorted);
    for (const Real& l : length_)
      rank_.push_back(static_cast<int>(std::lower_bound(sorted.begin(), sorted.end(), l) - sorted.begin()));
  }

  /// Of an open interval; 0 where it has no end.
  const Real& of(int cell) const { return length_[std::size_t(cell / 2)]; }
  /// Of all open intervals with two ends among the cells.
  Real sum(int from, int to) const {
    const int first = std::max((from + 1) / 2, 1), last = std::min(to / 2, static_cast<int>(at_.size()) - 1);
    return last < first ? Real() : at_[std::size_t(last)] - at_[std::size_t(first - 1)];
  }
  /// The first of the longest of the open intervals among the cells, of which there is one; those without an end are
  /// the shortest.
  int longest(int from, int to) const {
    const int first = (from + 1) / 2, last = to / 2;
    const auto it = std::max_element(rank_.begin() + first, rank_.begin() + last + 1);
    return 2 * static_cast<int>(it - rank_.begin());
  }

 private:
  const Axis& at_;
  std::vector<Real> length_;  // of each open interval
  std::vector<int> rank_;     // by their lengths
};

/// The sizes of the cells of a row along x: what y and z give to them.
struct RowOfCells {
  int y = 0, z = 0;
  int dimension = 0;  // of cells that are points along x
  bool bounded = true;
  Real size;  // of those; 0 where it is not bounded

  RowOfCells(const BoxComplex& set, const std::array<CellLengths, 3>& lengths, int row_y, int row_z)
      : y(row_y), z(row_z), dimension((y % 2 == 0) + (z % 2 == 0)), size(1) {
    bounded = y > 0 && y < set.cells(1) - 1 && z > 0 && z < set.cells(2) - 1;
    if (!bounded) size = Real();
    if (y % 2 == 0) size *= lengths[1].of(y);
    if (z % 2 == 0) size *= lengths[2].of(z);
  }
};

struct Exact {
  Real volume, dangling_area, dangling_length;
  bool any = false;
  int dimension = -1;
  Real sample_size;
  std::array<int, 3> sample{}, first{}, last{};  // first and last: cells along each axis
  bool bounded = true;

  /// A run of cells of the row.
  void add(const BoxComplex& set, const CellLengths& lengths, const RowOfCells& row, int from, int to) {
    if (row.dimension == 2 && row.bounded) volume += lengths.sum(from, to) * row.size;
    add_sample(lengths, row, from, to);
    bounded = bounded && row.bounded && from > 0 && to < set.cells(0) - 1;
    const std::array<int, 3> low{from, row.y, row.z}, high{to, row.y, row.z};
    for (std::size_t k = 0; k < 3; ++k) {
      first[k] = any ? std::min(first[k], low[k]) : low[k];
      last[k] = any ? std::max(last[k], high[k]) : high[k];
    }
    any = true;
  }

  /// All but the sample.
  void add(const Exact& part) {
    volume += part.volume;
    dangling_area += part.dangling_area;
    dangling_length += part.dangling_length;
    bounded = bounded && part.bounded;
    for (std::size_t k = 0; k < 3; ++k) {
      first[k] = any ? std::min(first[k], part.first[k]) : part.first[k];
      last[k] = any ? std::max(last[k], part.last[k]) : part.last[k];
    }
    any = true;
  }

 private:
  /// The sample lies in the largest of the cells of highest dimension.
  void add_sample(const CellLengths& lengths, const RowOfCells& row, int from, int to) {
    const bool long_cells = from % 2 == 0 || from < to;
    const int d = row.dimension + (long_cells ? 1 : 0);
    if (d < dimension) return;
    // Where none has a size it is the first one.
    const int x = !long_cells ? from : row.bounded ? lengths.longest(from, to) : from + from % 2;
    Real size = row.size;
    if (long_cells) size *= lengths.of(x);
    if (d == dimension && !(sample_size < size)) return;
    dimension = d;
    sample = {x, row.y, row.z};
    sample_size = std::move(size);
  }
};

class BoxSummarizer {
 public:
  BoxSummarizer(const BoxComplex& set, const Real& step)
      : set_(set),
        step_(step),
        open_(interior(set)),
        solid_(closure(open_)),
        closed_(closure(set)),
        full_(interior(closed_)),
        lengths_{CellLengths(set.at()[0]), CellLengths(set.at()[1]), CellLengths(set.at()[2])},
        parts_(set, true),
        each_(std::size_t(parts_.count())) {}

  SpaceSummary run() {
    for (int z = 0; z < set_.cells(2); ++z) {
      for (int y = 0; y < set_.cells(1); ++y) count_row(RowOfCells(set_, lengths_, y, z));
    }
    for (const Exact& part : each_) all_.add(part);
    out_.open = set_.in() == open_.in();
    out_.closed = set_.in() == closed_.in();
    out_.regular = set_.in() == solid_.in();
    out_.whole = complement(set_).empty();
    measure_cracks();
    out_.empty = !all_.any;
    out_.bounded = all_.bounded;
    if (all_.bounded) out_.volume = scaled_size(all_.volume, 3);
    out_.dangling_area = scaled_size(all_.dangling_area, 2);
    out_.dangling_length = scaled_size(all_.dangling_length, 1);
    out_.crack_area = scaled_size(crack_area_, 2);
    out_.crack_length = scaled_size(crack_length_, 1);
    out_.holes = Components(set_, false).bounded_count();
    if (all_.any) out_.bbox = box(all_);
    for (int c = 0; c < parts_.count(); ++c) add_component(each_[std::size_t(c)], c);
    std::stable_sort(out_.components.begin(), out_.components.end(), [](const auto& a, const auto& b) {
      return a.dimension != b.dimension ? a.dimension > b.dimension : a.sample < b.sample;
    });
    std::sort(out_.isolated.begin(), out_.isolated.end());
    return std::move(out_);
  }

 private:
  /// The cells of a row into the sums of their components.
  void count_row(const RowOfCells& row) {
    const ConstBitRow solid = solid_.in().row(row.y, row.z);
    for (const Components::Run& r : parts_.row(row.y, row.z)) {
      Exact& part = each_[std::size_t(r.component)];
      part.add(set_, lengths_[0], row, r.from, r.to);
      for (int x = r.from; (x = next_bit(solid, x, r.to + 1, false)) <= r.to; ++x)
        count_dangling({x, row.y, row.z}, part);
    }
  }

  /// A cell outside the closure of the interior.
  void count_dangling(const std::array<int, 3>& cell, Exact& sums) const {
    const int d = dimension(cell[0], cell[1], cell[2]);
    if ((d != 1 && d != 2) || borders_face(cell, true)) return;
    const auto s = size(set_, cell);
    if (s) (d == 2 ? sums.dangling_area : sums.dangling_length) += *s;
  }

  void measure_cracks() {
    CellBits cracks = full_.in();
    for (std::size_t k = 0; k < cracks.words().size(); ++k) cracks.words()[k] &= ~set_.in().words()[k];
    cracks.each([&](int x, int y, int z) {
      const auto s = size(set_, {x, y, z});
      if (s && dimension(x, y, z) == 2) crack_area_ += *s;
      if (s && dimension(x, y, z) == 1 && !borders_face({x, y, z}, false)) crack_length_ += *s;
    });
  }

  void add_component(const Exact& e, int id) {
    SpaceComponent c;
    c.dimension = e.dimension;
    if (e.bounded) c.volume = scaled_size(e.volume, 3);
    c.dangling_area = scaled_size(e.dangling_area, 2);
    c.dangling_length = scaled_size(e.dangling_length, 1);
    c.sample = place(middle(set_, e.sample));
    c.bbox = box(e);
    c.holes = e.dimension < 2 ? 0 : Components(alone(e, id), false).bounded_count();
    if (e.dimension == 0) out_.isolated.push_back(c.sample);
    out_.components.push_back(c);
  }

  /// The component on its part of the grid: what is beyond that is its complement, and unbounded.
  BoxComplex alone(const Exact& e, int id) const {
    std::array<int, 3> from{};  // an open interval, as the last one is
    Axes at;
    for (std::size_t k = 0; k < 3; ++k) {
      const Axis& all = set_.at()[k];
      from[k] = (e.first[k] - 1) / 2 * 2;
      const auto to = std::min(static_cast<std::size_t>(e.last[k]) / 2 + 1, all.size());
      at[k].assign(all.begin() + from[k] / 2, all.begin() + static_cast<std::ptrdiff_t>(to));
    }
    BoxComplex out(std::move(at));
    for (int z = 0; z < out.cells(2); ++z) {
      for (int y = 0; y < out.cells(1); ++y) {
        const std::span<const Components::Run> row = parts_.row(from[1] + y, from[2] + z);
        auto r = std::partition_point(row.begin(), row.end(), [&](const Components::Run& c) { return c.to < from[0]; });
        for (; r != row.end() && r->from < from[0] + out.cells(0); ++r) {
          if (r->component == id) out.mark_run(y, z, r->from - from[0], r->to + 1 - from[0], 1);
        }
      }
    }
    return out;
  }

  /// Whether the cell is an edge of a face that is in (or is not): then it adds nothing to the length of lines.
  bool borders_face(const std::array<int, 3>& cell, bool in) const {
    if (dimension(cell[0], cell[1], cell[2]) != 1) return false;
    for (std::size_t k = 0; k < 3; ++k) {
      if (cell[k] % 2 == 0) continue;
      for (const int d : {-1, 1}) {
        std::array<int, 3> face = cell;
        face[k] += d;
        if ((set_.mark(face[0], face[1], face[2]) != 0) == in) return true;
      }
    }
    return false;
  }

  double scaled_size(Real value, int power) const {
    for (int k = 0; k < power; ++k) value *= step_;
    return value.to_double();
  }
  Place3 place(const RealVector& p) const {
    return {(p[0] * step_).to_double(), (p[1] * step_).to_double(), (p[2] * step_).to_double()};
  }
  std::optional<PlaceBox> box(const Exact& e) const {
    if (!e.bounded) return std::nullopt;
    RealVector low, high;
    for (std::size_t k = 0; k < 3; ++k) {
      const Interval i = set_.interval(static_cast<int>(k), e.first[k], e.last[k]);
      low[k] = *i.from;
      high[k] = *i.to;
    }
    return PlaceBox{place(low), place(high)};
  }

  const BoxComplex& set_;
  const Real& step_;
  const BoxComplex open_, solid_, closed_, full_;  // interior, its closure; closure, its interior
  const std::array<CellLengths, 3> lengths_;
  const Components parts_;
  Exact all_;
  std::vector<Exact> each_;  // of each component
  Real crack_area_, crack_length_;
  SpaceSummary out_;
};

}  // namespace

SpaceSummary summarize(const BoxComplex& set, const Real& step) {
  const BoxComplex least = set.simplified();
  return BoxSummarizer(least, step).run();
}

}  // namespace findspace::space
