// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The verb convert for 3D shapes: the boundary of a shape as a mesh, in every format of meshes and as a scene that
// states it. Guarantee: exact, faces outward. Of what one closed surface bounds (a mesh, a prism, moved or mirrored),
// of shapes with axis-parallel faces and of convex polytopes; others are refused, describe gives theirs as found on
// lines.

#include <fmt/format.h>

#include "common/session.h"
#include "in_space/space_commands.h"

namespace findspace::app {

Outcome convert_space(const Session& session, const std::string& name) {
  std::vector<std::string> endings = Surface::endings();
  endings.insert(endings.begin(), ".json");
  check_outputs(session.options(), endings);
  session.reporter().stage(fmt::format("shape {}", name));
  const Surface found = session.shape(name).surface();
  if (!found.lost.empty()) session.reporter().note(found.lost);
  const std::string unit = session.asked().unit();
  const auto json = [&] { return found.scene_json(name, unit); };
  Writers writers{{".json", json}};
  for (const std::string& ending : Surface::endings())
    writers.emplace(ending, [&, ending] { return found.text(ending, unit, name); });
  write_outputs(session.options(), writers);
  return {session.options().json || session.options().outputs.empty() ? json() : "", kDone};
}

}  // namespace findspace::app
