// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "batch/job_answer.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>

#include "batch/job_journal.h"
#include "command_line/command_line.h"
#include "common/inside_folder.h"
#include "common/run_limits.h"
#include "findspace/error.h"
#include "findspace/text.h"

namespace findspace::app {
namespace {

using Clock = std::chrono::steady_clock;

/// Line breaks of results stand between tokens only.
std::string one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text;
}

std::string head(const Job& job, std::size_t k, const JobEnd& end) {
  return fmt::format(R"({}"line": {}{}, "status": "{}", "exit": {}, "seconds": {:.6f})", result_head(k), job.line,
                     job.id.empty() ? "" : ", \"id\": " + job.id, status_word(end.status), int(end.status),
                     end.seconds);
}

Options options_of(const Job& job, const Options& batch) {
  Options options = parse_question(job.verb, job.arguments);
  options.json = true;
  options.scene_text = job.scene;
  if (!options.store.empty()) throw Error(ErrorCode::kUsage, "--store is of the whole batch, not of a question");
  if (options.time_limit == 0) options.time_limit = batch.time_limit;
  if (options.memory_limit == 0) options.memory_limit = batch.memory_limit;
  if (options.threads == 0) options.threads = std::max(1U, batch.threads);
  options.no_files = options.no_files || batch.no_files;
  if (!batch.root.empty()) options.root = batch.root;  // a question does not widen what the batch may read
  if (!options.scene_text && !options.root.empty() && !is_inside_folder(options.scene, options.root))
    throw Error(ErrorCode::kFile,
                fmt::format("the file lies outside the folder '{}', and others may not be read", options.root.string()),
                options.scene);
  options.input_limit = std::min(options.input_limit, batch.input_limit);
  options.work_limit = std::max(options.work_limit, batch.work_limit);
  return options;
}

/// While it lives, the memory of the process ends there.
class MemoryLimit {
 public:
  explicit MemoryLimit(std::uint64_t bytes) {
    getrlimit(RLIMIT_AS, &before_);
    rlimit now = before_;
    if (bytes > 0) now.rlim_cur = std::min<rlim_t>(bytes, before_.rlim_max);
    setrlimit(RLIMIT_AS, &now);
  }
  ~MemoryLimit() { setrlimit(RLIMIT_AS, &before_); }
  MemoryLimit(const MemoryLimit&) = delete;
  MemoryLimit& operator=(const MemoryLimit&) = delete;

 private:
  rlimit before_{};
};

struct Answer {
  std::string result;
  ExitStatus status;
};

Answer answer(const Job& job, const Options& options, std::vector<std::string>& notes) {
  Reporter reporter(notes);
  const RequestTime time(options.time_limit * (ends_in_time(job.verb) ? 1 + kLate : 1), "");
  const MemoryLimit memory(options.memory_limit);
  Outcome outcome = run_question(job.verb, options, reporter);
  if (outcome.stream) outcome.stream([&](std::string_view text) { outcome.text += text; });
  return {one_line(std::move(outcome.text)), outcome.status};
}

}  // namespace

std::string_view status_word(int status) {
  switch (status) {
    case kDone:
      return "done";
    case kEmpty:
      return "empty";
    case kUsage:
      return "usage";
    case kBadInput:
      return "bad input";
    case kLimit:
      return "limit";
    default:
      return "crashed";
  }
}

std::string failure_line(const Job& job, std::size_t k, const JobEnd& end) {
  return fmt::format(R"({}, "error": {}}})", head(job, k, end), json_string(end.why));
}

std::string answer_job(const Job& job, std::size_t k, const Options& batch) {
  if (!job.fault.empty()) return failure_line(job, k, {kUsage, job.fault, 0});
  const auto begun = Clock::now();
  const auto seconds = [&] { return std::chrono::duration<double>(Clock::now() - begun).count(); };
  try {
    std::vector<std::string> notes;
    const Answer got = answer(job, options_of(job, batch), notes);
    const std::string said = notes.empty() ? "" : fmt::format(R"(, "notes": {})", json_list(notes, json_string));
    return fmt::format(R"({}{}, "result": {}}})", head(job, k, {got.status, "", seconds()}), said,
                       got.result.empty() ? "null" : got.result);
  } catch (const Error& e) {
    return failure_line(job, k, {status_of(e), e.what(), seconds()});
  } catch (const std::bad_alloc&) {
    return failure_line(job, k, {kLimit, "the memory limit, or that of the system, is reached", seconds()});
  } catch (const std::exception& e) {
    return failure_line(job, k, {kInternal, fmt::format("internal error: {}", e.what()), seconds()});
  }
}

}  // namespace findspace::app
