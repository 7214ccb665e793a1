// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// How much a question may cost, and who hears of it: one object for all questions of a World (World::with), for
// placements, packings and samples. A question that meets a limit ends with `Stopped`, which says which limit it was:
// an exact answer is whole or not at all. The world can be asked again. A search gives the best that it found by then.
// Limits are looked at between tasks, so a question may go on for a moment. Error(kBadValue) of a question whose limit
// is below 0. Keywords: timeout, cancellation token,
// progress, seed.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>

#include "findspace/error.h"

namespace findspace {

/// A token: copies are one. Requested from any thread, it ends the questions that have it.
class Cancel {
 public:
  /// Ends what has the token.
  void request() const { *requested_ = true; }
  /// Later questions run again.
  void reset() const { *requested_ = false; }
  /// Whether it is requested.
  bool requested() const { return *requested_; }

 private:
  std::shared_ptr<std::atomic<bool>> requested_ = std::make_shared<std::atomic<bool>>(false);
};

/// While it lives, questions of this thread end when the token is requested, whatever their worlds' options.
class CancelScope {
 public:
  /// From now on, in this thread.
  explicit CancelScope(const Cancel& cancel);
  ~CancelScope();
  CancelScope(const CancelScope&) = delete;
  CancelScope& operator=(const CancelScope&) = delete;

 private:
  struct Limits;
  std::unique_ptr<Limits> limits_;
};

/// While it lives, at most so many threads of the process work at once, whatever options say; 0: one for each core.
class ThreadScope {
 public:
  /// From now on.
  explicit ThreadScope(unsigned threads);
  ~ThreadScope();
  ThreadScope(const ThreadScope&) = delete;
  ThreadScope& operator=(const ThreadScope&) = delete;

 private:
  struct Limits;
  std::unique_ptr<Limits> limits_;
};

struct Options {
  unsigned threads = 0;    // 0: one for each core
  double seconds = 0;      // of each question; 0: no limit
  std::size_t memory = 0;  // bytes that the process has in memory; 0: no limit
  /// Of questions about many positions: which part of them is answered, from 0 to 1. Called from one thread at a time.
  std::function<void(double)> progress{};
  Cancel cancel{};
  /// Of what is random, packings and samples: the same seed brings the same result.
  std::uint64_t seed = 1;
  double work = 0;  // of packings, in million pairs of parts looked at; 0: no limit
  /// Units that explanations and the searches of a question in space may cost, as with `--work-limit`; 0: as many as
  /// reading allowed.
  std::uint64_t work_limit = 0;
};

/// What a question met.
enum class Limit { kTime, kMemory, kCancelled };

/// A question that ended at a limit.
class Stopped : public Error {
 public:
  /// With a message of that limit.
  explicit Stopped(Limit limit)
      : Error(ErrorCode::kUnsupported, limit == Limit::kTime     ? "the time limit is reached"
                                       : limit == Limit::kMemory ? "the memory limit is reached"
                                                                 : "cancelled"),
        limit_(limit) {}
  /// Which limit it was.
  Limit limit() const { return limit_; }

 private:
  Limit limit_;
};

}  // namespace findspace
