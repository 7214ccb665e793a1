// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/bitmap.h"

#include <algorithm>
#include <bit>

namespace findspace::plane {
namespace {

using Two [[gnu::vector_size(16), gnu::aligned(8), gnu::may_alias]] = std::uint64_t;

/// to |= from << shift, in a number of many words; from[-1] is 0.
void or_shifted(std::uint64_t* to, const std::uint64_t* from, std::int64_t words, std::int64_t shift) {
  to += shift / 64;
  unsigned up = unsigned(shift % 64), down = 63 - up;  // down by one more, in two steps, so that it may be by 64
  std::int64_t k = 0;
  for (; k + 1 <= words; k += 2) {
    Two low = *reinterpret_cast<const Two*>(from + k - 1), high = *reinterpret_cast<const Two*>(from + k);
    *reinterpret_cast<Two*>(to + k) |= high << up | low >> down >> 1;
  }
  if (k <= words) to[k] |= from[k] << up | from[k - 1] >> down >> 1;
}

}  // namespace

LatticeBox LatticeBox::around(std::span<const LatticeRun> runs) {
  LatticeBox box;
  for (const LatticeRun& r : runs) box.add({r.row, r.row, r.first, r.last});
  return box;
}

void LatticeBox::add(const LatticeBox& o) {
  row0 = std::min(row0, o.row0), row1 = std::max(row1, o.row1);
  column0 = std::min(column0, o.column0), column1 = std::max(column1, o.column1);
}

Bitmap::Bitmap(const LatticeBox& box)
    : box_(box),
      words_((box.column1 - box.column0) / 64 + 2),
      bits_(std::size_t((box.row1 - box.row0 + 1) * words_ + 1), 0) {}

void Bitmap::add(const LatticeRun& run) {
  std::uint64_t* to = line(run.row);
  std::int64_t first = run.first - box_.column0, last = run.last - box_.column0;
  for (std::int64_t w = first / 64; w <= last / 64; ++w) {
    std::uint64_t from = w == first / 64 ? ~0ull << (first % 64) : ~0ull;
    std::uint64_t till = w == last / 64 ? ~0ull >> (63 - last % 64) : ~0ull;
    to[w] |= from & till;
  }
}

void Bitmap::add(const Bitmap& other, std::int64_t rows, std::int64_t columns) {
  std::int64_t shift = other.box_.column0 + columns - box_.column0;
  for (std::int64_t r = other.box_.row0; r <= other.box_.row1; ++r)
    or_shifted(line(r + rows), other.line(r), other.words_ - 1, shift);
}

RunAdder::RunAdder(std::span<const LatticeRun> cells, std::int64_t longest) {
  LatticeBox box = LatticeBox::around(cells);
  Bitmap narrow(box);
  for (const LatticeRun& c : cells) narrow.add(c);
  widened_.push_back(std::move(narrow));
  for (std::int64_t width = 1; 2 * width <= longest; width *= 2) {
    LatticeBox wider = widened_.back().box();
    wider.column1 += width;
    Bitmap next(wider);
    next.add(widened_.back(), 0, 0);
    next.add(widened_.back(), 0, width);
    widened_.push_back(std::move(next));
  }
}

void RunAdder::add(const LatticeRun& points, Bitmap& to) const {
  auto count = std::uint64_t(points.last - points.first + 1);
  int k = std::bit_width(count) - 1;
  const Bitmap& widened = widened_[std::size_t(k)];
  to.add(widened, points.row, points.first);
  if (std::int64_t rest = points.last + 1 - (std::int64_t(1) << k); rest != points.first)
    to.add(widened, points.row, rest);
}

}  // namespace findspace::plane
