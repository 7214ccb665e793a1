// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What a map on lines needs of a row: its intervals and its text. They are made where the row is made, by any thread or
// process, so that what is left in order is short. Keywords: map and reduce.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "plane/base/bytes.h"
#include "space/rays/ray_summary.h"

namespace findspace::io {

struct RowDigest {
  space::RowIntervals intervals;
  std::string text;  // of the lines, where they are written
};

/// `written`: with the text.
using RowDigester = std::function<RowDigest(const space::RayGrid&, int j, const space::RayRow&, bool written)>;

/// Of the rows from `begin` on, on several threads.
std::vector<RowDigest> digests_of(const space::RaySource& source, const RowDigester& digester, bool written, int begin,
                                  int count);
/// Of all rows, in order.
void each_digest(const space::RaySource& source, const RowDigester& digester, bool written,
                 const std::function<void(int, RowDigest&&)>& take);

void put_digest(const RowDigest& digest, plane::ByteWriter& out);
RowDigest take_digest(plane::ByteReader& in);

}  // namespace findspace::io
