// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The verb convert for 3D shapes: the boundary of a shape as a mesh, in every format of meshes and as a scene that
// states it. Guarantee: exact, faces outward. Of what one closed surface bounds (a mesh, a prism, moved or mirrored),
// of shapes with axis-parallel faces and of convex polytopes; others are refused, describe gives theirs as found on
// lines.

#include <fmt/format.h>

#include "in_space/space_commands.h"
#include "io/mesh/space_surface.h"
#include "io/mesh/write_mesh.h"
#include "io/write/write_json.h"

namespace findspace::app {
io::Surface boundary_of(const Session& session, const plane::Shape& shape) {
  io::SolidSurface found = io::solid_surface(shape, session.step());
  if (found.lost) session.reporter().note("a mesh cannot hold sheets, lines and points: lost");
  return std::move(found.surface);
}

namespace {

std::string scene_text(const io::Surface& surface, const std::string& name, const std::string& unit) {
  std::vector<std::string> vertices, faces;
  for (const auto& v : surface.vertices)
    vertices.push_back(
        fmt::format("[{}, {}, {}]", io::json_number(v[0]), io::json_number(v[1]), io::json_number(v[2])));
  for (const auto& f : surface.faces) faces.push_back(fmt::format("[{}]", fmt::join(f, ", ")));
  return fmt::format(
      "{{\"findspace\": 1, {}\"shapes\": {{{}: {{\"mesh\": {{\"vertices\": [{}],\n \"faces\": [{}]}}}}}}}}\n",
      unit.empty() ? "" : fmt::format("\"unit\": {}, ", io::json_string(unit)), io::json_string(name),
      fmt::join(vertices, ", "), fmt::join(faces, ", "));
}

}  // namespace

Outcome convert_space(const Session& session, const std::string& name) {
  std::vector<std::string> endings{".json"};
  endings.insert(endings.end(), io::kSurfaceEndings.begin(), io::kSurfaceEndings.end());
  check_outputs(session.options(), endings);
  session.reporter().stage(fmt::format("shape {}", name));
  const io::Surface found = boundary_of(session, *session.scene().shape(name));
  const auto json = [&] { return scene_text(found, name, session.unit()); };
  Writers writers{{".json", json}};
  for (const char* ending : io::kSurfaceEndings)
    writers.emplace(ending, [&, ending] { return io::surface_text(found, name, ending, session.unit()); });
  write_outputs(session.options(), writers);
  return {session.options().json || session.options().outputs.empty() ? json() : "", kDone};
}

}  // namespace findspace::app
