// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Processes that search for one layout together, each with islands of its own. All call the same functions in the same
// order and get the same answers. So with a limit of work alone a result depends on the seed, the processes and the
// islands only. Keywords: island model, MPI, allreduce.
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace findspace::packing {

class IslandPeers {
 public:
  virtual ~IslandPeers() = default;
  /// The number of this process, from 0.
  virtual std::size_t number() const = 0;
  /// Whether one of them says so.
  virtual bool any(bool own) = 0;
  /// What the one with the least cost gives, of equal ones the first. Costs are compared number by number, and all have
  /// equally many.
  virtual std::string best_of(std::span<const double> cost, std::string own) = 0;
};

/// The same for a process that may be alone: null.
inline bool any_of(IslandPeers* peers, bool own) { return peers == nullptr ? own : peers->any(own); }
inline std::size_t number_of(const IslandPeers* peers) { return peers == nullptr ? 0 : peers->number(); }

}  // namespace findspace::packing
