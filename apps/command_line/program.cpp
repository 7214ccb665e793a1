// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The programs `findspace` and `findspace-mpi`: runs the verb of a command line, and turns whatever happens into an
// exit status and a line that says what was wrong. docs/commands.md is the manual.

#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <string_view>

#include "command_line/command_line.h"
#include "command_line/option_checks.h"
#include "command_line/verbs.h"
#include "common/process_team.h"
#include "common/run_limits.h"
#include "common/session.h"
#include "common/stage_dump.h"
#include "io/text/read_text.h"
#include "plane/base/parallel.h"
#include "store/result_file.h"

namespace findspace::app {
namespace {

/// The one of --store; where there is none, or the thread has one, nothing. A batch leaves it to its workers.
std::unique_ptr<ResultFile> open_store(const VerbEntry& verb, const Options& options) {
  if (options.store.empty() || verb.is("batch") || plane::result_store() != nullptr) return nullptr;
  return std::make_unique<ResultFile>(options.store, options.store_limit);
}

Outcome run(const VerbEntry& verb, const Options& options, Reporter& reporter) {
  check_outputs(options, endings_of(verb.name));  // before anything is read
  const plane::ThreadLimit threads(options.threads);
  const auto dump = StageDump::from_environment();
  const plane::ObserveStages observe(dump.get());
  const io::TextReader shared = [&](const auto& read) { return options.team->shared_text(read); };
  const io::ReadTextBy reading(options.team == nullptr ? nullptr : &shared);
  const io::RowsByTeam rows(options.team);
  const auto store = open_store(verb, options);
  const plane::ScopedResultStore kept(store ? store.get() : plane::result_store());
  Outcome outcome = verb.run(options, reporter);
  if (dump) dump->finish(reporter);
  return outcome;
}

/// What went wrong, as an exit status; said on standard error.
int report(Reporter& reporter) {
  try {
    throw;
  } catch (const Error& e) {
    reporter.error(e);
    return status_of(e);
  } catch (const std::bad_alloc&) {
    end_out_of_memory();
  } catch (const std::exception& e) {
    reporter.error(
        fmt::format("internal error: {}\nThis is a bug of findspace. Please report it with the scene.", e.what()));
  } catch (...) {
    reporter.error("internal error\nThis is a bug of findspace. Please report it with the scene.");
  }
  return kInternal;
}

int finish(const Outcome& outcome, const Options& options, Reporter& reporter) {
  reporter.stage("");
  const bool wanted = is_printed(options);
  const auto put = [](std::string_view text) { std::fwrite(text.data(), 1, text.size(), stdout); };
  begin_printing();
  if (wanted && outcome.stream) outcome.stream(put);
  if (wanted) put(outcome.text);
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    reporter.error("standard output cannot be written");
    return kBadInput;
  }
  end_limits();
  return outcome.status;
}

/// Processes that search together wait for one another after the limit, so the one that writes ends them all.
Options for_timer(Options options, std::string_view verb, const ProcessTeam* team) {
  constexpr double kForOthers = 10;  // seconds
  if (team == nullptr || team->count() == 1 || !ends_in_time(verb) || options.time_limit == 0) return options;
  options.time_limit = team->leads() ? options.time_limit + kForOthers : 0;
  return options;
}

int program(int argc, char** argv, ProcessTeam* team) {
  CommandLine line = read_command_line(argc, argv);
  if (line.verb.empty()) return line.answered;
  const VerbEntry& verb = *find_verb(line.verb);
  Options& options = line.options;
  if (team != nullptr && !verb.is_shared()) {
    if (!team->leads()) return kDone;
    team = nullptr;
  }
  options.team = team;
  if (team != nullptr && options.threads == 0) options.threads = 1;  // a rank for each core
  Reporter reporter(options.quiet);
  try {
    const bool batch = verb.is("batch");
    // A server and a batch have a limit for each request.
    Options limited = options;
    if (verb.is_service() || batch) limited.time_limit = 0;
    if (batch) limited.memory_limit = 0;  // of each question
    set_limits(for_timer(limited, line.verb, team), ends_in_time(line.verb));
    const bool writes = team == nullptr || team->leads() || batch;
    if (!writes) limited.outputs.clear();
    return finish(run(verb, writes ? options : limited, reporter), options, reporter);
  } catch (...) {
    return report(reporter);
  }
}

}  // namespace

Outcome run_question(std::string_view verb, const Options& options, Reporter& reporter) {
  return run(*find_verb(verb), options, reporter);
}

int run_program(int argc, char** argv, ProcessTeam* team) {
  end_on_signals();
  try {
    return program(argc, argv, team);
  } catch (...) {
    Reporter reporter;
    return report(reporter);
  }
}

}  // namespace findspace::app
