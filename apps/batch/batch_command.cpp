// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The verb `batch`: many questions over processes, machines and restarts. What is done stands in the journal; what is
// asked again is only what is not.
#include <fmt/format.h>
#include <signal.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <map>
#include <memory>
#include <set>
#include <thread>

#include "batch/job_answer.h"
#include "batch/job_journal.h"
#include "batch/job_list.h"
#include "batch/job_workers.h"
#include "common/begin_together.h"
#include "common/commands.h"
#include "common/run_limits.h"
#include "findspace/error.h"
#include "findspace/team.h"
#include "findspace/text.h"

namespace findspace::app {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds kLook{200};  // how often the work of others is looked at

double seconds_since(Clock::time_point begun) { return std::chrono::duration<double>(Clock::now() - begun).count(); }

class Batch {
 public:
  Batch(const Options& options, Reporter& reporter)
      : options_(options),
        reporter_(reporter),
        jobs_(options.scene, options.input_limit),
        journal_(options.outputs.front(), jobs_.digest(), jobs_.size()),
        before_(journal_.done()) {
    if (options_.store.empty()) options_.store = journal_.folder() / "store";
  }

  void run() {
    JobWorkers workers(jobs_, options_, worker_count());
    while (journal_.done() < jobs_.size() && !journal_.over()) {
      while (workers.idle() && give_next(workers)) {
      }
      if (workers.busy() == 0) {  // what is left is in the hands of other processes
        wait_for_others();
        continue;
      }
      for (const JobWorkers::Result& r : workers.wait(kLook)) take(r, workers);
      look_at_others();
      say_progress();
    }
  }

  Outcome finish() {
    journal_.finish();
    std::map<std::string, std::size_t> ends;
    std::ifstream results(options_.outputs.front());
    for (std::string line; std::getline(results, line);) ++ends[word_of(line)];
    const std::size_t good = ends["done"] + ends["empty"];
    return {summary(ends), good == jobs_.size() ? kDone : kBadInput};
  }

 private:
  std::size_t worker_count() const {
    const unsigned usual = options_.team != nullptr ? 1 : std::max(1U, std::thread::hardware_concurrency());
    const std::size_t wanted = options_.workers > 0 ? options_.workers : usual;
    return std::min(wanted, jobs_.size());
  }

  /// From the first that may be open on; those of others are looked at again when they are the only ones left.
  bool give_next(JobWorkers& workers) {
    for (; next_ < jobs_.size(); ++next_)
      if (journal_.claim(next_)) {
        workers.give(next_++);
        return true;
      }
    return false;
  }

  /// A question whose process was killed is asked once more: memory may have been short, or someone was impatient.
  void take(const JobWorkers::Result& r, JobWorkers& workers) {
    if (r.killed && killed_.insert(r.job).second) return workers.give(r.job);
    journal_.record(r.job, r.line);
    if (options_.as_they_come) print(result_line(r.job, r.line));
  }

  /// What they have answered needs no lock any more.
  void look_at_others() {
    if (Clock::now() - looked_ < kLook) return;
    journal_.refresh();
    looked_ = Clock::now();
  }

  void wait_for_others() {
    journal_.refresh();
    if (journal_.done() == jobs_.size()) return;
    next_ = 0;  // a process that held one may have ended without an answer
    while (next_ < jobs_.size() && journal_.done(next_)) ++next_;
    std::this_thread::sleep_for(kLook);
  }

  void say_progress() {
    const double seconds = seconds_since(begun_);
    const double rate = double(journal_.done() - before_) / std::max(seconds, 1e-3);  // no sign: of a clock
    const std::size_t left = jobs_.size() - journal_.done();
    reporter_.stage(fmt::format("{} of {} questions, {:.3g} a second{}", journal_.done(), jobs_.size(), rate,
                                rate > 0 ? fmt::format(", {:.0f} s left", double(left) / rate) : ""));
  }

  static void print(const std::string& line) {
    std::fwrite(line.data(), 1, line.size(), stdout);
    std::fputc('\n', stdout);
    std::fflush(stdout);
  }

  static std::string word_of(const std::string& line) {
    constexpr std::string_view kKey = "\"status\": \"";
    const std::size_t start = line.find(kKey) + kKey.size();
    return line.substr(start, line.find('"', start) - start);
  }

  std::string summary(const std::map<std::string, std::size_t>& ends) const {
    std::string text;
    for (const auto& [word, count] : ends) {
      if (count == 0) continue;
      text += options_.json ? fmt::format(", {}: {}", json_string(word), count)
                            : fmt::format("{}{} {}", text.empty() ? "" : ", ", count, word);
    }
    const double seconds = seconds_since(begun_);
    if (options_.json)
      return fmt::format("{{\"questions\": {}, \"before\": {}, \"seconds\": {:.3f}{}}}\n", jobs_.size(), before_,
                         seconds, text);
    return fmt::format("{} question{} in {:.3g} s{}: {}\n", jobs_.size(), jobs_.size() == 1 ? "" : "s", seconds,
                       before_ > 0 ? fmt::format(" ({} were answered before)", before_) : "", text);
  }

  Options options_;
  Reporter& reporter_;
  JobList jobs_;
  JobJournal journal_;
  std::size_t before_, next_ = 0;
  std::set<std::size_t> killed_;
  Clock::time_point begun_ = Clock::now(), looked_ = begun_;
};

}  // namespace

Outcome run_batch(const Options& options, Reporter& reporter) {
  if (options.outputs.size() != 1) throw Error(ErrorCode::kUsage, "batch writes one file: -o RESULTS.jsonl");
  signal(SIGPIPE, SIG_IGN);  // a worker that has ended is noticed by its pipe
  say_at_the_end("what is answered is kept: the same command goes on from there");
  std::unique_ptr<Batch> batch;
  begin_together(options, [&] { batch = std::make_unique<Batch>(options, reporter); });
  batch->run();
  return batch->finish();
}

}  // namespace findspace::app
