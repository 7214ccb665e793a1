// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "measure.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <stdexcept>
#include <vector>

namespace bench {
namespace {

double peak_kib() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return double(usage.ru_maxrss);
}

struct Times {
  double clock, processor;  // ms
};

Times now() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  const auto clock = std::chrono::steady_clock::now().time_since_epoch();
  return {std::chrono::duration<double, std::milli>(clock).count(), double(t.tv_sec) * 1e3 + double(t.tv_nsec) / 1e6};
}

/// Of the processor, as the machine may do much else; what is short by the clock, which is asked at less cost.
double milliseconds(const Times& from, const Times& to) {
  constexpr double kShort = 0.1;
  const double clock = to.clock - from.clock;
  return clock < kShort ? clock : to.processor - from.processor;
}

Measurement run(const std::function<std::size_t()>& job) {
  Measurement m{.outcome = Measurement::Outcome::kDone};
  double before = peak_kib(), total = 0;
  std::vector<double> times;
  while (times.empty() || (total < 500 && times.size() < 15)) {
    const Times begun = now();
    m.result = job();
    times.push_back(milliseconds(begun, now()));
    total += times.back();
  }
  std::nth_element(times.begin(), times.begin() + std::ptrdiff_t(times.size() / 2), times.end());
  m.median_ms = times[times.size() / 2];
  m.runs = int(times.size());
  m.peak_mib = (peak_kib() - before) / 1024;
  return m;
}

[[noreturn]] void child(const std::function<std::size_t()>& job, int out, double limit_s) {
  alarm(unsigned(limit_s) + 1);
  try {
    Measurement m = run(job);
    bool written = write(out, &m, sizeof m) == ssize_t(sizeof m);
    _exit(written ? 0 : 1);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "  %s\n", e.what());
  } catch (...) {
    std::fprintf(stderr, "  unknown exception\n");
  }
  _exit(1);
}

}  // namespace

Measurement measure(const std::function<std::size_t()>& job, double limit_s) {
  if (!job) return {};
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("no pipe");
  std::fflush(nullptr);
  pid_t pid = fork();
  if (pid < 0) throw std::runtime_error("no process");
  if (pid == 0) child(job, ends[1], limit_s);
  close(ends[1]);
  Measurement m;
  bool complete = read(ends[0], &m, sizeof m) == ssize_t(sizeof m);
  close(ends[0]);
  int status = 0;
  waitpid(pid, &status, 0);
  if (complete) return m;
  bool alarmed = WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM;
  return {.outcome = alarmed ? Measurement::Outcome::kTooLong : Measurement::Outcome::kFailed};
}

}  // namespace bench
