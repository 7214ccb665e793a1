// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A packing that goes on while requests are answered: a search on threads of its own, its best layout so far, and
// repairs of a layout after one part was moved by hand. Guarantee: every layout that is given away is proved. Threads:
// one request at a time, beside the search. Keywords: background job, progress, anytime algorithm.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "io/nesting/read_nesting.h"
#include "io/nesting/write_layout.h"
#include "packing/search/strip_search.h"

namespace findspace::app {

/// Decimals, as the options of the verb `pack`.
struct PackingOptions {
  std::optional<std::string> height;
  std::string gap = "0", edge = "0";
  io::ReadOptions read = {};          // of shapes in files,
  std::filesystem::path folder = {};  // which are looked for here
};

struct PackingStart {
  std::uint64_t seed = 1;
  unsigned threads = 0;  // 0: one for each core
  double seconds = 0;    // 0: until no better layout comes for a while
  std::optional<std::string> layout = {};
};

class PackingJob {
 public:
  /// Throws Error.
  PackingJob(const std::string& problem, const std::string& file, const PackingOptions& asked);
  ~PackingJob();
  PackingJob(const PackingJob&) = delete;
  PackingJob& operator=(const PackingJob&) = delete;

  /// A layout that is the best one for now.
  void begin_with(const packing::Layout& layout);
  const packing::Problem& problem() const { return problem_; }
  /// Goes on from the layout given, or else from the best one. Throws Error.
  void start(const PackingStart& start);
  void stop();
  /// Moves an item of the best layout, and the others out of its way; the result is the best layout then, at once.
  void repair(std::size_t item, std::array<double, 2> at);

  /// The parts; with `drawing` as path data with y down.
  std::string problem_json(bool drawing) const;
  /// With the layout where its number is above `since`.
  std::string state_json(std::uint64_t since) const;

 private:
  void search(packing::SearchOptions options, std::optional<packing::Layout> start);
  void keep(const packing::Layout& layout, const packing::SearchState& state);

  packing::Problem problem_;
  packing::Fraction bound_;
  std::thread thread_;
  std::atomic<bool> stop_ = false, running_ = false;
  mutable std::mutex guard_;  // of what follows
  std::optional<packing::Layout> best_;
  packing::SearchState state_;
  io::LayoutFacts facts_;
  std::uint64_t number_ = 0;
  std::string failure_;
};

}  // namespace findspace::app
