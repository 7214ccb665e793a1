// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What packing in the plane and in space share: options of the command line, how a search goes on, a verdict about a
// layout in words and as JSON.
#pragma once

#include <fmt/format.h>

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
#include "packing/search/search_options.h"

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

/// A line for each part of which copies are left out.
template <class Part>
std::string left_out_text(const std::vector<Part>& parts, const std::vector<packing::LeftOut>& left_out) {
  std::string text;
  for (const packing::LeftOut& out : left_out)
    text += fmt::format("left out: {} of {}: {}\n", out.copies, parts[out.part].name, out.why);
  return text;
}
/// What is left out where no part fits a container.
template <class Part>
std::vector<packing::LeftOut> all_left_out(const std::vector<Part>& parts, const char* too_large) {
  return packing::left_out_of(
      parts, std::vector<int>(parts.size()), [](std::size_t) { return false; }, too_large);
}

std::string verdict_text(const packing::Problem& problem, const packing::Layout& layout,
                         const packing::Verdict& verdict);
std::string verdict_json(const packing::Problem& problem, const packing::Layout& layout,
                         const packing::Verdict& verdict);

}  // namespace findspace::app
