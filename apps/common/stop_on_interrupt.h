// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// While it lives Ctrl-C and a polite end of the process end the search, and the best result is kept.
#pragma once

#include <findspace/options.h>
#include <signal.h>

namespace findspace::app {

class StopOnInterrupt {
 public:
  StopOnInterrupt();
  ~StopOnInterrupt();
  StopOnInterrupt(const StopOnInterrupt&) = delete;
  StopOnInterrupt& operator=(const StopOnInterrupt&) = delete;

  /// Is requested when an end is asked for.
  static const Cancel& wanted();

 private:
  struct sigaction interrupt_ {
  }, terminate_{};
};

}  // namespace findspace::app
