// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "in_plane/orientation_command.h"

#include <fmt/format.h>

#include <algorithm>

#include "common/asked_numbers.h"
#include "io/write/write_json.h"
#include "io/write/write_placement.h"
#include "space/shape/rotated_shape.h"

namespace findspace::app {
namespace {

/// The scene of positions in which what moves is rotated.
io::Scene rotated(const Session& session, const io::Orientation& orientation) {
  io::Scene out = session.scene();
  out.free.kind = io::Free::Kind::kPosition;
  plane::Rounding rounding;
  for (plane::ShapePtr& shape : out.shapes) {
    if (std::find(out.moving.begin(), out.moving.end(), shape->name) == out.moving.end()) continue;
    plane::Shape turned = *space::rotated(*shape, orientation.rotation, rounding);
    turned.name = shape->name;
    shape = std::make_shared<const plane::Shape>(std::move(turned));
  }
  if (rounding.points > 0)
    session.reporter().note(fmt::format("{}: {} points were put on the grid, moved by at most {:.2g} {}",
                                        orientation.text, rounding.points, rounding.largest * out.grid.step_size(),
                                        session.unit()));
  return out;
}

std::string text_of(Outcome outcome) {
  if (outcome.stream) outcome.stream([&](std::string_view part) { outcome.text += part; });
  while (!outcome.text.empty() && outcome.text.back() == '\n') outcome.text.pop_back();
  return std::move(outcome.text);
}

/// All answers: yes where one is, no where all are.
ExitStatus joined(ExitStatus all, ExitStatus one) {
  if (all == kDone || one == kDone) return kDone;
  return all == one ? all : kLimit;
}

std::string json_entry(const io::Orientation& orientation, const std::string& answer) {
  return fmt::format("{{\"orientation\": {}, \"matrix\": {}, \"exact_angle\": {}, \"answer\": {}}}",
                     io::json_string(orientation.text), io::matrix_json(orientation.rotation),
                     !orientation.rotation.rounded, answer);
}

Outcome at_each(const Session& session, Outcome (*ask)(const Session&)) {
  check_outputs(session.options(), {".json"});
  const bool written = !session.options().outputs.empty();
  Options quiet = session.options();
  quiet.outputs.clear();
  quiet.json = session.options().json || written;
  std::vector<std::string> entries, lines;
  std::optional<ExitStatus> status;
  for (const io::Orientation& orientation : session.scene().free.orientations) {
    const Session one(quiet, session.reporter(), rotated(session, orientation));
    Outcome outcome = ask(one);
    status = status ? joined(*status, outcome.status) : outcome.status;
    const char* answer = outcome.status == kDone ? "yes" : outcome.status == kEmpty ? "no" : "not decided";
    const std::string text = text_of(std::move(outcome));
    if (quiet.json) entries.push_back(json_entry(orientation, text));
    lines.push_back(quiet.json ? fmt::format("{}: {}", orientation.text, answer)
                               : fmt::format("{}\n{}", orientation.text, text));
  }
  const std::string json = fmt::format("{{\"orientations\": [\n{}]}}\n", fmt::join(entries, ",\n"));
  write_outputs(session.options(), {{".json", [&] { return json; }}});
  return {session.options().json ? json : fmt::format("{}\n", fmt::join(lines, "\n")), *status};
}

}  // namespace

void refuse_orientation(const Options& options) {
  if (options.orientation)
    throw Error(ErrorCode::kUsage, "--orientation is for 3D scenes; in the plane an angle says all");
}

Outcome at_orientations(const Session& session, Outcome (*ask)(const Session&)) {
  if (const auto asked = asked_orientation(session))
    return ask(Session(session.options(), session.reporter(), rotated(session, *asked)));
  const io::Scene& scene = session.scene();
  return scene.free.kind == io::Free::Kind::kPose ? at_each(session, ask) : ask(session);
}

}  // namespace findspace::app
