// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <algorithm>
#include <chrono>
#include <limits>

#include "common/commands.h"
#include "common/line_choice.h"
#include "common/run_limits.h"
#include "common/session.h"
#include "common/told.h"
#include "findspace/error.h"

namespace findspace::app {
namespace {

std::vector<std::string> formats_of(const Session& session) {
  if (session.in_space()) return space_formats();
  return is_board(session.options().scene) ? std::vector<std::string>{".svg", ".json", ".kicad_pcb"}
                                           : std::vector<std::string>{".svg", ".dxf", ".json"};
}

/// The verb for boards knows which of them it is.
Options as_placement(Options options) {
  options.place = true;
  return options;
}

}  // namespace

Outcome run_place(const Options& given, Reporter& reporter) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begun = Clock::now();  // reading counts
  const Options options = as_placement(given);
  const Session session(options, reporter);
  check_outputs(options, formats_of(session));
  if (options.resolution > 0 && !session.in_space()) throw Error(ErrorCode::kUsage, "--resolution is for 3D scenes");
  findspace::Options limits;
  if (options.time_limit > 0) {
    const double gone = std::chrono::duration<double>(Clock::now() - begun).count();
    limits.seconds = std::max(options.time_limit * kSearching - gone, std::numeric_limits<double>::min());
  }
  const Answer answer = session.scene().with(limits).place({{}, options.resolution});
  reporter.stage("writing");
  return told(session, answer);
}

}  // namespace findspace::app
