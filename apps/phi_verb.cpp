// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "commands.h"
#include "phi_command.h"
#include "session.h"

namespace findspace::app {

Outcome run_phi_verb(const Options& options, Talk& talk) {
  check_outputs(options, {".json", ".txt", ".obj", ".off", ".stl", ".svg"});
  const Session session(options, talk);
  if (options.shapes.size() != 2) throw Error(ErrorCode::kUsage, "phi wants two shapes of the scene");
  const CommandResult result = run_phi(session.scene(), {.first = options.shapes[0],
                                                         .second = options.shapes[1],
                                                         .at = options.at,
                                                         .json = options.json,
                                                         .outputs = options.outputs});
  for (const std::string& note : result.notes) talk.note(note);
  return {result.text, ExitStatus(result.exit_status)};
}

}  // namespace findspace::app
