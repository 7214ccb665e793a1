// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The command line of the program and of one verb, for whoever runs verbs beside it: the same words, checks and
// messages.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "common/options.h"
#include "common/reporter.h"

namespace findspace::app {

/// Whether a line of `batch` may ask it: a verb that answers once and ends.
bool is_question(std::string_view verb);
/// The names of these, for messages.
std::vector<std::string> question_names();

/// What stands after the verb, as options; those that are not named are the usual ones. Throws Error(kUsage) with the
/// message that the program would print.
Options parse_question(std::string_view verb, std::vector<std::string> arguments, Options usual);

/// Checks the outputs, then runs the verb with the threads of the options. Throws what the verb throws.
Outcome run_question(std::string_view verb, const Options& options, Reporter& reporter);

/// It ends in time by itself, with the best result so far.
bool ends_in_time(std::string_view verb);

/// A command line that was read: a verb and its options, or no verb where it was answered or refused.
struct CommandLine {
  std::string verb;
  Options options;
  ExitStatus answered = kDone;
};

/// Prints help and messages itself.
CommandLine read_command_line(int argc, char** argv);

/// The whole program; returns its exit status. `team`: of processes that run it together, or null.
int run_program(int argc, char** argv, Team* team);

}  // namespace findspace::app
