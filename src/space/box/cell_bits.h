// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A bit for every cell of a product grid: rows along x of whole words, whose last bits beyond the grid are 0. What is
// asked of a row costs its words, not its cells. Guarantee: exact. Keywords: bitmap, bit set, run.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace findspace::space {

using BitRow = std::span<std::uint64_t>;
using ConstBitRow = std::span<const std::uint64_t>;

inline constexpr int kWordBits = 64;

inline bool bit(ConstBitRow row, int x) { return (row[std::size_t(x / kWordBits)] >> (x % kWordBits) & 1) != 0; }

/// The first place from `x` on where the row has the value; `end` if there is none before it.
inline int next_bit(ConstBitRow row, int x, int end, bool value) {
  const std::uint64_t turn = value ? 0 : ~std::uint64_t{0};
  while (x < end) {
    const std::uint64_t rest = (row[std::size_t(x / kWordBits)] ^ turn) >> (x % kWordBits);
    if (rest != 0) {
      x += std::countr_zero(rest);
      return x < end ? x : end;
    }
    x += kWordBits - x % kWordBits;
  }
  return end;
}

/// The places from `from` to before `to`.
inline void fill_bits(BitRow row, int from, int to, bool value) {
  while (from < to) {
    const int at = from % kWordBits, count = to - from < kWordBits - at ? to - from : kWordBits - at;
    const std::uint64_t mask = (~std::uint64_t{0} >> (kWordBits - count)) << at;
    std::uint64_t& word = row[std::size_t(from / kWordBits)];
    word = value ? word | mask : word & ~mask;
    from += count;
  }
}

class CellBits {
 public:
  CellBits() = default;
  explicit CellBits(const std::array<int, 3>& cells)
      : cells_(cells),
        words_((std::size_t(cells[0]) + kWordBits - 1) / kWordBits),
        bits_(words_ * std::size_t(cells[1]) * std::size_t(cells[2]), 0) {}

  int cells(int k) const { return cells_[std::size_t(k)]; }
  BitRow row(int y, int z) { return BitRow(bits_).subspan(row_number(y, z) * words_, words_); }
  ConstBitRow row(int y, int z) const { return ConstBitRow(bits_).subspan(row_number(y, z) * words_, words_); }
  bool has(int x, int y, int z) const { return bit(row(y, z), x); }
  /// All words, row by row.
  BitRow words() { return bits_; }
  ConstBitRow words() const { return bits_; }

  /// The places of the row from `from` to before `to`.
  void fill(int y, int z, int from, int to, bool value) { fill_bits(row(y, z), from, to, value); }
  bool full(int y, int z, int from, int to) const { return next_bit(row(y, z), from, to, false) == to; }
  /// Each bit turned.
  void turn() {
    for (std::uint64_t& word : bits_) word = ~word;
    const int over = cells_[0] % kWordBits;
    if (over == 0) return;
    const std::uint64_t kept = ~std::uint64_t{0} >> (kWordBits - over);
    for (std::size_t last = words_; last <= bits_.size(); last += words_) bits_[last - 1] &= kept;
  }
  /// Visits every cell whose bit is set, by growing z, y, x.
  template <class Visit>
  void each(Visit visit) const {
    for (int z = 0; z < cells(2); ++z) {
      for (int y = 0; y < cells(1); ++y) {
        const ConstBitRow bits = row(y, z);
        for (int x = next_bit(bits, 0, cells(0), true); x < cells(0); x = next_bit(bits, x + 1, cells(0), true))
          visit(x, y, z);
      }
    }
  }
  friend bool operator==(const CellBits&, const CellBits&) = default;

 private:
  std::size_t row_number(int y, int z) const {
    return static_cast<std::size_t>(z) * static_cast<std::size_t>(cells_[1]) + static_cast<std::size_t>(y);
  }

  std::array<int, 3> cells_{};
  std::size_t words_ = 0;  // of a row
  std::vector<std::uint64_t> bits_;
};

}  // namespace findspace::space
