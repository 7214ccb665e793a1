// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What packing in the plane and in space share: options of the command line, how a search goes on, a verdict about a
// layout in words and as JSON.
#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <thread>

#include "common/options.h"
#include "common/process_team.h"
#include "io/nesting/read_nesting.h"
#include "packing/proof/verify.h"
#include "packing/search/strip_search.h"

namespace findspace::app {

/// The height, gap and edge of the command line.
io::NestingOptions nesting_options(const Options& options);

/// A layout of the problem to begin with: JSON, or an SVG of sparrow; `most` bytes. Throws Error.
packing::Layout start_layout(const packing::Problem& problem, const std::filesystem::path& path, std::uint64_t most);

/// The limits, the seed and the threads of the command line.
template <class Layout>
packing::SearchOptionsOf<Layout> search_options(const Options& options) {
  packing::SearchOptionsOf<Layout> out;
  out.seed = options.seed;
  out.threads = options.threads > 0 ? options.threads : std::max(1U, std::thread::hardware_concurrency());
  out.seconds = options.time_limit;
  out.work = options.work * 1000000;
  if (options.team != nullptr && options.team->count() > 1) out.peers = &options.team->peers();
  return out;
}

/// A better layout, and a search under way; `size` is what is made small: "length".
std::string better_text(const packing::SearchState& state, std::string_view size);
std::string progress_text(const packing::SearchState& state, std::string_view size);

std::string verdict_text(const packing::Problem& problem, const packing::Layout& layout,
                         const packing::Verdict& verdict);
std::string verdict_json(const packing::Problem& problem, const packing::Layout& layout,
                         const packing::Verdict& verdict);

}  // namespace findspace::app
