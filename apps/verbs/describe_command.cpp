// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <findspace/board.h>
#include <fmt/format.h>

#include <algorithm>

#include "common/commands.h"
#include "common/line_choice.h"
#include "common/session.h"
#include "common/told.h"

namespace findspace::app {
namespace {

/// Those that somebody may mean: of a board the parts and the lists of them, without pads and nets.
std::vector<std::string> chief_names(const Scene& scene) {
  std::vector<std::string> names = scene.names();
  const std::optional<Board> board = scene.board();
  if (!board) return names;
  const std::vector<std::string> parts = board->parts();
  std::erase_if(names, [&](const std::string& name) {
    const bool list = scene.groups().count(name) > 0 && name.find(' ') == name.npos;
    return !list && std::find(parts.begin(), parts.end(), name) == parts.end();
  });
  return names;
}

/// The shape asked for; of a scene with a single one its name may be left out.
std::string chosen_shape(const Session& session) {
  const Options& o = session.options();
  if (o.shapes.size() == 1) return o.shapes[0];
  if (o.shapes.empty() && session.scene().names().size() == 1) return session.scene().names()[0];
  throw Error(ErrorCode::kUsage,
              fmt::format("which shape? The scene has {}", fmt::join(chief_names(session.scene()), ", ")));
}

/// The text of a file; what it loses is noted.
std::string drawn(const Session& session, const Region& region, const char* ending, const std::string& name) {
  Region::Drawn text = region.drawn(ending, name, session.options().dxf);
  if (!text.lost.empty()) session.reporter().note(text.lost);
  return std::move(text.text);
}

/// The boundary of a solid as a mesh, in every format of meshes and as a scene that states it.
Outcome convert_solid(const Session& session, const std::string& name) {
  check_outputs(session.options(), space_formats());
  session.reporter().stage(fmt::format("shape {}", name));
  const Surface found = session.scene().shape(name).surface();
  if (!found.lost.empty()) session.reporter().note(found.lost);
  const std::string unit = session.scene().unit();
  const auto json = [&] { return found.scene_json(name, unit); };
  Writers writers{{".json", json}};
  for (const std::string& ending : Surface::endings())
    writers.emplace(ending, [&, ending] { return found.text(ending, unit, name); });
  write_outputs(session.options(), writers);
  return {session.options().json || session.options().outputs.empty() ? json() : "", kDone};
}

}  // namespace

Outcome run_describe(const Options& options, Reporter& reporter) {
  const Session session(options, reporter);
  const std::string name = chosen_shape(session);
  ShapeQuestion question;
  if (session.in_space()) {
    SetInSpace set = asked_in_space(options);
    question = {set.surface, std::move(set.lines), set.listed, "--"};
  } else {
    refuse_lines(options, "for 3D shapes");
    check_outputs(options, {".svg", ".wkt", ".json"});
  }
  const Answer answer = session.scene().describe(name, question);
  if (session.in_space()) reporter.stage("writing");
  return told(session, answer);
}

Outcome run_convert(const Options& options, Reporter& reporter) {
  const Session session(options, reporter);
  const bool json_asked = options.json || std::any_of(options.outputs.begin(), options.outputs.end(),
                                                      [](const auto& file) { return file.extension() == ".json"; });
  if (options.constructive && (session.in_space() || !json_asked))
    throw Error(ErrorCode::kUsage, "--constructive is for the JSON of plane shapes: -o NAME.json or --json");
  const std::string name = chosen_shape(session);
  if (session.in_space()) return convert_solid(session, name);
  check_outputs(options, {".svg", ".dxf", ".geojson", ".wkt", ".json"});
  const Region region = session.scene().describe(name).region()->inner;
  const auto json = [&] { return options.constructive ? region.scene_json(name) : region.json(true); };
  Writers writers{{".json", json}};
  for (const char* ending : {".svg", ".dxf", ".geojson", ".wkt"})
    writers.emplace(ending, [&, ending] { return drawn(session, region, ending, name); });
  write_outputs(options, writers);
  if (options.json) return {json(), kDone};
  return {options.outputs.empty() ? drawn(session, region, ".wkt", name) : "", kDone};
}

}  // namespace findspace::app
