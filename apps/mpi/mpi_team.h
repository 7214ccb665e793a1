// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A team of MPI ranks; rank 0 leads. Rows go in blocks: whoever is free asks for the next one and has one more in hand
// meanwhile, so ranks get blocks by what these cost. Rank 0 makes blocks too and hands rows on in order. Guarantee: the
// rows are those of one process, in the same order, so results have the same bytes for any number of ranks. A block
// that a rank cannot make is made by rank 0. Memory: kAheadRows beyond those that are handed on, or kAheadARank
// for each rank. Texts of files are read by rank 0 and broadcast. Searches exchange their best layouts by reductions.
// Keywords: MPI, master and worker, dynamic load balancing.
#pragma once

#include <mpi.h>

#include <thread>

#include "common/process_team.h"

namespace findspace::app {

class MpiTeam : public ProcessTeam, private PackPeers {
 public:
  explicit MpiTeam(MPI_Comm ranks);
  ~MpiTeam() override;

  bool leads() const override { return rank_ == 0; }
  std::size_t count() const override { return static_cast<std::size_t>(count_); }
  void meet() override { MPI_Barrier(ranks_); }
  std::string shared_text(const std::function<std::string()>& make) override;
  PackPeers& peers() override { return *this; }
  space::RaySourcePointer shared(space::RaySourcePointer rows) override;
  std::string account() const override;
  void each_digest(const space::RaySource& own, const io::RowDigester& digester, bool written,
                   const std::function<void(int, io::RowDigest&&)>& take) override;
  void serve(const Source& source, const space::RayGrid& first, const io::RowDigester& digester) override;

  /// Between two rows: a large message moves only while both ends call MPI. Of the thread that made the team; others
  /// pass.
  void progress() const;

  /// At the end of the program, of every rank: rank 0 releases the others and hears from them all.
  void finish();

 private:
  template <class Item>
  friend class SharedBlocks;
  std::size_t number() const override { return static_cast<std::size_t>(rank_); }
  bool any(bool own) override;
  std::string best_of(std::span<const double> cost, std::string own) override;
  void broadcast(std::string& text, int from);
  void make_source(const Source& source, const space::RayGrid& grid);
  std::string answer(const struct BlockRequest& request, const io::RowDigester& digester) const;
  void serve_block(const Source& source, const io::RowDigester& digester, const BlockRequest& request);

  /// How rank 0 spent its time on rows: processor seconds for the first two, seconds by the clock for the last.
  struct Account {
    int rows_made = 0, rows_taken = 0;
    double making = 0, slowest_row = 0, taking = 0, waiting = 0;
  };

  MPI_Comm ranks_;
  std::thread::id main_ = std::this_thread::get_id();
  Account account_;
  int rank_ = 0, count_ = 1;
  int ended_ = 0;             // of rank 0: ranks that are at their end
  bool released_ = false;     // of the others
  std::vector<int> waiting_;  // of rank 0: ranks that asked for a block, once for each
  struct Made;
  std::unique_ptr<Made> made_;  // of the others: the last source, kept for the next block
};

}  // namespace findspace::app
