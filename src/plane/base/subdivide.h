// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Branch and bound, best first: the one loop of every search that divides. Cells wait in a heap, and the most promising
// one is looked at next, which may add parts of it. A search says three things: what a cell is and which of two is more
// promising (operator<), when nothing that is left is worth a look, and what a look at a cell does. It keeps the best
// it found itself. Guarantee: cells are looked at in an order that depends on nothing but their order of pushing; what
// is left at the end is known, so the most promising of it bounds what was missed. A limit of the thread's work
// (work_limit.h) ends every search, and an observer (stage_observer.h) sees the cells that say how they are drawn.
// Cost: log n a cell. Source: Land, Doig 1960; best first as in Horst, Tuy, Global Optimization, IV.2. Keywords: branch
// and bound, best-first search, priority queue, global optimisation.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "plane/base/stage_observer.h"
#include "plane/base/stop_check.h"

namespace findspace::plane {

/// How a subdivision ended: no cell is left, none is worth a look, or as many were looked at as were to be.
enum class SubdivisionEnd { kEmpty, kSettled, kSpent };

template <class Cell>
class Subdivision {
 public:
  /// Cells are not shown.
  Subdivision() = default;
  /// `title`: what they are, to an observer.
  explicit Subdivision(const char* title, bool planar = false) { seen_.emplace(title, planar); }

  void push(Cell cell) {
    cells_.push_back(std::move(cell));
    std::push_heap(cells_.begin(), cells_.end());
  }

  bool empty() const { return cells_.empty(); }
  /// The most promising one that is left; there is one.
  const Cell& best() const { return cells_.front(); }
  /// All that are left, in no order but that the first is the best.
  std::span<const Cell> left() const { return cells_; }

  /// Looks at one cell after the other until settled(best) says that it is not worth it, or `most` were looked at.
  /// look(cell) may push.
  template <class Settled, class Look>
  SubdivisionEnd run(long most, Settled&& settled, Look&& look) {
    return run(most, 1, settled, look, [] {});
  }

  template <class Settled, class Look>
  SubdivisionEnd run(Settled&& settled, Look&& look) {
    return run(std::numeric_limits<long>::max(), settled, look);
  }

  /// Takes so many cells at once before it asks again; together() follows their looks, to finish what they left to
  /// several threads.
  template <class Settled, class Look, class Together>
  SubdivisionEnd run(long most, std::size_t at_once, Settled&& settled, Look&& look, Together&& together) {
    for (long count = 0; !cells_.empty();) {
      if (settled(cells_.front())) return SubdivisionEnd::kSettled;
      if (count >= most) return SubdivisionEnd::kSpent;
      for (std::size_t k = 0; k < at_once && !cells_.empty(); ++k, ++count) {
        if (count % kPolledEach == 0) poll();
        look(take());
      }
      together();
    }
    return SubdivisionEnd::kEmpty;
  }

 private:
  static constexpr long kPolledEach = 64;

  static void poll() {
    if (StopCheck* const check = stop_check()) check->poll();
  }

  Cell take() {
    std::pop_heap(cells_.begin(), cells_.end());
    Cell out = std::move(cells_.back());
    cells_.pop_back();
    if constexpr (requires(ObservedCells & seen) { out.draw(seen); }) {
      if (seen_ && *seen_) out.draw(*seen_);
    }
    return out;
  }

  std::vector<Cell> cells_;
  std::optional<ObservedCells> seen_;
};

}  // namespace findspace::plane
