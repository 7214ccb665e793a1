// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Rows of a ray map as bytes, from one process of a machine kind to another. Fractions travel as they are. A place on a
// curved patch travels as a name: where its exact number is wanted, the receiver makes that row of its own source again
// and asks there. Guarantee: the row that is read answers every question as the one that was written. Cost: linear; a
// row again for the few places that doubles do not order. Keywords: serialisation, distributed memory.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>

#include "space/rays/ray_map.h"

namespace findspace::space {

void append_bytes(const RayRow& row, std::string& out);

/// Reads rows that the same source gave in another process.
class RowReader {
 public:
  /// Refers to the source, which must outlive the rows.
  explicit RowReader(const RaySource& source);
  ~RowReader();
  RowReader(const RowReader&) = delete;
  RowReader& operator=(const RowReader&) = delete;

  /// Row j from the front of the bytes, which are taken off.
  RayRow read(int j, std::string_view& bytes);

 private:
  class Roots;
  const RayRoots* roots(int j, int number);

  const RaySource& source_;
  std::map<std::pair<int, int>, std::unique_ptr<Roots>> roots_;  // of row j, the ones that come first, second ...
};

}  // namespace findspace::space
