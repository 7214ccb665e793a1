// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// One measurement: a job is run in a process of its own, so that a rival that runs for ever, out of memory or into an
// error ends only itself, and so that its max_min memory is its own.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace bench {

struct Measurement {
  enum class Outcome { kDone, kTooLong, kFailed, kNone } outcome = Outcome::kNone;
  double median_ms = 0;  // of `runs` runs
  int runs = 0;
  double peak_mib = 0;     // resident memory beyond that at the start
  std::size_t result = 0;  // what the job returned
};

/// Runs the job at least once and until half a second or 15 runs are reached; gives up after `limit_s`.
Measurement measure(const std::function<std::size_t()>& job, double limit_s);

}  // namespace bench
