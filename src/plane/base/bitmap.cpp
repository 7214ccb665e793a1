// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/base/bitmap.h"

#include <algorithm>

namespace findspace::plane {
LatticeBox LatticeBox::around(std::span<const LatticeRun> runs) {
  LatticeBox box;
  for (const LatticeRun& r : runs) box.add({r.row, r.row, r.first, r.last});
  return box;
}

void LatticeBox::add(const LatticeBox& o) {
  row0 = std::min(row0, o.row0);
  row1 = std::max(row1, o.row1);
  column0 = std::min(column0, o.column0);
  column1 = std::max(column1, o.column1);
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

}  // namespace findspace::plane
