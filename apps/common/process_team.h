// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Processes that answer one question together. All run the same command. One of them leads: it reads files for all and
// writes the result. Of a map the leader takes rows from the others, which give them until it has all. A packing is
// searched by all. The others write nothing.
#pragma once

#include <findspace/pack_search.h>

#include <functional>

#include "common/row_digests.h"
#include "formula/solid/solve_rays.h"

namespace findspace::app {

class ProcessTeam {
 public:
  using Source = std::function<formula::RegionOnLines(const space::RayGrid&)>;

  ProcessTeam() = default;
  virtual ~ProcessTeam() = default;
  ProcessTeam(const ProcessTeam&) = delete;
  ProcessTeam& operator=(const ProcessTeam&) = delete;

  virtual bool leads() const = 0;
  virtual std::size_t count() const = 0;
  /// Returns when all have come here.
  virtual void meet() = 0;
  /// What makes a text, called by the leader alone; all get the text, or the Error. All call this in the same order.
  virtual std::string shared_text(const std::function<std::string()>& make) = 0;
  /// For a search that all take part in.
  virtual PackPeers& peers() = 0;
  /// Of the leader: the same rows, made by all.
  virtual space::RaySourcePointer shared(space::RaySourcePointer rows) = 0;
  /// Of the leader: how it spent its time on rows; nothing where it has shared none.
  virtual std::string account() const = 0;
  /// Of the leader: digests of all rows in order, made by all.
  virtual void each_digest(const space::RaySource& own, const RowDigester& digester, bool written,
                           const std::function<void(int, RowDigest&&)>& take) = 0;
  /// Of the others: gives rows or digests on the grids that the leader names, until it has ended. The `first` of these
  /// is known: all make its source at the same time.
  virtual void serve(const Source& source, const space::RayGrid& first, const RowDigester& digester) = 0;
};

}  // namespace findspace::app
