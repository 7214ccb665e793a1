// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "space/box/box_topology.h"

namespace findspace::space {
namespace {

/// Those at odd places, one of them in the first word at its second bit.
constexpr std::uint64_t kOdd = 0xAAAAAAAAAAAAAAAA;

/// To each odd place of the row what its neighbours have. Rows have an odd number of cells.
void close_along(BitRow row, int cells) {
  std::uint64_t before = 0;  // the last word as it was
  for (std::size_t k = 0; k < row.size(); ++k) {
    const std::uint64_t here = row[k], after = k + 1 < row.size() ? row[k + 1] : 0;
    row[k] |= kOdd & ((here << 1 | before >> (kWordBits - 1)) | (here >> 1 | after << (kWordBits - 1)));
    before = here;
  }
  fill_bits(row, cells, cells + 1, false);  // not a cell, but odd
}

void add_row(BitRow row, ConstBitRow other) {
  for (std::size_t k = 0; k < row.size(); ++k) row[k] |= other[k];
}

/// Each cell gets what those have whose closure holds it, one axis after the other.
CellBits closed(CellBits bits) {
  for (int z = 0; z < bits.cells(2); ++z) {
    for (int y = 0; y < bits.cells(1); ++y) close_along(bits.row(y, z), bits.cells(0));
    for (int y = 1; y < bits.cells(1); y += 2) {
      add_row(bits.row(y, z), bits.row(y - 1, z));
      add_row(bits.row(y, z), bits.row(y + 1, z));
    }
  }
  for (int z = 1; z < bits.cells(2); z += 2) {
    for (int y = 0; y < bits.cells(1); ++y) {
      add_row(bits.row(y, z), bits.row(y, z - 1));
      add_row(bits.row(y, z), bits.row(y, z + 1));
    }
  }
  return bits;
}

}  // namespace

BoxComplex closure(const BoxComplex& set) {
  if (set.too_fine()) return set;
  return {set.at(), closed(set.in())};
}

BoxComplex complement(const BoxComplex& set) {
  return set.remarked([](Mark m) { return Mark(m == 0); });
}

BoxComplex interior(const BoxComplex& set) { return complement(closure(complement(set))); }

BoxComplex boundary(const BoxComplex& set) {
  if (set.too_fine()) return set;
  CellBits bits = closed(set.in());
  const BoxComplex open = interior(set);
  for (std::size_t k = 0; k < bits.words().size(); ++k) bits.words()[k] &= ~open.in().words()[k];
  return {set.at(), std::move(bits)};
}

BoxComplex regularized(const BoxComplex& set) { return closure(interior(set)); }

}  // namespace findspace::space
