// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "io/team/row_digest.h"

#include <algorithm>
#include <span>

#include "plane/base/parallel.h"

namespace findspace::io {
std::vector<RowDigest> digests_of(const space::RaySource& source, const RowDigester& digester, bool written, int begin,
                                  int count) {
  std::vector<RowDigest> out(static_cast<std::size_t>(count));
  plane::parallel_for(out.size(), [&](std::size_t k) {
    const int j = begin + static_cast<int>(k);
    out[k] = digester(source.grid(), j, source.row(j), written);
  });
  return out;
}

void each_digest(const space::RaySource& source, const RowDigester& digester, bool written,
                 const std::function<void(int, RowDigest&&)>& take) {
  constexpr int kAtOnce = 64;
  const int rows = source.grid().nv;
  for (int begin = 0; begin < rows; begin += kAtOnce) {
    std::vector<RowDigest> block = digests_of(source, digester, written, begin, std::min(kAtOnce, rows - begin));
    for (std::size_t k = 0; k < block.size(); ++k) take(begin + static_cast<int>(k), std::move(block[k]));
  }
}

void put_digest(const RowDigest& digest, plane::ByteWriter& out) {
  out.put_all(std::span<const std::int32_t>(digest.intervals.lines));
  out.put_all(std::span<const double>(digest.intervals.from));
  out.put_all(std::span<const double>(digest.intervals.to));
  out.put(digest.intervals.radius);
  out.put_text(digest.text);
}

RowDigest take_digest(plane::ByteReader& in) {
  RowDigest digest;
  digest.intervals.lines = in.take_all<std::int32_t>();
  digest.intervals.from = in.take_all<double>();
  digest.intervals.to = in.take_all<double>();
  digest.intervals.radius = in.take<double>();
  digest.text = in.take_text();
  return digest;
}

}  // namespace findspace::io
