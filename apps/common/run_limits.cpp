// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "common/run_limits.h"

#include <gmp.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <new>
#include <string_view>
#include <utility>

#include "findspace/text.h"

namespace findspace::app {
namespace {

// With calls only that a signal handler may make.

volatile sig_atomic_t printing = 0;
std::string_view when_late;       // set while no timer runs
std::string_view without_memory;  // set while a request is answered
std::string_view kept;            // what is there when nothing was written

std::array<std::string, 2> answers;
std::atomic<const std::string*> answer;  // one of them
bool is_answered_at_the_end = false;
static_assert(std::atomic<const std::string*>::is_always_lock_free);

void put(std::string_view text, int file = STDERR_FILENO) {
  while (!text.empty()) {
    const ssize_t n = write(file, text.data(), text.size());
    if (n <= 0) return;
    text.remove_prefix(static_cast<std::size_t>(n));
  }
}

[[noreturn]] void end(std::string_view why, int status) {
  const Written written = remove_unfinished_files();
  put("\nfindspace: ");
  put(why);
  if (printing != 0 || written == Written::kPart) {
    put("; what was printed is not whole\n");
  } else if (written == Written::kFiles) {
    put("; the files that were replaced are whole\n");
  } else if (!kept.empty()) {
    put("; ");
    put(kept);
    put("\n");
  } else {
    put("; nothing was written\n");
  }
  _exit(status);
}

extern "C" void on_signal(int signal) {
  constexpr int kBySignal = 128;
  if (const std::string* text = answer;
      signal == SIGALRM && text != nullptr && printing == 0 && remove_unfinished_files() != Written::kPart) {
    put(*text, STDOUT_FILENO);
    _exit(kDone);
  }
  if (signal == SIGALRM) put(when_late, STDOUT_FILENO);
  if (signal == SIGALRM) end("the time limit is reached, which --time-limit raises", kLimit);
  end(signal == SIGINT ? "interrupted" : "ended by a signal", kBySignal + signal);
}

void handle(int signal) {
  struct sigaction action {};
  action.sa_handler = on_signal;
  sigfillset(&action.sa_mask);
  sigaction(signal, &action, nullptr);
}

// GMP would abort.

void* gmp_again(void* old, std::size_t, std::size_t size) {
  void* made = std::realloc(old, size);
  if (made == nullptr) end_out_of_memory();
  return made;
}
void* gmp_new(std::size_t size) { return gmp_again(nullptr, 0, size); }
void gmp_free(void* old, std::size_t) { std::free(old); }

void set_timer(double seconds) {
  itimerval time{};
  double whole = 0;
  constexpr double kMicroseconds = 1e6;
  time.it_value.tv_usec = static_cast<suseconds_t>(std::modf(seconds, &whole) * kMicroseconds);
  time.it_value.tv_sec = static_cast<time_t>(whole);
  if (seconds > 0 && time.it_value.tv_sec == 0 && time.it_value.tv_usec == 0) time.it_value.tv_usec = 1;
  setitimer(ITIMER_REAL, &time, nullptr);
}

}  // namespace

void end_on_signals() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction before {};
    sigaction(signal, nullptr, &before);
    if (before.sa_handler != SIG_IGN) handle(signal);  // nohup
  }
  std::set_new_handler(end_out_of_memory);
  mp_set_memory_functions(gmp_new, gmp_again, gmp_free);
}

void set_limits(const Options& options, bool ends_in_time) {
  if (options.time_limit > 0) {
    handle(SIGALRM);
    is_answered_at_the_end = ends_in_time;
    set_timer(options.time_limit * (ends_in_time ? 1 + kLate : 1));
  }
  if (options.memory_limit > 0) {
    const rlimit most{options.memory_limit, options.memory_limit};
    if (setrlimit(RLIMIT_AS, &most) != 0)
      throw Error(ErrorCode::kUsage, "--memory-limit is above what the system allows this process");
  }
}

RequestLimits::RequestLimits(double seconds, std::string late, std::string memory)
    : when_late_(std::move(late)), without_memory_(std::move(memory)) {
  without_memory = without_memory_;
  if (seconds <= 0) return;
  when_late = when_late_;
  handle(SIGALRM);
  set_timer(seconds);
}
RequestLimits::~RequestLimits() {
  set_timer(0);
  when_late = without_memory = {};
}

void say_at_the_end(const char* text) { kept = text; }

void answer_at_the_end(std::string text) {
  if (!is_answered_at_the_end) return;
  std::string& free = answers[answer == &answers[0] ? 1 : 0];
  free = std::move(text);
  answer = &free;
}

void begin_printing() { printing = 1; }

void end_limits() {
  set_timer(0);
  printing = 0;
}

void end_out_of_memory() {
  put(without_memory, STDOUT_FILENO);
  end("the memory limit, which --memory-limit raises, or that of the system is reached", kLimit);
}

ExitStatus status_of(const Error& error) {
  switch (error.code()) {
    case ErrorCode::kUsage:
      return kUsage;
    case ErrorCode::kLimit:
      return kLimit;
    default:
      return kBadInput;
  }
}

}  // namespace findspace::app
