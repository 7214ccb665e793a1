// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "in_plane/orientation_command.h"

#include <fmt/format.h>

#include <algorithm>

#include "common/asked_numbers.h"
#include "findspace/text.h"

namespace findspace::app {
namespace {

/// The same session over positions of what moves, rotated; `called`: what notes call the rotation.
Session rotated(const Session& session, const Options& options, const Rotation& rotation, const std::string& called) {
  const Scene& scene = session.scene();
  Scene out = scene.rotated(rotation);
  for (std::size_t k = scene.notes().size(); k < out.notes().size(); ++k)
    session.reporter().note(fmt::format("{}: {}", called, out.notes()[k]));
  return Session(options, session.reporter(), out);
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

std::string json_entry(const Rotation& rotation, const std::string& answer) {
  const auto row = [](const std::array<double, 3>& entries) { return json_list(entries, json_number); };
  return fmt::format("{{\"orientation\": {}, \"matrix\": {}, \"exact_angle\": {}, \"answer\": {}}}",
                     json_string(rotation.text()), json_list(rotation.matrix(), row), rotation.exact(), answer);
}

Outcome at_each(const Session& session, Outcome (*ask)(const Session&)) {
  check_outputs(session.options(), {".json"});
  const bool written = !session.options().outputs.empty();
  Options quiet = session.options();
  quiet.outputs.clear();
  quiet.json = session.options().json || written;
  std::vector<std::string> entries, lines;
  std::optional<ExitStatus> status;
  for (const Rotation& rotation : session.scene().free().rotations) {
    const Session one = rotated(session, quiet, rotation, rotation.text());
    Outcome outcome = ask(one);
    status = status ? joined(*status, outcome.status) : outcome.status;
    const char* answer = outcome.status == kDone ? "yes" : outcome.status == kEmpty ? "no" : "not decided";
    const std::string text = text_of(std::move(outcome));
    if (quiet.json) entries.push_back(json_entry(rotation, text));
    lines.push_back(quiet.json ? fmt::format("{}: {}", rotation.text(), answer)
                               : fmt::format("{}\n{}", rotation.text(), text));
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
  const Options& options = session.options();
  if (const auto rotation = asked_rotation(session)) {
    const std::string called = options.angle ? "--angle " + *options.angle : "--orientation " + *options.orientation;
    return ask(rotated(session, options, *rotation, called));
  }
  return session.scene().free().kind == Scene::Free::Kind::kPose ? at_each(session, ask) : ask(session);
}

}  // namespace findspace::app
