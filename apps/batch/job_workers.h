// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Processes that answer the questions of a batch, one at a time each. A question that crashes, hangs, or reaches its
// limit ends its process alone: it gets a result that says so, and another process takes the place. The processes end
// with the one that made them. Keywords: process pool, fork, prctl.
#pragma once

#include <findspace/store.h>
#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "batch/job_list.h"
#include "common/options.h"

namespace findspace::app {

class JobWorkers {
 public:
  /// Refers to the list and the options. Throws Error(kLimit) where the system gives no process.
  JobWorkers(const JobList& jobs, const Options& batch, std::size_t count);
  ~JobWorkers();
  JobWorkers(const JobWorkers&) = delete;
  JobWorkers& operator=(const JobWorkers&) = delete;

  bool idle() const { return busy_ < workers_.size(); }
  std::size_t busy() const { return busy_; }
  /// Gives the question to an idle process.
  void give(std::size_t job);

  struct Result {
    std::size_t job;
    std::string line;
    bool killed = false;  // its process was ended from outside, which says nothing of the question
  };
  /// What has been answered, after at most that time; nothing where nothing has.
  std::vector<Result> wait(std::chrono::milliseconds most);

 private:
  using Clock = std::chrono::steady_clock;
  struct Worker {
    pid_t process = -1;
    int questions = -1, answers = -1, errors = -1;
    std::optional<std::size_t> job;
    Clock::time_point begun;
    double limit = 0;  // seconds after which it is killed from here; 0: never
    std::string answer, said;
  };

  void start(Worker& worker);
  void stop(Worker& worker);
  std::unique_ptr<StoreScope> open_store() const;
  [[noreturn]] void serve(int questions, int answers, int errors);
  Result end_of(Worker& worker);
  void read(Worker& worker, std::vector<Result>& out);
  double limit_of(const Job& job) const;

  const JobList& jobs_;
  const Options& batch_;
  std::vector<Worker> workers_;
  std::size_t busy_ = 0;
};

}  // namespace findspace::app
