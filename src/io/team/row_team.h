// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Rows of a map on lines that the processes of a team (findspace/team.h) make together. Rows go in blocks: whoever is
// free asks for the next one and has one more in hand meanwhile, so processes get blocks by what these cost. The leader
// makes blocks too and hands rows on in order. Guarantee: the rows are those of one process, in the same order, so
// results have the same bytes for any number of processes. A block that one cannot make is made by the leader. Memory:
// kAheadRows beyond those that are handed on, or kAheadAProcess for each process. Keywords: master and worker, dynamic
// load balancing.
#pragma once

#include <findspace/team.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "formula/solid/solve_rays.h"
#include "io/team/row_digest.h"
#include "plane/base/of_thread.h"

namespace findspace::io {

class RowTeam {
 public:
  using Source = std::function<formula::RegionOnLines(const space::RayGrid&)>;

  /// Refers to the team.
  explicit RowTeam(Team& team);
  ~RowTeam();
  RowTeam(const RowTeam&) = delete;
  RowTeam& operator=(const RowTeam&) = delete;

  bool leads() const { return team_.leads(); }
  /// Of the leader: the same rows, made by all.
  space::RaySourcePointer shared(space::RaySourcePointer rows);
  /// Of the leader: how it spent its time on rows; nothing where it has shared none.
  std::string account() const;
  /// Of the leader: digests of all rows in order, made by all.
  void each_digest(const space::RaySource& own, const RowDigester& digester, bool written,
                   const std::function<void(int, RowDigest&&)>& take);
  /// Of the others: gives rows or digests on the grids that the leader names, until it has ended. The `first` of these
  /// is known: all make its source at the same time.
  void serve(const Source& source, const space::RayGrid& first, const RowDigester& digester);
  /// At the end, of all: the leader releases the others and hears from them.
  void finish();

 private:
  template <class Item>
  friend class SharedBlocks;
  struct Request;
  struct Made;
  void make_source(const Source& source, const space::RayGrid& grid);
  std::string answer(const Request& request, const RowDigester& digester) const;
  void serve_block(const Source& source, const RowDigester& digester, const Request& request);

  /// How the leader spent its time on rows: processor seconds for the first two, seconds by the clock for the last.
  struct Account {
    int rows_made = 0, rows_taken = 0;
    double making = 0, slowest_row = 0, taking = 0, waiting = 0;
  };

  Team& team_;
  Account account_;
  std::size_t ended_ = 0;             // of the leader: processes that are at their end
  bool released_ = false;             // of the others
  std::vector<std::size_t> waiting_;  // of the leader: processes that asked for a block, once for each
  std::unique_ptr<Made> made_;        // of the others: the last source, kept for the next block
};

/// While it lives, maps on lines that this thread asks for are made by the team. Null: by this process alone.
using RowsByTeam = plane::OfThread<RowTeam>;
/// The team of this thread, or null.
inline RowTeam* row_team() { return RowsByTeam::now(); }

}  // namespace findspace::io
