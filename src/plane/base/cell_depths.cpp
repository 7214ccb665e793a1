// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/base/cell_depths.h"

#include <algorithm>
#include <cstring>

namespace findspace::plane {

namespace {

constexpr std::int64_t kLanes = 16;
using Bytes [[gnu::vector_size(kLanes)]] = std::uint8_t;
using Words [[gnu::vector_size(kLanes)]] = std::uint64_t;

Bytes load(const std::uint8_t* from) {
  Bytes b;
  std::memcpy(&b, from, sizeof b);
  return b;
}
void store(std::uint8_t* to, const Bytes& b) { std::memcpy(to, &b, sizeof b); }

Bytes all(std::uint8_t value) { return Bytes{} + value; }
Bytes least(const Bytes& p, const Bytes& q) { return p < q ? p : q; }
Bytes most(const Bytes& p, const Bytes& q) { return p > q ? p : q; }
Bytes grown(const Bytes& depth) { return least(depth, all(254)) + 1; }
/// Of each cell the least of the three beside it in another row.
Bytes least_of_three(const std::uint8_t* row) { return least(least(load(row - 1), load(row)), load(row + 1)); }

/// 255 where a bit is set.
Bytes spread(std::uint64_t sixteen_bits) {
  constexpr std::uint64_t kEach = 0x0101010101010101;
  const Words both{(sixteen_bits & 255) * kEach, (sixteen_bits >> 8) * kEach};
  const Bytes bit{1, 2, 4, 8, 16, 32, 64, 128, 1, 2, 4, 8, 16, 32, 64, 128};
  return Bytes((Bytes(both) & bit) == bit);
}

// What follows counts from 255 downwards, so that cells moved in count nothing.

Bytes less(const Bytes& rest, const Bytes& by) { return most(rest, by) - by; }

/// Each cell as if it were at most one deeper than that to its left, `left` to the left of the first.
Bytes from_left(Bytes rest, std::uint8_t left) {
  const Bytes none{};
  const Bytes one = __builtin_shufflevector(none, rest, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30);
  rest = most(rest, less(one, all(1)));
  const Bytes two = __builtin_shufflevector(none, rest, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29);
  rest = most(rest, less(two, all(2)));
  const Bytes four =
      __builtin_shufflevector(none, rest, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27);
  rest = most(rest, less(four, all(4)));
  const Bytes eight = __builtin_shufflevector(none, rest, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23);
  rest = most(rest, less(eight, all(8)));
  return most(rest, less(all(left), Bytes{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16}));
}

Bytes from_right(Bytes rest, std::uint8_t right) {
  const Bytes none{};
  const Bytes one = __builtin_shufflevector(rest, none, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16);
  rest = most(rest, less(one, all(1)));
  const Bytes two = __builtin_shufflevector(rest, none, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17);
  rest = most(rest, less(two, all(2)));
  const Bytes four = __builtin_shufflevector(rest, none, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19);
  rest = most(rest, less(four, all(4)));
  const Bytes eight = __builtin_shufflevector(rest, none, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23);
  rest = most(rest, less(eight, all(8)));
  return most(rest, less(all(right), Bytes{16, 15, 14, 13, 12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1}));
}

}  // namespace

CellDepths::CellDepths(const Bitmap& cells) {
  const LatticeBox& box = cells.box();
  row0_ = box.row0;
  rows_ = box.row1 - box.row0 + 1;
  column0_ = box.column0;
  columns_ = box.column1 - box.column0 + 1;
  stride_ = (columns_ / kLanes + 1) * kLanes;
  depth_.resize(place(rows_ + 1, kLanes));
  // The chessboard distance to a cell that is not marked, by one pass from each corner; cells outside are not marked.
  for (std::int64_t r = 0; r < rows_; ++r) {
    const std::uint64_t* bits = cells.line(row0_ + r);
    std::uint8_t* const now = &depth_[place(r, 0)];
    std::uint8_t left = 255;
    for (std::int64_t c = 0; c < columns_; c += kLanes) {
      const Bytes marked = spread(bits[c / 64] >> (c % 64) & 0xffff);
      const Bytes rest = from_left(~(grown(least_of_three(now + c - stride_)) & marked), left);
      left = rest[kLanes - 1];
      store(now + c, ~rest);
    }
  }
  for (std::int64_t r = rows_; r-- > 0;) {
    std::uint8_t* const now = &depth_[place(r, 0)];
    std::uint8_t right = 255;
    for (std::int64_t c = stride_ - kLanes; c >= 0; c -= kLanes) {
      const Bytes rest = from_right(~least(load(now + c), grown(least_of_three(now + c + stride_))), right);
      right = rest[0];
      store(now + c, ~rest);
    }
  }
}

CellPlace CellDepths::deepest() const {
  const std::int64_t at = std::max_element(depth_.begin(), depth_.end()) - depth_.begin() - kBefore - stride_;
  return {column0_ + at % stride_, row0_ + at / stride_};
}

}  // namespace findspace::plane
