// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The answer to one question of a batch as a line of JSON: its line and id, how it ended, how long that took, and the
// result of its verb, or what was wrong.
#pragma once

#include <string>
#include <string_view>

#include "batch/job_list.h"
#include "common/options.h"

namespace findspace::app {

/// How a question ended; `why` is what the program would have said.
struct JobEnd {
  ExitStatus status = kDone;
  std::string why;
  double seconds = 0;
};

/// Answers the question with the limits of the batch where it has none of its own. May end the process, where a limit
/// is reached: then the line of the result says so by `failure_line`.
std::string answer_job(const Job& job, std::size_t k, const Options& batch);

/// The line for a question without a result.
std::string failure_line(const Job& job, std::size_t k, const JobEnd& end);

/// The word of an exit status: "done", "empty", "usage", "bad input", "limit", "crashed".
std::string_view status_word(int status);

}  // namespace findspace::app
