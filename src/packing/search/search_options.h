// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What a search is asked, and what it says on the way: in the plane and in space.
#pragma once

#include <cstdint>
#include <functional>

#include "findspace/pack_search.h"
#include "packing/search/stop_wish.h"

namespace findspace::packing {

template <class Layout>
struct SearchOptionsOf {
  std::uint64_t seed = 1;
  unsigned threads = 1;
  double seconds = 0;  // 0: until no better layout comes for a while
  double work = 0;     // pairs of parts looked at by a thread; 0: no limit
  const Layout* start = nullptr;
  PackPeers* peers = nullptr;  // other processes that search with this one
};

template <class Layout>
struct SearchEventsOf {
  std::function<void(const Layout&, const PackProgress&)> better;  // a proved layout
  std::function<void(const PackProgress&)> progress;
};

}  // namespace findspace::packing
