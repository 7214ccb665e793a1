// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A search for a layout under the options of the public headers, in the plane and in space. A limit ends the search
// with what was found by then. Keywords: packing, time limit, cancellation.
#pragma once

#include <findspace/options.h>

#include <algorithm>
#include <atomic>
#include <functional>
#include <optional>
#include <thread>

#include "api/values/limits.h"
#include "packing/search/search_options.h"

namespace findspace::io {

/// search(options, events, stop) gives a Layout or nothing, shown(layout) is what users see of it.
template <class Layout, class Shown, class Show, class Search>
std::optional<Shown> searched(const Options& options, const std::function<void(const Shown&)>& better,
                              const Show& shown, const Search& search) {
  packing::SearchOptionsOf<Layout> asked;
  asked.seed = options.seed;
  asked.threads = options.threads > 0 ? options.threads : std::max(1u, std::thread::hardware_concurrency());
  asked.seconds = options.seconds;
  asked.work = options.work * 1000000;
  api::Watch watch(options);
  std::atomic<bool> stop = false;
  std::optional<Limit> met;
  const auto look = [&] {
    try {
      watch.poll();
    } catch (const Stopped& stopped) {
      met = stopped.limit();
      stop = true;
    }
  };
  packing::SearchEventsOf<Layout> events;
  events.better = [&](const Layout& layout, const packing::SearchState&) {
    if (better) better(shown(layout));
    look();
  };
  events.progress = [&](const packing::SearchState&) { look(); };
  std::optional<Layout> best;
  plane::with_threads(options.threads, [&] { best = search(asked, events, stop); });
  if (!met) look();
  if (!best) return std::nullopt;
  Shown result = shown(*best);
  result.met = met;
  return result;
}

}  // namespace findspace::io
