// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The ways in which a run ends early: a signal, the time limit, the memory limit. An exact map is whole or not at all.
// So the process ends at once, wherever it is, with its status and a line that says what was written. Temporary files
// are removed. Guarantee: no allocation and no lock on the way out. Keywords: SIGINT, SIGTERM, setitimer, RLIMIT_AS.
#pragma once

#include <string>

#include "common/options.h"
#include "findspace/error.h"

namespace findspace::app {

/// From now on SIGINT, SIGTERM and SIGHUP end the process with 128 plus their number, unless they are ignored.
void end_on_signals();

/// Sets the time and memory limits of the options; reaching one ends the process with status 4, without an answer. A
/// verb that ends in time by itself is stopped only where it is late by more than kLate of its time.
void set_limits(const Options& options, bool ends_in_time);
inline constexpr double kLate = 0.05;
/// Of its time, what such a verb may spend before it writes.
inline constexpr double kSearching = 0.85;

/// While it lives, the limits of one request: where its time is over, or memory, the process ends with status 4.
/// Before, it says why on standard output, to the program that waits for an answer there. No seconds, no limit of time.
class RequestLimits {
 public:
  explicit RequestLimits(double seconds, std::string when_late = "", std::string without_memory = "");
  ~RequestLimits();
  RequestLimits(const RequestLimits&) = delete;
  RequestLimits& operator=(const RequestLimits&) = delete;

 private:
  std::string when_late_, without_memory_;
};

/// What an end by a signal says instead of "nothing was written"; the text lives as long as the process.
void say_at_the_end(const char* text);
/// From now on the time limit of the options is no failure: it ends the process with status 0 after this answer on
/// standard output. Called by one thread; the answer before it stays until the next.
void answer_at_the_end(std::string text);
/// The result is being printed: from now on a part of it may stand there.
void begin_printing();
/// All is done: no limit ends the process any more.
void end_limits();

/// The end by want of memory.
[[noreturn]] void end_out_of_memory();

/// The status for an error of the input.
ExitStatus status_of(const Error& error);

}  // namespace findspace::app
