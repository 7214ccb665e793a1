// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <fmt/format.h>

#include <algorithm>

#include "common/commands.h"
#include "common/line_choice.h"
#include "common/session.h"
#include "in_space/space_commands.h"
#include "io/board/board.h"

namespace findspace::app {
namespace {

/// The shape asked for; of a scene with a single one its name may be left out.
std::string chosen_shape(const Session& session) {
  const Options& o = session.options();
  if (o.shapes.size() == 1) return o.shapes[0];
  const auto& shapes = session.scene().shapes;
  if (o.shapes.empty() && shapes.size() == 1) return shapes[0]->name;
  // Of a board the parts and the lists of them, without pads and nets.
  const io::Board* const board = session.scene().board.get();
  std::string names;
  for (const auto& s : shapes)
    if (board == nullptr || board->find(s->name) != nullptr ||
        (session.scene().groups.count(s->name) > 0 && s->name.find(' ') == std::string::npos))
      names += (names.empty() ? "" : ", ") + s->name;
  throw Error(ErrorCode::kUsage, fmt::format("which shape? The scene has {}", names));
}

/// The text of a file; what it loses is noted.
std::string drawn(const Session& session, const Region& region, const char* ending, const std::string& name) {
  Region::Drawn text = region.drawn(ending, name, session.options().dxf);
  if (!text.lost.empty()) session.reporter().note(text.lost);
  return std::move(text.text);
}

}  // namespace

Outcome run_describe(const Options& options, Reporter& reporter) {
  const Session session(options, reporter);
  const std::string name = chosen_shape(session);
  if (session.in_space()) return describe_space(session, name);
  refuse_lines(options, "for 3D shapes");
  check_outputs(options, {".svg", ".wkt", ".json"});
  const Region region = session.shape_region(name);
  const auto json = [&] { return region.json(options.exact); };
  const auto svg = [&] { return region.picture(name, session.scene().file); };
  const auto wkt = [&] { return drawn(session, region, ".wkt", name); };
  write_outputs(options, {{".json", json}, {".svg", svg}, {".wkt", wkt}});
  return {options.json ? json() : region.text(name), region.empty() ? kEmpty : kDone};
}

Outcome run_convert(const Options& options, Reporter& reporter) {
  const Session session(options, reporter);
  const bool json_asked = options.json || std::any_of(options.outputs.begin(), options.outputs.end(),
                                                      [](const auto& file) { return file.extension() == ".json"; });
  if (options.constructive && (session.in_space() || !json_asked))
    throw Error(ErrorCode::kUsage, "--constructive is for the JSON of plane shapes: -o NAME.json or --json");
  const std::string name = chosen_shape(session);
  if (session.in_space()) return convert_space(session, name);
  check_outputs(options, {".svg", ".dxf", ".geojson", ".wkt", ".json"});
  const Region region = session.shape_region(name);
  const auto json = [&] { return options.constructive ? region.scene_json(name) : region.json(true); };
  Writers writers{{".json", json}};
  for (const char* ending : {".svg", ".dxf", ".geojson", ".wkt"})
    writers.emplace(ending, [&, ending] { return drawn(session, region, ending, name); });
  write_outputs(options, writers);
  if (options.json) return {json(), kDone};
  return {options.outputs.empty() ? drawn(session, region, ".wkt", name) : "", kDone};
}

}  // namespace findspace::app
