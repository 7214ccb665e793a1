// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <fmt/format.h>

#include <algorithm>

#include "common/commands.h"
#include "common/line_choice.h"
#include "common/session.h"
#include "in_space/space_commands.h"
#include "io/board/board.h"
#include "io/export/write_drawing.h"
#include "io/export/write_wkt.h"
#include "io/write/write_constructive.h"
#include "io/write/write_json.h"
#include "plane/query/in_order.h"
#include "report/report.h"

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

std::string wkt(const Session& session, const plane::Region& region) {
  io::WktText text = io::region_wkt(region, session.step());
  if (!text.lost.empty()) session.reporter().note(text.lost);
  return text.text;
}

/// The text of a drawing; what it loses is noted.
std::string drawn(const Session& session, io::DrawingText text) {
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
  const plane::Region region = plane::in_order(session.region(name));
  const plane::Summary summary = plane::summarize(region, session.step());
  const auto json = [&] {
    return io::region_json(region, summary, session.step(), session.unit(), nullptr, options.exact);
  };
  const auto svg = [&] {
    io::Picture picture;
    picture.title = name;
    picture.subtitle = session.scene().file;
    picture.step = session.step();
    picture.unit = session.unit();
    picture.region = &region;
    picture.summary = &summary;
    picture.of_positions = false;
    return io::picture_svg(picture);
  };
  write_outputs(options, {{".json", json}, {".svg", svg}, {".wkt", [&] { return wkt(session, region); }}});
  return {options.json ? json() : summary_text(name, summary, session.unit()), summary.empty ? kEmpty : kDone};
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
  const plane::Region region = plane::in_order(session.region(name));
  const auto json = [&] {
    if (options.constructive) return io::constructive_scene(region, name, session.scene());
    const plane::Summary summary = plane::summarize(region, session.step());
    return io::region_json(region, summary, session.step(), session.unit(), nullptr, true);
  };
  const auto svg = [&] { return drawn(session, io::shape_svg(region, session.step(), name, session.scene().unit)); };
  const io::NamedRegion named{name, &region};
  const auto dxf = [&] {
    return drawn(session, io::shapes_dxf({&named, 1}, session.step(), session.scene().unit, options.dxf));
  };
  const auto geojson = [&] { return drawn(session, io::shapes_geojson({&named, 1}, session.step())); };
  const auto text = [&] { return wkt(session, region); };
  write_outputs(options, {{".json", json}, {".svg", svg}, {".dxf", dxf}, {".geojson", geojson}, {".wkt", text}});
  if (options.json) return {json(), kDone};
  return {options.outputs.empty() ? wkt(session, region) : "", kDone};
}

}  // namespace findspace::app
