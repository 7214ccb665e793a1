// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A packing, in the plane or in space, that goes on while requests are answered: a search on threads of its own, its
// best layout so far, what is wrong where one part is moved by hand, and repairs of the layout after that. Guarantee:
// every layout that is given away is proved. Threads: one request at a time, beside the search. Keywords: background
// job, progress, anytime algorithm.
#pragma once

#include <findspace/options.h>
#include <findspace/pack_search.h>

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace findspace::app {

struct PackingStart {
  std::uint64_t seed = 1;
  unsigned threads = 0;  // 0: one for each core
  double seconds = 0;    // 0: until no better layout comes for a while
};

/// An item of the best layout, and where it is moved to: as many numbers as there are dimensions, in a sheet or
/// container of the layout, its own where none is said.
struct MovedItem {
  std::size_t item = 0;
  std::vector<Number> at;
  std::optional<std::size_t> in = {};
};

class PackingJob {
 public:
  /// Throws Error.
  static std::unique_ptr<PackingJob> make(const std::string& problem, const PackReading& asked);
  virtual ~PackingJob() = default;
  PackingJob(const PackingJob&) = delete;
  PackingJob& operator=(const PackingJob&) = delete;

  /// Ends the search. The layout, as JSON or in a file of `most` bytes, is the best one from now on. Throws Error where
  /// it is not feasible.
  virtual void begin_with(const std::string& layout) = 0;
  virtual void begin_with_file(const std::filesystem::path& layout, std::uint64_t most) = 0;
  /// Goes on from the best layout.
  void start(const PackingStart& start);
  void stop();
  /// Moves an item of the best layout, and the others out of its way; the result is the best layout then, at once.
  virtual void repair(const MovedItem& moved) = 0;
  /// What is wrong with the best layout, with an item moved, as `verify --json` says it.
  virtual std::string verdict_json(const std::optional<MovedItem>& moved) const = 0;

  /// The parts; with `drawing` how they look: path data with y down, or faces in space.
  virtual std::string problem_json(bool drawing) const = 0;
  /// With the layout where its number is above `since`.
  std::string state_json(std::uint64_t since) const;

 protected:
  PackingJob() = default;
  virtual void search(const findspace::Options& options) = 0;
  /// The member "layout": ..., of the best one; nothing where there is none.
  virtual std::string layout_member() const = 0;
  /// How large a layout is: "length" or "height".
  virtual const char* size_word() const = 0;
  void count(const PackProgress& state);

  std::thread thread_;
  const Cancel stop_{};
  std::atomic<bool> running_ = false;
  mutable std::mutex guard_;  // of what follows, and of the best layout
  PackProgress state_;
  std::uint64_t number_ = 0;
  std::string failure_;
};

}  // namespace findspace::app
