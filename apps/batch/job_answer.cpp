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
#include "placing/stated_problem.h"

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

/// Those that a question names, to be read or written.
std::vector<std::filesystem::path> files_of(const Job& job, const Options& options) {
  std::vector<std::filesystem::path> files = options.outputs;
  if (!job.scene) files.emplace_back(options.scene);
  if (options.start) files.push_back(*options.start);
  if (job.verb == "pack" || job.verb == "verify")
    for (const std::string& word : files_among(options.shapes)) files.emplace_back(word);
  return files;
}

void check_root(const Job& job, const Options& options) {
  if (options.root.empty()) return;
  for (const std::filesystem::path& file : files_of(job, options))
    if (!is_inside_folder(file, options.root))
      throw Error(
          ErrorCode::kFile,
          fmt::format("the file lies outside the folder '{}', and others may not be used", options.root.string()),
          file.string());
}

/// The lower of two limits of which 0 is none.
template <class T>
T lower_limit(T own, T batch) {
  return own == 0 || (batch != 0 && batch < own) ? batch : own;
}

/// A question narrows what the batch allows and does not widen it.
Options options_of(const Job& job, const Options& batch) {
  Options usual;
  usual.input_limit = batch.input_limit;
  usual.work_limit = batch.work_limit;
  Options options = parse_question(job.verb, job.arguments, usual);
  options.json = true;
  options.scene_text = job.scene;
  if (!options.store.empty()) throw Error(ErrorCode::kUsage, "--store is of the whole batch, not of a question");
  options.time_limit = lower_limit(options.time_limit, batch.time_limit);
  options.memory_limit = lower_limit(options.memory_limit, batch.memory_limit);
  options.input_limit = std::min(options.input_limit, batch.input_limit);
  options.work_limit = std::min(options.work_limit, batch.work_limit);
  options.threads = std::max(1U, lower_limit(options.threads, batch.threads));
  options.no_files = options.no_files || batch.no_files;
  if (!batch.root.empty() && (options.root.empty() || !is_inside_folder(options.root, batch.root)))
    options.root = batch.root;
  check_root(job, options);
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
  const RequestLimits limits(options.time_limit * (ends_in_time(job.verb) ? 1 + kLate : 1));
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
