// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "common/session.h"

#include <findspace/board.h>
#include <findspace/json.h>
#include <findspace/text.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "common/asked_numbers.h"
#include "common/board_groups.h"

namespace findspace::app {
namespace {

constexpr std::array<std::string_view, 4> kModels{".step", ".stp", ".iges", ".igs"};  // they state their unit

bool is_model(const std::filesystem::path& path) {
  return std::find(kModels.begin(), kModels.end(), path.extension().string()) != kModels.end();
}

bool is_drawing(const std::filesystem::path& path) {
  const auto is_among = [&](const std::vector<std::string>& endings) {
    return std::find(endings.begin(), endings.end(), path.extension().string()) != endings.end();
  };
  return is_among(drawing_endings(2)) || is_among(drawing_endings(3));
}

/// A number of the command line as it stands in a scene.
std::string scene_number(const char* option, const std::string& text) {
  try {
    if (const JsonValue value = read_json(text); value.is(JsonValue::Kind::kNumber)) return value.text;
  } catch (const Error&) {
  }
  throw Error(ErrorCode::kUsage, fmt::format("{} wants a decimal number, not '{}'", option, printable(text)));
}

/// A scene that holds the one shape of a drawing.
std::string scene_around(const std::filesystem::path& drawing, const Options& o) {
  std::string text = fmt::format("{{\"findspace\": 1, \"shapes\": {{{}: {{\"file\": {}",
                                 json_string(drawing.stem().string()), json_string(drawing.filename().string()));
  auto add = [&](const char* key, const std::optional<std::string>& value) {
    if (value) text += fmt::format(", \"{}\": {}", key, json_string(*value));
  };
  if (!is_model(drawing)) add("unit", o.unit);
  add("id", o.id);
  add("layer", o.layer);
  if (o.index) text += fmt::format(", \"index\": {}", *o.index);
  if (!o.floor.empty()) text += fmt::format(", \"floor\": {}", scene_number("--floor", o.floor));
  return text + fmt::format("}}}}, \"unit\": {}}}", json_string(o.unit.value_or("mm")));
}

/// What the command line asks of a board.
Scene board_scene(const Options& o) {
  BoardQuestion question{o.move, o.where, o.minimize, o.maximize, "--", o.place, {}};
  for (const std::string& text : o.free) {
    const auto angle = decimal(text);
    if (!angle)
      throw Error(ErrorCode::kUsage, fmt::format("--free {}: angles in degrees are meant, such as 0,90", text));
    question.angles.push_back(*angle);
  }
  return Board::file(o.scene, {o.scene, asked_groups(o), o.fixed, o.input_limit}).scene(question);
}

/// The scene with the formulas of the command line in the place of its own.
Scene asked(const Scene& scene, const Options& o) {
  if (!o.minimize.empty() && !o.maximize.empty())
    throw Error(ErrorCode::kUsage, "--minimize and --maximize: one objective is meant");
  if (scene.places() && !(o.where.empty() && o.minimize.empty()))
    throw Error(ErrorCode::kUsage, "--where and --minimize: a scene with \"place\" says them there");
  Scene::Question question{{}, {}, {}, "--"};
  if (!o.where.empty()) question.where = o.where;
  if (!o.minimize.empty()) question.minimize = o.minimize;
  if (!o.maximize.empty()) question.maximize = o.maximize;
  return question.where || question.minimize || question.maximize ? scene.asking(question) : scene;
}

Scene read(const Options& o) {
  const std::filesystem::path path(o.scene);
  const auto scene_of = [&](const std::string& text, const std::filesystem::path& folder, const ReadOptions& limits,
                            const std::string& name) {
    return asked(Scene::json(text, folder.string(), limits, name), o);
  };
  ReadOptions limits = reading(o);
  if (o.scene_text) {
    if (limits.root.empty()) limits.root = std::filesystem::current_path();
    return scene_of(*o.scene_text, limits.root, limits, o.scene);
  }
  if (is_board(path)) return board_scene(o);
  if (!o.move.empty() || !o.free.empty() || !o.fixed.empty() || !o.groups.empty())
    throw Error(ErrorCode::kUsage, "--move, --free, --fixed and --group are for boards; a scene says them itself");
  const bool drawing = is_drawing(path);
  if (!drawing && (o.unit || o.id || o.layer || o.index || !o.floor.empty()))
    throw Error(ErrorCode::kUsage,
                "--unit, --id, --layer, --index and --floor are for drawings; a scene says them itself");
  if (o.scene == "-") {
    const std::filesystem::path folder = std::filesystem::current_path();
    if (limits.root.empty()) limits.root = folder;  // whoever writes into the pipe may be anyone
    return scene_of(read_standard_input(o.input_limit), folder, limits, "standard input");
  }
  if (!drawing) return scene_of(read_text(path, o.input_limit), path.parent_path(), limits, path.string());
  limits.files = true;  // the one that is named
  limits.root.clear();
  return scene_of(scene_around(path, o), path.parent_path(), limits, path.filename().string());
}

Scene::Listener listener_of(Reporter& reporter) {
  return {[&reporter](const std::string& text) { reporter.note(text); },
          [&reporter](const std::string& text) { reporter.stage(text); }};
}

}  // namespace

bool is_board(const std::filesystem::path& path) { return path.extension() == ".kicad_pcb"; }

Session::Session(const Options& options, Reporter& reporter, const Scene& scene)
    : options_(options), reporter_(reporter), scene_(scene.with(listener_of(reporter))) {}

Session::Session(const Options& options, Reporter& reporter)
    : Session(options, reporter, [&] {
        reporter.stage("reading the scene");
        Scene scene = read(options);
        for (const std::string& note : scene.notes()) reporter.note(note);
        return scene;
      }()) {}

}  // namespace findspace::app
