// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The search for a short strip, or for few sheets, on several threads. Sheets are a strip with walls (row.h). Where
// they cannot hold all parts, it first seeks a more valuable choice of parts, for half of the work. Each thread has an
// island; after rounds of the same work they meet, and those that are behind go on from the best layout. Every better
// layout is proved and given away at once. Guarantee: layouts given are feasible, exactly; what is not in them is left
// out with a reason. With a limit of work alone the result depends on the seed and the number of threads only; a limit
// of time only ends the search. Other processes may take part; all of them give the same layouts. Cost: as long as
// allowed.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>

#include "packing/problem/problem.h"
#include "packing/search/island_peers.h"

namespace findspace::packing {

template <class Layout>
struct SearchOptionsOf {
  std::uint64_t seed = 1;
  unsigned threads = 1;
  double seconds = 0;  // 0: until no better layout comes for a while
  double work = 0;     // pairs of parts looked at by a thread; 0: no limit
  const Layout* start = nullptr;
  IslandPeers* peers = nullptr;  // other processes that search with this one
};
using SearchOptions = SearchOptionsOf<Layout>;

struct SearchState {
  double seconds = 0, processor = 0;  // since the beginning
  double length = 0, density = 0;
  double overlap = 0;       // left in the separation under way
  double since_better = 0;  // seconds
};

template <class Layout>
struct SearchEventsOf {
  std::function<void(const Layout&, const SearchState&)> better;  // a proved layout
  std::function<void(const SearchState&)> progress;
};
using SearchEvents = SearchEventsOf<Layout>;

/// Nothing where there are no parts, no part that fits a sheet, or no layout was found in which all conditions hold.
/// `stop`: ends the search when it becomes true.
std::optional<Layout> search_strip(const Problem& problem, const SearchOptions& options, const SearchEvents& events,
                                   const std::atomic<bool>& stop);

}  // namespace findspace::packing
