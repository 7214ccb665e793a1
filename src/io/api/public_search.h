// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A search for a layout under the options of the public headers, in the plane and in space. A limit ends the search
// with what was found by then. Keywords: packing, time limit, cancellation.
#pragma once

#include <findspace/options.h>
#include <findspace/pack_search.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <filesystem>
#include <optional>
#include <thread>
#include <vector>

#include "api/values/limits.h"
#include "io/api/public_packing.h"
#include "io/nesting/read_nesting.h"
#include "packing/search/search_options.h"

namespace findspace::io {

/// search(options, events, stop) gives a Layout or nothing, shown(layout) is what users see of it.
template <class Layout, class Shown, class Show, class Search>
std::optional<Shown> searched(const Options& options, const PackSearch<Shown>& how, const Layout* start,
                              const Show& shown, const Search& search) {
  packing::SearchOptionsOf<Layout> asked;
  asked.seed = options.seed;
  asked.threads = options.threads > 0 ? options.threads : std::max(1u, std::thread::hardware_concurrency());
  asked.seconds = options.seconds;
  asked.work = options.work * 1000000;
  asked.start = start;
  asked.peers = how.peers;
  api::Watch watch(options);
  std::atomic<bool> stop = false;
  std::optional<Limit> met;
  double seconds = 0;  // of the last better layout
  const auto look = [&] {
    try {
      watch.poll();
    } catch (const Stopped& stopped) {
      met = stopped.limit();
      stop = true;
    }
  };
  std::exception_ptr thrown;
  const auto hear = [&](const auto& tell) {  // what it throws ends the search of all processes
    if (!thrown) try {
        tell();
      } catch (...) {
        thrown = std::current_exception();
        stop = true;
      }
  };
  const auto found = [&](const Layout& layout) {
    Shown result = shown(layout);
    result.seconds = seconds;
    result.seed = asked.seed;
    result.threads = asked.threads;
    return result;
  };
  packing::SearchEventsOf<Layout> events;
  events.better = [&](const Layout& layout, const PackProgress& state) {
    seconds = state.seconds;
    if (how.better) hear([&] { how.better(found(layout), state); });
    look();
  };
  events.progress = [&](const PackProgress& state) {
    if (how.progress) hear([&] { how.progress(state); });
    look();
  };
  std::optional<Layout> best;
  plane::with_threads(options.threads, [&] { best = search(asked, events, packing::StopWish(stop, options.cancel)); });
  if (thrown) std::rethrow_exception(thrown);
  if (!met) look();
  if (!best) return std::nullopt;
  Shown result = found(*best);
  result.met = met;
  return result;
}

/// What JSON of a problem is read by.
inline NestingOptions nesting_options(const PackReading& reading) {
  const auto height = reading.height ? std::optional(fraction(*reading.height, "height")) : std::nullopt;
  return {height, fraction(reading.gap, "gap"), fraction(reading.edge, "edge"), reading.read,
          std::filesystem::path(reading.folder.value_or(""))};
}

}  // namespace findspace::io
