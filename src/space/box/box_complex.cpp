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
    mark = 0;
  }
  in_ = CellBits(cell_counts());
  if (mark != 0) in_.turn();
  if (mark < 0) negative_ = in_;
}

BoxComplex::BoxComplex(Axes at, CellBits in) : at_(std::move(at)), in_(std::move(in)) {
  assert(in_.cells(0) == cells(0) && in_.cells(1) == cells(1) && in_.cells(2) == cells(2));
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

int BoxComplex::run_end(int x, int y, int z) const {
  const ConstBitRow row = in_.row(y, z);
  const bool marked = bit(row, x);
  const int end = next_bit(row, x, cells(0), !marked);
  if (!marked || !has_negative()) return end;
  const ConstBitRow below = negative_.row(y, z);
  return next_bit(below, x, end, !bit(below, x));
}

void BoxComplex::mark_run(int y, int z, int from, int to, Mark mark) {
  assert(mark >= -1 && mark <= 1);
  in_.fill(y, z, from, to, mark != 0);
  if (mark < 0 && !has_negative()) negative_ = CellBits(cell_counts());
  if (has_negative()) negative_.fill(y, z, from, to, mark < 0);
}

void BoxComplex::repeat_row(int y, int z) {
  const auto repeat = [&](CellBits& bits) {
    const BitRow before = bits.row(y - 1, z);
    std::copy(before.begin(), before.end(), bits.row(y, z).begin());
  };
  repeat(in_);
  if (has_negative()) repeat(negative_);
}

void BoxComplex::paint(const CellRange& cells, Mark mark) {
  const auto& [x, y, z] = cells;
  if (x[1] < x[0]) return;
  for (int k = z[0]; k <= z[1]; ++k) {
    for (int j = y[0]; j <= y[1]; ++j) mark_run(j, k, x[0], x[1] + 1, mark);
  }
}

void BoxComplex::paint(const IntervalBox& box, Mark mark) {
  paint(CellRange{range(0, box[0]), range(1, box[1]), range(2, box[2])}, mark);
}

namespace {

/// The bits in which a word of a row differs from those one place to the left of them.
std::uint64_t changes(ConstBitRow row, std::size_t word) {
  const std::uint64_t before = word == 0 ? row[0] & 1 : row[word - 1] >> (kWordBits - 1);
  return row[word] ^ (row[word] << 1 | before);
}

/// Of a cell along an axis and the one before it the odd one.
std::size_t odd_of(int cell) { return static_cast<std::size_t>(cell % 2 == 0 ? cell - 1 : cell); }

/// Into `needed`: the odd cells along the axes where those beside them have other bits.
void add_needed(const CellBits& bits, std::array<std::vector<char>, 3>& needed) {
  const auto differ = [&](int y, int z, int v, int w) {
    const ConstBitRow a = bits.row(y, z), b = bits.row(v, w);
    return !std::equal(a.begin(), a.end(), b.begin());
  };
  std::vector<std::uint64_t> along(bits.row(0, 0).size(), 0);
  for (int z = 0; z < bits.cells(2); ++z) {
    for (int y = 0; y < bits.cells(1); ++y) {
      const ConstBitRow row = bits.row(y, z);
      for (std::size_t k = 0; k < along.size(); ++k) along[k] |= changes(row, k);
      if (y > 0 && needed[1][odd_of(y)] == 0 && differ(y, z, y - 1, z)) needed[1][odd_of(y)] = 1;
      if (z > 0 && needed[2][odd_of(z)] == 0 && differ(y, z, y, z - 1)) needed[2][odd_of(z)] = 1;
    }
  }
  for (int x = 1; x < bits.cells(0); ++x) {
    if (bit(along, x)) needed[0][odd_of(x)] = 1;
  }
}

}  // namespace

/// A coordinate where the slabs on its sides and itself do not agree.
std::array<std::vector<char>, 3> BoxComplex::needed() const {
  std::array<std::vector<char>, 3> out;
  for (std::size_t k = 0; k < 3; ++k) out[k].assign(static_cast<std::size_t>(cells(static_cast<int>(k))) + 1, 0);
  add_needed(in_, out);
  if (has_negative()) add_needed(negative_, out);
  return out;
}

std::vector<int> first_cells(const std::vector<int>& from, int cells) {
  std::vector<int> out;
  for (int c = 0; c <= cells; ++c)
    out.push_back(static_cast<int>(std::lower_bound(from.begin(), from.end(), c) - from.begin()));
  return out;
}

BoxComplex BoxComplex::simplified() const {
  if (too_fine_) return *this;
  const std::array<std::vector<char>, 3> needed = this->needed();
  Axes kept;
  CellNumbers from;
  for (std::size_t k = 0; k < 3; ++k) {
    from[k].push_back(0);
    for (int c = 1; c < cells(static_cast<int>(k)); c += 2) {
      if (needed[k][std::size_t(c)] == 0) continue;
      kept[k].push_back(at_[k][static_cast<std::size_t>(c / 2)]);
      from[k].push_back(c);
      from[k].push_back(c + 1);
    }
  }
  if (kept[0].size() == at_[0].size() && kept[1].size() == at_[1].size() && kept[2].size() == at_[2].size())
    return *this;
  const std::vector<int> first = first_cells(from[0], cells(0));
  BoxComplex out(std::move(kept));
  for (int z = 0; z < out.cells(2); ++z) {
    for (int y = 0; y < out.cells(1); ++y) {
      const int j = from[1][std::size_t(y)], k = from[2][std::size_t(z)];
      for (int x = 0, end = 0; x < cells(0); x = end) {
        end = run_end(x, j, k);
        if (const Mark m = mark(x, j, k); m != 0) out.mark_run(y, z, first[std::size_t(x)], first[std::size_t(end)], m);
      }
    }
  }
  return out;
}

BoxComplex BoxComplex::reversed(Axes at) const {
  BoxComplex out(std::move(at));
  for (int z = 0; z < cells(2); ++z) {
    for (int y = 0; y < cells(1); ++y) {
      for (int x = 0, end = 0; x < cells(0); x = end) {
        end = run_end(x, y, z);
        if (const Mark m = mark(x, y, z); m != 0)
          out.mark_run(cells(1) - 1 - y, cells(2) - 1 - z, cells(0) - end, cells(0) - x, m);
      }
    }
  }
  return out;
}

BoxComplex BoxComplex::moved_to(Axes at) const {
  BoxComplex out = *this;
  out.at_ = std::move(at);
  return out;
}

BoxComplex BoxComplex::remarked(const std::function<Mark(Mark)>& to) const {
  BoxComplex out = *this;
  if (too_fine_) return out;
  const Mark below = to(-1), none = to(0), above = to(1);
  const auto all_if = [](bool belongs) { return belongs ? ~std::uint64_t{0} : std::uint64_t{0}; };
  CellBits rest = in_, negative(cell_counts());
  rest.turn();
  std::uint64_t any = 0;
  for (std::size_t k = 0; k < in_.words().size(); ++k) {
    const std::uint64_t zero = rest.words()[k], minus = has_negative() ? negative_.words()[k] : 0,
                        plus = in_.words()[k] & ~minus;
    const auto joined = [&](auto belongs) {
      return (minus & all_if(belongs(below))) | (zero & all_if(belongs(none))) | (plus & all_if(belongs(above)));
    };
    out.in_.words()[k] = joined([](Mark m) { return m != 0; });
    negative.words()[k] = joined([](Mark m) { return m < 0; });
    any |= negative.words()[k];
  }
  out.negative_ = any != 0 ? std::move(negative) : CellBits();
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

std::vector<CellRange> BoxComplex::ranges() const {
  assert(!too_fine_);
  std::vector<CellRange> out;
  CellBits free = in_;
  for (int z = 0; z < cells(2); ++z) {
    for (int y = 0; y < cells(1); ++y) {
      for (int x = 0; (x = next_bit(free.row(y, z), x, cells(0), true)) < cells(0);) {
        const int end = next_bit(free.row(y, z), x, cells(0), false);
        int y1 = y, z1 = z;
        while (y1 + 1 < cells(1) && free.full(y1 + 1, z, x, end)) ++y1;
        const auto slab = [&](int k) {
          for (int j = y; j <= y1; ++j) {
            if (!free.full(j, k, x, end)) return false;
          }
          return true;
        };
        while (z1 + 1 < cells(2) && slab(z1 + 1)) ++z1;
        for (int k = z; k <= z1; ++k) {
          for (int j = y; j <= y1; ++j) free.fill(j, k, x, end, false);
        }
        out.push_back({{{x, end - 1}, {y, y1}, {z, z1}}});
      }
    }
  }
  return out;
}

std::vector<IntervalBox> BoxComplex::boxes() const {
  std::vector<IntervalBox> out;
  for (const auto& [x, y, z] : ranges())
    out.push_back({interval(0, x[0], x[1]), interval(1, y[0], y[1]), interval(2, z[0], z[1])});
  return out;
}

bool BoxComplex::empty() const {
  assert(!too_fine_);
  return std::all_of(in_.words().begin(), in_.words().end(), [](std::uint64_t w) { return w == 0; });
}

}  // namespace findspace::space
