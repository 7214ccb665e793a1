// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "common/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "common/asked_numbers.h"
#include "common/board_groups.h"
#include "findspace/text.h"
#include "io/api/public_scene.h"
#include "io/board/board_scene.h"
#include "io/board/read_board.h"
#include "io/scene/scene_regions.h"

namespace findspace::app {
namespace {

using exact::Real;

constexpr std::array<std::string_view, 10> kDrawings{".svg", ".dxf", ".wkt", ".geojson", ".stl",
                                                     ".obj", ".off", ".ply", ".3mf",     ".glb"};
constexpr std::array<std::string_view, 4> kModels{".step", ".stp", ".iges", ".igs"};  // they state their unit

template <std::size_t kCount>
bool has_ending(const std::filesystem::path& path, const std::array<std::string_view, kCount>& endings) {
  return std::find(endings.begin(), endings.end(), path.extension().string()) != endings.end();
}

/// A scene that holds the one shape of a drawing.
std::string scene_around(const std::filesystem::path& drawing, const Options& o) {
  std::string text = fmt::format("{{\"findspace\": 1, \"shapes\": {{{}: {{\"file\": {}",
                                 json_string(drawing.stem().string()), json_string(drawing.filename().string()));
  auto add = [&](const char* key, const std::optional<std::string>& value) {
    if (value) text += fmt::format(", \"{}\": {}", key, json_string(*value));
  };
  if (!has_ending(drawing, kModels)) add("unit", o.unit);
  add("id", o.id);
  add("layer", o.layer);
  if (o.index) text += fmt::format(", \"index\": {}", *o.index);
  return text + fmt::format("}}}}, \"unit\": {}}}", json_string(o.unit.value_or("mm")));
}

/// What the command line asks of a board.
io::BoardQuestion question_of_board(const Options& o) {
  io::BoardQuestion question{o.move, o.where, o.minimize, o.maximize, o.place, {}, o.fixed, {}};
  for (BoardGroup& group : asked_groups(o)) question.groups.push_back({std::move(group.name), std::move(group.parts)});
  for (const std::string& angle : o.free) {
    try {
      question.angles.push_back(Real::parse_decimal(angle));
    } catch (const Error& e) {
      throw Error(ErrorCode::kUsage, fmt::format("--free {}: angles in degrees are meant, such as 0,90", angle));
    }
  }
  return question;
}

/// The scene with the formulas of the command line in the place of its own.
findspace::Scene asked(const findspace::Scene& scene, const Options& o) {
  if (!o.minimize.empty() && !o.maximize.empty())
    throw Error(ErrorCode::kUsage, "--minimize and --maximize: one objective is meant");
  if (scene.places() && !(o.where.empty() && o.minimize.empty()))
    throw Error(ErrorCode::kUsage, "--where and --minimize: a scene with \"place\" says them there");
  findspace::Scene::Question question{{}, {}, {}, "--"};
  if (!o.where.empty()) question.where = o.where;
  if (!o.minimize.empty()) question.minimize = o.minimize;
  if (!o.maximize.empty()) question.maximize = o.maximize;
  return question.where || question.minimize || question.maximize ? scene.asking(question) : scene;
}

findspace::Scene read(const Options& o) {
  const std::filesystem::path path(o.scene);
  const auto scene_of = [&](const std::string& text, const std::filesystem::path& folder, const ReadOptions& limits,
                            const std::string& name) {
    return asked(findspace::Scene::json(text, folder.string(), limits, name), o);
  };
  ReadOptions limits = reading(o);
  if (o.scene_text) {
    if (limits.root.empty()) limits.root = std::filesystem::current_path();
    return scene_of(*o.scene_text, limits.root, limits, o.scene);
  }
  if (is_board(path)) {
    std::string text = read_text(path, o.input_limit);
    const auto board = std::make_shared<const io::Board>(io::read_board(text, o.scene));
    return io::public_scene(io::board_scene(board, question_of_board(o)), std::move(text));
  }
  if (!o.move.empty() || !o.free.empty() || !o.fixed.empty() || !o.groups.empty())
    throw Error(ErrorCode::kUsage, "--move, --free, --fixed and --group are for boards; a scene says them itself");
  const bool drawing = has_ending(path, kDrawings) || has_ending(path, kModels);
  if (!drawing && (o.unit || o.id || o.layer || o.index))
    throw Error(ErrorCode::kUsage, "--unit, --id, --layer and --index are for drawings; a scene says them itself");
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

findspace::Scene::Listener listener_of(Reporter& reporter) {
  return {[&reporter](const std::string& text) { reporter.note(text); },
          [&reporter](const std::string& text) { reporter.stage(text); }};
}

}  // namespace

bool is_board(const std::filesystem::path& path) { return path.extension() == ".kicad_pcb"; }

Session::Session(const Options& options, Reporter& reporter, findspace::Scene scene)
    : io::AskedScene(io::scene_of(scene), listener_of(reporter)),
      options_(options),
      reporter_(reporter),
      asked_(scene.with(listener_of(reporter))) {}

Session::Session(const Options& options, Reporter& reporter)
    : Session(options, reporter, [&] {
        reporter.stage("reading the scene");
        findspace::Scene scene = read(options);
        for (const std::string& note : scene.notes()) reporter.note(note);
        return scene;
      }()) {}

Session::Session(const Options& options, Reporter& reporter, io::Scene scene)
    : Session(options, reporter, io::public_scene(std::move(scene))) {}

Shape Session::shape(const std::string& name) const { return io::public_shape(scene(), name); }

Region Session::shape_region(const std::string& name) const {
  stage(fmt::format("shape {}", name));
  const Shape made = shape(name);
  const Shape::Rounded moved = made.rotated_points();
  if (moved.points > 0) note(io::rotated_note(scene(), name, moved.points, moved.largest));
  return made.region();
}

void Session::forget_shapes() {
  asked_.reset();
  io::AskedScene::forget_shapes();
}

}  // namespace findspace::app
