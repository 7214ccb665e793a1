// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The two ways in which a computation ends early: --time-limit and Ctrl-C. An exact map is whole or not at all, so
// there is no best result so far: the process ends at once, with its status and a line that says so, and without files.
#pragma once

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace findspace::app {

/// From now on Ctrl-C ends the process with exit status 130.
void end_on_interrupt();

/// While it lives the process ends with exit status 4 when the time is over.
class Deadline {
 public:
  /// `seconds` <= 0: none.
  explicit Deadline(double seconds) : Deadline(seconds, {}) {}
  /// Then `last_words` are written to standard output, for programs that wait for an answer there.
  Deadline(double seconds, std::string last_words);
  ~Deadline();
  Deadline(const Deadline&) = delete;
  Deadline& operator=(const Deadline&) = delete;

 private:
  void wait(double seconds);

  std::string last_words_;
  std::mutex guard_;
  std::condition_variable ended_;
  bool done_ = false;
  std::thread watch_;
};

}  // namespace findspace::app
