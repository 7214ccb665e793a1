// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Questions under the limits of their options. Guarantee: a question that meets a limit throws Stopped, and nothing
// else changes. Cost: none without limits.
#pragma once

#include <atomic>
#include <chrono>
#include <mutex>
#include <optional>
#include <type_traits>

#include "findspace/options.h"
#include "plane/base/search_work.h"
#include "plane/base/stop_check.h"

namespace findspace::api {

/// The limits of one question, from when it begins, and those of the thread that asks.
class Watch : public plane::StopCheck {
 public:
  /// Error(kBadValue) where the seconds or the work are below 0 or no numbers.
  explicit Watch(const Options& options);
  void poll() override;

 private:
  using Clock = std::chrono::steady_clock;

  const Options& options_;
  plane::StopCheck* const outer_ = plane::stop_check();
  const Clock::time_point begun_ = Clock::now();
  std::atomic<std::int64_t> memory_due_{0};  // milliseconds from the beginning
};

/// What `question` says, within the limits.
template <class F>
auto limited(const Options& options, const F& question) -> std::invoke_result_t<F> {
  std::optional<std::invoke_result_t<F>> out;
  Watch watch(options);
  const plane::SearchLimit most{options.work_limit};
  const plane::SearchLimit* const work = options.work_limit == 0 ? plane::ScopedSearchLimit::now() : &most;
  plane::with_threads(options.threads, [&] {
    const plane::ScopedStopCheck here(&watch);
    const plane::ScopedSearchLimit allowed(work);
    watch.poll();
    out.emplace(question());
  });
  return *std::move(out);
}

/// Reports parts of a question about many positions.
class Progress {
 public:
  Progress(const Options& options, std::size_t blocks) : options_(options), blocks_(blocks) {}
  /// Another block is answered.
  void add();

 private:
  const Options& options_;
  const std::size_t blocks_;
  std::mutex guard_;
  std::size_t done_ = 0;
};

}  // namespace findspace::api
