// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What a map on lines needs of a row: its intervals and its text. They are made where the row is made, by any thread or
// process, so that what is left in order is short. And processes that make rows together: one of them leads, and takes
// rows from the others, which give them until it has all. Keywords: map and reduce.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "formula/solid/solve_rays.h"
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

class RowTeam {
 public:
  using Source = std::function<formula::RegionOnLines(const space::RayGrid&)>;

  RowTeam() = default;
  virtual ~RowTeam() = default;
  RowTeam(const RowTeam&) = delete;
  RowTeam& operator=(const RowTeam&) = delete;

  virtual bool leads() const = 0;
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

/// The team of this thread, or null.
RowTeam* row_team();
/// While it lives, maps on lines that this thread asks for are made by the team. Null: by this process alone.
class RowsByTeam {
 public:
  explicit RowsByTeam(RowTeam* team);
  ~RowsByTeam();
  RowsByTeam(const RowsByTeam&) = delete;
  RowsByTeam& operator=(const RowsByTeam&) = delete;

 private:
  RowTeam* before_;
};

}  // namespace findspace::io
