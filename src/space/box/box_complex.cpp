// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/box/box_complex.h"

#include <algorithm>
#include <cassert>

namespace findspace::space {

using exact::Real;

void sort_axis(Axis& axis) {
  std::sort(axis.begin(), axis.end());
  axis.erase(std::unique(axis.begin(), axis.end()), axis.end());
}

BoxComplex::BoxComplex(Axes at, Mark mark) : at_(std::move(at)) {
  double count = 1;
  for (int k = 0; k < 3; ++k) count *= cells(k);
  too_fine_ = count > static_cast<double>(kMostCells);
  if (too_fine_) {
    at_ = {};
    count = 1;
    mark = 0;
  }
  marks_.assign(static_cast<std::size_t>(count), mark);
}

BoxComplex::BoxComplex(Axes at, std::vector<Mark> marks) : at_(std::move(at)), marks_(std::move(marks)) {
  assert(marks_.size() ==
         static_cast<std::size_t>(cells(0)) * static_cast<std::size_t>(cells(1)) * static_cast<std::size_t>(cells(2)));
}

BoxComplex BoxComplex::without_cells() {
  BoxComplex out;
  out.too_fine_ = true;
  return out;
}

exact::Tried<BoxComplex> BoxComplex::checked() && {
  if (too_fine_) return exact::Refusal("the boxes have too many different coordinates for an exact map");
  return std::move(*this);
}

BoxComplex BoxComplex::of_boxes(std::span<const IntervalBox> boxes) {
  Axes at;
  for (const IntervalBox& box : boxes) {
    for (int k = 0; k < 3; ++k) {
      if (box[k].from) at[k].push_back(*box[k].from);
      if (box[k].to) at[k].push_back(*box[k].to);
    }
  }
  for (Axis& axis : at) sort_axis(axis);
  BoxComplex set(std::move(at));
  if (set.too_fine_) return set;
  for (const IntervalBox& box : boxes) set.paint(box, 1);
  return set;
}

int BoxComplex::cell_of(int k, const Real& c) const {
  const auto it = std::lower_bound(at_[k].begin(), at_[k].end(), c);
  const int before = static_cast<int>(it - at_[k].begin());
  return it != at_[k].end() && *it == c ? 2 * before + 1 : 2 * before;
}

std::array<int, 2> BoxComplex::range(int k, const Interval& i) const {
  const int from = i.from ? cell_of(k, *i.from) + (i.from_in ? 0 : 1) : 0;
  const int to = i.to ? cell_of(k, *i.to) - (i.to_in ? 0 : 1) : cells(k) - 1;
  return {from, to};
}

Mark BoxComplex::mark(const RealVector& p) const { return mark(cell_of(0, p[0]), cell_of(1, p[1]), cell_of(2, p[2])); }

void BoxComplex::paint(const IntervalBox& box, Mark mark) {
  const auto x = range(0, box[0]), y = range(1, box[1]), z = range(2, box[2]);
  if (x[1] < x[0]) return;
  for (int k = z[0]; k <= z[1]; ++k) {
    for (int j = y[0]; j <= y[1]; ++j) {
      const auto first = marks_.begin() + static_cast<std::ptrdiff_t>(index(x[0], j, k));
      std::fill(first, first + (x[1] - x[0] + 1), mark);
    }
  }
}

/// A coordinate goes where the slabs on both its sides and itself agree.
BoxComplex BoxComplex::simplified() const {
  if (too_fine_) return *this;
  Axes kept;
  for (int k = 0; k < 3; ++k) {
    for (int c = 1; c < cells(k); c += 2) {
      bool same = true;
      const int a = (k + 1) % 3, b = (k + 2) % 3;
      for (int i = 0; same && i < cells(a); ++i) {
        for (int j = 0; same && j < cells(b); ++j) {
          std::array<int, 3> at{};
          at[a] = i;
          at[b] = j;
          at[k] = c;
          const Mark here = mark(at[0], at[1], at[2]);
          at[k] = c - 1;
          same = mark(at[0], at[1], at[2]) == here;
          at[k] = c + 1;
          same = same && mark(at[0], at[1], at[2]) == here;
        }
      }
      if (!same) kept[k].push_back(at_[k][static_cast<std::size_t>(c / 2)]);
    }
  }
  BoxComplex out(kept);
  std::array<std::vector<int>, 3> from;
  for (int k = 0; k < 3; ++k) {
    for (int c = 0; c < out.cells(k); ++c) {
      const std::size_t i = static_cast<std::size_t>(c / 2);
      from[k].push_back(c % 2 == 1 ? cell_of(k, out.at_[k][i]) : c == 0 ? 0 : cell_of(k, out.at_[k][i - 1]) + 1);
    }
  }
  for (int z = 0; z < out.cells(2); ++z) {
    for (int y = 0; y < out.cells(1); ++y) {
      for (int x = 0; x < out.cells(0); ++x)
        out.marks_[out.index(x, y, z)] =
            mark(from[0][std::size_t(x)], from[1][std::size_t(y)], from[2][std::size_t(z)]);
    }
  }
  return out;
}

BoxComplex BoxComplex::remarked(const std::function<Mark(Mark)>& to) const {
  BoxComplex out = *this;
  if (too_fine_) return out;
  for (Mark& m : out.marks_) m = to(m);
  return out;
}

Interval BoxComplex::interval(int k, int from, int to) const {
  Interval i;
  i.from_in = from % 2 == 1;
  i.to_in = to % 2 == 1;
  if (from > 0) i.from = at_[k][static_cast<std::size_t>((from - 1) / 2)];
  if (to < cells(k) - 1) i.to = at_[k][static_cast<std::size_t>(to / 2)];
  return i;
}

std::vector<IntervalBox> BoxComplex::boxes() const {
  assert(!too_fine_);
  std::vector<IntervalBox> out;
  std::vector<char> done(marks_.size(), 0);
  const auto free = [&](int x, int y, int z) { return marks_[index(x, y, z)] != 0 && done[index(x, y, z)] == 0; };
  for (int z = 0; z < cells(2); ++z) {
    for (int y = 0; y < cells(1); ++y) {
      for (int x = 0; x < cells(0); ++x) {
        if (!free(x, y, z)) continue;
        int x1 = x, y1 = y, z1 = z;
        while (x1 + 1 < cells(0) && free(x1 + 1, y, z)) ++x1;
        const auto row = [&](int j, int k) {
          for (int i = x; i <= x1; ++i) {
            if (!free(i, j, k)) return false;
          }
          return true;
        };
        while (y1 + 1 < cells(1) && row(y1 + 1, z)) ++y1;
        const auto slab = [&](int k) {
          for (int j = y; j <= y1; ++j) {
            if (!row(j, k)) return false;
          }
          return true;
        };
        while (z1 + 1 < cells(2) && slab(z1 + 1)) ++z1;
        for (int k = z; k <= z1; ++k) {
          for (int j = y; j <= y1; ++j) {
            for (int i = x; i <= x1; ++i) done[index(i, j, k)] = 1;
          }
        }
        out.push_back({interval(0, x, x1), interval(1, y, y1), interval(2, z, z1)});
      }
    }
  }
  return out;
}

bool BoxComplex::empty() const {
  assert(!too_fine_);
  return std::all_of(marks_.begin(), marks_.end(), [](Mark m) { return m == 0; });
}

}  // namespace findspace::space
