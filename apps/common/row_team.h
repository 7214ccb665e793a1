// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Processes that make the rows of one map together. All run the same command. One of them leads: it takes rows from the
// others and writes the result. The others read the scene, give rows until the leader has all, and write nothing.
#pragma once

#include <functional>

#include "formula/solid/solve_rays.h"

namespace findspace::app {

class RowTeam {
 public:
  using Source = std::function<formula::RegionOnLines(const space::RayGrid&)>;

  RowTeam() = default;
  virtual ~RowTeam() = default;
  RowTeam(const RowTeam&) = delete;
  RowTeam& operator=(const RowTeam&) = delete;

  virtual bool leads() const = 0;
  /// Returns when all have come here.
  virtual void meet() = 0;
  /// Of the leader: the same rows, made by all.
  virtual space::RaySourcePointer shared(space::RaySourcePointer rows) = 0;
  /// Of the others: gives rows on the grids that the leader names, until it has ended.
  virtual void serve(const Source& source) = 0;
};

}  // namespace findspace::app
