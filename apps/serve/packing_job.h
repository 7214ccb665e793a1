// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A packing that goes on while requests are answered: a search on threads of its own, its best layout so far, and
// repairs of a layout after one part was moved by hand. Guarantee: every layout that is given away is proved. Threads:
// one request at a time, beside the search. Keywords: background job, progress, anytime algorithm.
#pragma once

#include <findspace/packing.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace findspace::app {

struct PackingStart {
  std::uint64_t seed = 1;
  unsigned threads = 0;  // 0: one for each core
  double seconds = 0;    // 0: until no better layout comes for a while
  std::optional<std::string> layout = {};
};

class PackingJob {
 public:
  /// Throws Error.
  PackingJob(const std::string& problem, const PackReading& asked);
  ~PackingJob();
  PackingJob(const PackingJob&) = delete;
  PackingJob& operator=(const PackingJob&) = delete;

  /// A layout that is the best one for now.
  void begin_with(const PackLayout& layout);
  const Packing& packing() const { return packing_; }
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
  void search(const findspace::Options& options, std::optional<PackLayout> start);
  void keep(const PackLayout& layout, const PackProgress& state);

  Packing packing_;
  std::thread thread_;
  const Cancel stop_;
  std::atomic<bool> running_ = false;
  mutable std::mutex guard_;  // of what follows
  std::optional<PackLayout> best_;
  PackProgress state_;
  std::uint64_t number_ = 0;
  std::string failure_;
};

}  // namespace findspace::app
