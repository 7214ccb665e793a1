// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "in_plane/board_check.h"

#include <findspace/board.h>

#include "common/board_groups.h"
#include "common/outputs.h"

namespace findspace::app {

Outcome check_board(const Options& options, Reporter& reporter) {
  reporter.stage("reading the scene");
  const Board board =
      Board::file(options.scene, {options.scene, asked_groups(options), options.fixed, options.input_limit});
  for (const std::string& note : board.notes()) reporter.note(note);
  check_outputs(options, {".svg", ".json"});
  reporter.stage("checking");
  const BoardVerdict verdict =
      board.check(options.where.empty() ? std::nullopt : std::optional<Formula>(options.where), "--where");
  for (const std::string& note : verdict.notes()) reporter.note(note);
  const auto json = [&] { return verdict.json(options.explain); };
  write_outputs(options, {{".json", json}, {".svg", [&] { return verdict.svg(); }}});
  return {options.json ? json() : verdict.text(options.explain), verdict.holds() ? kDone : kEmpty};
}

}  // namespace findspace::app
