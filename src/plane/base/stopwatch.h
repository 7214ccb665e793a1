// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// How long something took, for reports: nothing is decided by it. Keywords: clock, timing.
#pragma once

#include <chrono>

namespace findspace::plane {

class Stopwatch {
 public:
  /// Since it was made.
  double milliseconds() const { return std::chrono::duration<double, std::milli>(Clock::now() - start_).count(); }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

}  // namespace findspace::plane
