// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Rows of a map on lines that the processes of a team (findspace/team.h) make together. Rows go in blocks: whoever is
// free asks for the next one and has one more in hand meanwhile, so processes get blocks by what these cost. The leader
// makes blocks too and hands rows on in order. Questions are counted by all: the others make rows of one until the
// leader ends it. Guarantee: the rows are those of one process, in the same order, so results have the same bytes for
// any number of processes. A block that one cannot make is made by the leader. Memory: kAheadRows beyond those that are
// handed on, or kAheadAProcess for each process. Keywords: master and worker, dynamic load balancing.
#pragma once

#include <findspace/team.h>

#include <cstdint>
#include <functional>
#include <map>
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
  /// Of all: the next question begins.
  void begin();
  /// The number of the question, from 1 on.
  std::int64_t question() const { return question_; }
  /// Of the leader: the others go on to what follows the question.
  void end();
  /// Of the leader: the same rows, made by all as long as that is the question.
  space::RaySourcePointer shared(space::RaySourcePointer rows, std::int64_t question);
  /// Of the leader: how it spent its time on rows of the question; nothing where it has shared none.
  std::string account() const;
  /// Of the leader: digests of all rows in order, made by all.
  void each_digest(const space::RaySource& own, const RowDigester& digester, bool written,
                   const std::function<void(int, RowDigest&&)>& take);
  /// Of the others: gives rows or digests on the grids that the leader names, until it ends the question. The `first`
  /// of these is known: all make its source at the same time.
  void serve(const Source& source, const space::RayGrid& first, const RowDigester& digester);
  /// Of the others: whether the leader has called finish().
  bool is_released() const { return released_; }
  /// At the end, of all: the leader releases the others and hears from them.
  void finish();

 private:
  template <class Item>
  friend class SharedBlocks;
  struct Request;
  struct Reply;
  struct Made;
  bool is_open(std::int64_t question) const { return question == question_ && question > ended_question_; }
  void ask();
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
  std::int64_t question_ = 0;
  std::int64_t ended_question_ = 0;  // of the leader: the last one
  std::int64_t runs_ = 0;            // of the leader: how often it has shared rows
  std::size_t ended_ = 0;            // of the leader: processes that are at their end
  bool released_ = false;            // of the others
  // Of the leader: processes that asked for a block, once for each, by the question.
  std::map<std::int64_t, std::vector<std::size_t>> waiting_;
  std::unique_ptr<Made> made_;  // of the others: the last source, kept for the next block
};

/// While it lives, maps on lines that this thread asks for are made by the team. Null: by this process alone.
using RowsByTeam = plane::OfThread<RowTeam>;
/// The team of this thread, or null.
inline RowTeam* row_team() { return RowsByTeam::now(); }
/// A question of this thread begins that may be answered on lines.
inline void begin_question() {
  if (RowTeam* const team = row_team()) team->begin();
}

}  // namespace findspace::io
