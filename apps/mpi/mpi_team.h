// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A team of MPI ranks; rank 0 leads. Rows go in blocks: whoever is free asks for the next one and has one more in hand
// meanwhile, so ranks get blocks by what these cost. Rank 0 makes blocks too and hands rows on in order. Guarantee: the
// rows are those of one process, in the same order, so results have the same bytes for any number of ranks. A block
// that a rank cannot make is made by rank 0. Memory: kAhead blocks beyond the rows that are handed on.
// Keywords: MPI, master and worker, dynamic load balancing.
#pragma once

#include <mpi.h>

#include "common/row_team.h"

namespace findspace::app {

class MpiTeam : public RowTeam {
 public:
  explicit MpiTeam(MPI_Comm ranks);

  bool leads() const override { return rank_ == 0; }
  void meet() override { MPI_Barrier(ranks_); }
  space::RaySourcePointer shared(space::RaySourcePointer rows) override;
  void serve(const Source& source) override;

  /// At the end of the program, of every rank: rank 0 releases the others and hears from them all.
  void finish();

 private:
  friend class SharedRows;
  void serve_block(const Source& source, const struct BlockRequest& request);

  MPI_Comm ranks_;
  int rank_ = 0, count_ = 1;
  bool released_ = false;     // of the others
  std::vector<int> waiting_;  // of rank 0: ranks that asked for a block, once for each
  struct Made;
  std::unique_ptr<Made> made_;  // of the others: the last source, kept for the next block
};

}  // namespace findspace::app
