// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The verb `view`: the scene in a page of the browser, answered by this process.
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>

#include "common/commands.h"
#include "serve/json_rpc.h"
#include "serve/page_server.h"

extern char** environ;

namespace findspace::app {
namespace {

/// With the system's own program; false where there is none.
bool open_browser(std::string link) {
  std::string program = "xdg-open";
  std::array<char*, 3> arguments{program.data(), link.data(), nullptr};
  pid_t child = 0;
  if (posix_spawnp(&child, program.c_str(), nullptr, nullptr, arguments.data(), environ) != 0) return false;
  int status = 0;
  return waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace

Outcome run_view(const Options& options, Reporter& reporter) {
  reporter.stage("reading the scene");
  SceneStore store(options);
  JsonRpc rpc(store, options.time_limit, JsonRpc::Late::kSilent);
  PageServer server(options.port, built_in_page(), store.has_packing() ? "packing" : "scene",
                    [&](const std::string& request) { return rpc.answer(request); });
  reporter.stage("");
  fmt::print("{}\n", server.link());
  std::fflush(stdout);
  if (!options.no_open && !open_browser(server.link())) reporter.note("no browser was opened: open the link above");
  server.run();
  return {};
}

}  // namespace findspace::app
