// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A search for a layout, in the plane and in space: how it goes on, what it starts from, other processes that take
// part, and what is wrong with a layout. Guarantee: whether a layout is feasible is decided by exact signs; depths and
// places of faults are doubles. Keywords: anytime algorithm, warm start, island model, MPI, layout validation.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "findspace/files.h"
#include "findspace/number.h"
#include "findspace/values.h"

namespace findspace {

/// Where a search stands.
struct PackProgress {
  double seconds = 0, processor = 0;  // since the beginning, by the clock and of all threads
  double length = 0, density = 0;     // of the best layout; of solids its height
  double overlap = 0;                 // left in the separation under way
  double since_better = 0;            // seconds since the best layout was found
};

/// Processes that search for one layout together, each with islands of its own. All call the same functions in the same
/// order and get the same answers. So with a limit of work alone a result depends on the seed, the processes and the
/// threads only. Keywords: allreduce.
class PackPeers {
 public:
  virtual ~PackPeers() = default;
  /// The number of this process, from 0.
  virtual std::size_t number() const = 0;
  /// Whether one of them says so.
  virtual bool any(bool own) = 0;
  /// What the one with the least cost gives, of equal ones the first. Costs are compared number by number, and all have
  /// equally many.
  virtual std::string best_of(std::span<const double> cost, std::string own) = 0;
};

/// What a search starts from, and who hears of it. What the functions throw ends the search.
template <class Layout>
struct PackSearch {
  /// A layout of all copies to begin with. Error(kBadValue) where Packing::check_start() refuses it; of solids where it
  /// is not feasible. In the plane its overlaps are taken out first; where that fails, the search begins anew. For a
  /// box a layout that is not feasible is not used.
  std::optional<Layout> start = {};
  /// Hears of each better layout at once; it is proved.
  std::function<void(const Layout&, const PackProgress&)> better = {};
  /// Hears every while how the search goes on.
  std::function<void(const PackProgress&)> progress = {};
  /// Other processes that search with this one. They live as long as the search.
  PackPeers* peers = nullptr;
};

/// Something that is wrong with a layout.
struct PackFault {
  /// Two copies overlap, are nearer than their gap, or a condition of theirs does not hold; a copy is outside of what
  /// holds it, at an angle that is not allowed, or in a zone that keeps it out; a kind of part has copies missing or
  /// too many, a kind of sheet or container is used too often, a fixed part does not stand where it does.
  enum class Kind { kOverlap, kGap, kCondition, kOutside, kAngle, kZone, kCount, kSheets, kContainers, kFixed };
  /// Which of these.
  Kind kind = Kind::kOverlap;
  /// Copies, "bracket#3"; of kCount and kFixed the kind of part, of kSheets and kContainers the kind of these.
  std::vector<std::string> of;
  /// Of kOverlap how deep, of kOutside how far, of kCount, kSheets and kContainers how many too many.
  double depth = 0;
  /// Where, near there: two coordinates in the plane, three in space. Zeros of what has no place.
  Place near;
  /// In words.
  std::string text;
};

/// Whether a layout keeps all promises.
struct PackVerdict {
  /// The deepest first.
  std::vector<PackFault> faults;
  /// How far the parts go: the greatest x of one, on the last sheet; of solids the greatest z, in the last container.
  Number used = 0;
  /// Of the parts in the layout's strip, sheets or containers.
  double density = 0;
  /// No fault.
  bool feasible() const { return faults.empty(); }
};

/// How a packing problem in JSON is read.
struct PackReading {
  std::string name = "problem";         // what messages call it; files of shapes lie beside it
  std::optional<std::string> folder{};  // or in this folder
  ReadOptions read{};                   // what may be opened, and at what cost
  Number gap = 0, edge = 0;             // least distances of parts, and of parts to the sides
  std::optional<Number> height{};       // of a strip, instead of what the problem says holds the parts
};

}  // namespace findspace
