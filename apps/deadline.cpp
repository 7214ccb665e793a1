// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "deadline.h"

#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <string_view>
#include <utility>

#include "options.h"

namespace findspace::app {
namespace {

/// With calls only that a signal handler may make.
[[noreturn]] void end(std::string_view message, ExitStatus status) {
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, message.data(), message.size());
  _exit(status);
}

extern "C" void on_interrupt(int) { end("\nfindspace: interrupted, nothing was written\n", kInterrupted); }

}  // namespace

void end_on_interrupt() {
  struct sigaction action {};
  action.sa_handler = on_interrupt;
  sigaction(SIGINT, &action, nullptr);
}

Deadline::Deadline(double seconds, std::string last_words) : last_words_(std::move(last_words)) {
  if (seconds > 0) watch_ = std::thread([this, seconds] { wait(seconds); });
}

Deadline::~Deadline() {
  {
    std::lock_guard lock(guard_);
    done_ = true;
  }
  ended_.notify_one();
  if (watch_.joinable()) watch_.join();
}

void Deadline::wait(double seconds) {
  std::unique_lock lock(guard_);
  if (ended_.wait_for(lock, std::chrono::duration<double>(seconds), [this] { return done_; })) return;
  [[maybe_unused]] const ssize_t written = write(STDOUT_FILENO, last_words_.data(), last_words_.size());
  end("findspace: the time limit is reached; a map is whole or not at all, so nothing was written\n", kLimit);
}

}  // namespace findspace::app
