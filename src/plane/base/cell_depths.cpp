// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/base/cell_depths.h"

#include <algorithm>
#include <cstring>
#include <vector>

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

constexpr std::size_t kManyCells = 40'000;  // from here on blocks of rows are worked on at once
// What lies beyond a block's neighbour is further away than the most that is told; of two there is none such.
constexpr std::size_t kRowsOfBlock = 512;

std::size_t block_count(std::size_t rows, std::size_t cells) {
  if (range_count(cells, kManyCells) == 1) return 1;
  return std::clamp<std::size_t>(rows / kRowsOfBlock, 2, kRanges);
}

}  // namespace

CellDepths::CellDepths(const Bitmap& cells) {
  const LatticeBox& box = cells.box();
  row0_ = box.row0;
  rows_ = box.row1 - box.row0 + 1;
  column0_ = box.column0;
  columns_ = box.column1 - box.column0 + 1;
  stride_ = ((columns_ - 1) / kLanes + 1) * kLanes + 2 * kBeside;
  depth_ = std::make_unique_for_overwrite<std::uint8_t[]>(std::size_t((rows_ + 2) * stride_));
  for (const std::int64_t r : {std::int64_t(-1), rows_}) std::fill_n(&depth_[place(r, -kBeside)], stride_, 0);
  const std::size_t blocks = block_count(std::size_t(rows_), std::size_t(rows_ * columns_));
  const std::vector<std::uint8_t> deep(blocks > 1 ? std::size_t(stride_) : kBeside, 255);
  each_range(blocks, [&](std::size_t k) { find(cells, range(k, blocks, std::size_t(rows_)), deep.data() + kBeside); });
  if (blocks > 1) limit_blocks(blocks);
}

// The chessboard distance to a cell that is not marked, by one pass from each corner; cells outside are not marked.
void CellDepths::find(const Bitmap& cells, IndexRange block, const std::uint8_t* deep) {
  const std::uint8_t* before = block.first == 0 ? row(0) - stride_ : deep;
  for (std::size_t r = block.first; r < block.end; ++r) {
    const std::uint64_t* bits = cells.line(row0_ + std::int64_t(r));
    std::uint8_t* const now = row(r);
    store(now - kBeside, Bytes{});
    store(now + stride_ - 2 * kBeside, Bytes{});
    std::uint8_t left = 255;
    for (std::int64_t c = 0; c < columns_; c += kLanes) {
      const Bytes marked = spread(bits[c / 64] >> (c % 64) & 0xffff);
      const Bytes rest = from_left(~(grown(least_of_three(before + c)) & marked), left);
      left = rest[kLanes - 1];
      store(now + c, ~rest);
    }
    before = now;
  }
  const std::uint8_t* after = block.end == std::size_t(rows_) ? row(block.end) : deep;
  for (std::size_t r = block.end; r-- > block.first;) {
    std::uint8_t* const now = row(r);
    std::uint8_t right = 255;
    for (std::int64_t c = stride_ - 2 * kBeside - kLanes; c >= 0; c -= kLanes) {
      const Bytes rest = from_right(~least(load(now + c), grown(least_of_three(after + c))), right);
      right = rest[0];
      store(now + c, ~rest);
    }
    after = now;
  }
}

void CellDepths::limit_blocks(std::size_t blocks) {
  std::vector<std::vector<std::uint8_t>> first, last;  // rows of each block, before they are limited
  for (std::size_t k = 0; k < blocks; ++k) {
    const IndexRange block = range(k, blocks, std::size_t(rows_));
    const auto copied = [&](std::size_t r) { return std::vector(row(r) - kBeside, row(r) - kBeside + stride_); };
    first.push_back(copied(block.first));
    last.push_back(copied(block.end - 1));
  }
  each_range(blocks, [&](std::size_t k) {
    limit(range(k, blocks, std::size_t(rows_)), k == 0 ? nullptr : last[k - 1].data() + kBeside,
          k + 1 == blocks ? nullptr : first[k + 1].data() + kBeside);
  });
}

// The way from a cell to one in another block goes along rows there, and then from row to row: here none goes along
// rows.
void CellDepths::limit(IndexRange block, const std::uint8_t* above, const std::uint8_t* below) {
  for (std::size_t r = block.first; above != nullptr && r < block.end && limit(row(r), above); ++r) above = row(r);
  for (std::size_t r = block.end; below != nullptr && r-- > block.first && limit(row(r), below);) below = row(r);
}

bool CellDepths::limit(std::uint8_t* row, const std::uint8_t* by) const {
  Bytes changes{};
  for (std::int64_t c = 0; c < columns_; c += kLanes) {
    const Bytes old = load(row + c), limited = least(old, grown(least_of_three(by + c)));
    changes |= old ^ limited;
    store(row + c, limited);
  }
  const auto parts = Words(changes);
  return (parts[0] | parts[1]) != 0;
}

CellPlace CellDepths::deepest() const {
  const std::uint8_t* const all = depth_.get();
  const std::int64_t at = std::max_element(all, all + (rows_ + 2) * stride_) - all;
  return {column0_ + at % stride_ - kBeside, row0_ + at / stride_ - 1};
}

}  // namespace findspace::plane
