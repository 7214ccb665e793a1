// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The programs `findspace` and `findspace-mpi`: runs the verb of a command line, and turns whatever happens into an
// exit status and a line that says what was wrong. docs/commands.md is the manual.

#include <findspace/options.h>
#include <findspace/stages.h>
#include <findspace/store.h>
#include <findspace/team.h>
#include <fmt/format.h>
#include <malloc.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <memory>
#include <new>
#include <string>
#include <string_view>

#include "command_line/command_line.h"
#include "command_line/option_checks.h"
#include "command_line/verbs.h"
#include "common/begin_together.h"
#include "common/outputs.h"
#include "common/run_limits.h"

namespace findspace::app {
namespace {

/// The one of --store, or none. A batch leaves it to its workers.
std::unique_ptr<StoreScope> open_store(const VerbEntry& verb, const Options& options) {
  if (options.store.empty() || verb.is("batch")) return nullptr;
  return std::make_unique<StoreScope>(ResultStore(options.store, options.store_limit));
}

constexpr const char* kDump = "FINDSPACE_DUMP";

/// Of the folder that the environment names, or none.
std::unique_ptr<StageFiles> open_dump() {
  const char* folder = std::getenv(kDump);  // NOLINT(concurrency-mt-unsafe): nothing here sets the environment
  return folder == nullptr || *folder == '\0' ? nullptr : std::make_unique<StageFiles>(folder, kDump);
}

void finish_dump(const StageFiles& dump, Reporter& reporter) {
  dump.finish();
  const int files = dump.files(), left = dump.stages() - files;
  const std::string more = left > 0 ? fmt::format("; {} more stages have no file", left) : "";
  reporter.note(fmt::format("{}: {} file{} in {}{}", kDump, files, files == 1 ? "" : "s", dump.folder(), more));
}

Outcome run(const VerbEntry& verb, const Options& options, Reporter& reporter) {
  check_outputs(options, endings_of(verb.name));  // before anything is read
  const ThreadScope threads(options.threads);
  const TeamScope team(options.team);
  std::unique_ptr<StageFiles> dump;
  std::unique_ptr<StoreScope> store;
  begin_together(options, [&] {
    dump = open_dump();
    store = open_store(verb, options);
  });
  Outcome outcome = verb.run(options, reporter);
  if (dump) finish_dump(*dump, reporter);
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

/// The status, or that of what could not be written.
int printed(int status, Reporter& reporter) {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return status;
  reporter.error("standard output cannot be written");
  return kBadInput;
}

int finish(const Outcome& outcome, const Options& options, Reporter& reporter) {
  reporter.stage("");
  const bool wanted = is_printed(options);
  const auto put = [](std::string_view text) {
    begin_printing();
    std::fwrite(text.data(), 1, text.size(), stdout);
  };
  if (wanted && outcome.stream) outcome.stream(put);
  if (wanted) put(outcome.text);
  const int status = printed(outcome.status, reporter);
  if (status == outcome.status) end_limits();
  return status;
}

/// Processes that search together wait for one another after the limit, so the one that writes ends them all.
Options for_timer(Options options, std::string_view verb, const Team* team) {
  constexpr double kForOthers = 10;  // seconds
  if (team == nullptr || team->count() == 1 || !ends_in_time(verb) || options.time_limit == 0) return options;
  options.time_limit = team->leads() ? options.time_limit + kForOthers : 0;
  return options;
}

int program(int argc, char** argv, Team* team) {
  CommandLine line = read_command_line(argc, argv);
  if (line.verb.empty()) {
    Reporter reporter;
    return printed(line.answered, reporter);
  }
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

/// Lists of some megabytes that a step gives back serve the next step, in each thread. Otherwise the system takes their
/// pages away and clears new ones.
void keep_memory() {
#ifdef __GLIBC__
  mallopt(M_MMAP_THRESHOLD, 4 << 20);   // NOLINT: there is one thread yet
  mallopt(M_TRIM_THRESHOLD, 64 << 20);  // NOLINT: the same
#endif
}

}  // namespace

Outcome run_question(std::string_view verb, const Options& options, Reporter& reporter) {
  return run(*find_verb(verb), options, reporter);
}

int run_program(int argc, char** argv, Team* team) {
  keep_memory();
  end_on_signals();
  try {
    return program(argc, argv, team);
  } catch (...) {
    Reporter reporter;
    return report(reporter);
  }
}

}  // namespace findspace::app
