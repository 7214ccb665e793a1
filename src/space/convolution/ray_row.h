// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The work on one row of a PairRays: the events of its lines with their signs, from hits (ray_row_hits.h), groups
// (ray_row_groups.h) and cells (ray_row_cells.h). Guarantee: exact. Cost: theirs. Internal to ray_pair.
#pragma once

#include "space/convolution/ray_pair.h"
#include "space/convolution/ray_row_cells.h"

namespace findspace::space {

class RowWork {
 public:
  explicit RowWork(const PairRays& pair);
  RowWork(const RowWork&) = delete;
  RowWork& operator=(const RowWork&) = delete;
  /// May be called again: its memory is used again.
  RayRow run(int j);

 private:
  std::int8_t sign_here(int column, int group);
  std::int8_t sign_between(int column, int group);
  void emit(int column, RayRow& row);

  const PairRays& pair_;
  RowHits hits_;
  RowGroups row_;
  RowTest test_;
  RowCells cells_;
};

}  // namespace findspace::space
