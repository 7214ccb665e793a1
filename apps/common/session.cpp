// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "common/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "common/asked_numbers.h"
#include "common/board_groups.h"
#include "findspace/text.h"
#include "io/api/public_scene.h"
#include "io/board/board_scene.h"
#include "io/board/read_board.h"
#include "io/cad/read_cad.h"
#include "io/scene/scene_regions.h"
#include "io/text/file_kind.h"
#include "io/write/write_json.h"

namespace findspace::app {
namespace {

using exact::Real;

constexpr std::array<std::string_view, 14> kDrawings{".svg", ".dxf", ".wkt", ".geojson", ".stl", ".obj",  ".off",
                                                     ".ply", ".3mf", ".glb", ".step",    ".stp", ".iges", ".igs"};

/// A scene that holds the one shape of a drawing.
std::string scene_around(const std::filesystem::path& drawing, const Options& o) {
  std::string text =
      fmt::format("{{\"findspace\": 1, \"shapes\": {{{}: {{\"file\": {}", io::json_string(drawing.stem().string()),
                  io::json_string(drawing.filename().string()));
  auto add = [&](const char* key, const std::optional<std::string>& value) {
    if (value) text += fmt::format(", \"{}\": {}", key, io::json_string(*value));
  };
  if (!io::is_cad_ending(io::lower_ending(drawing.extension().string()))) add("unit", o.unit);
  add("id", o.id);
  add("layer", o.layer);
  if (o.index) text += fmt::format(", \"index\": {}", *o.index);
  return text + fmt::format("}}}}, \"unit\": {}}}", io::json_string(o.unit.value_or("mm")));
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
io::Scene asked(io::Scene scene, const Options& o) {
  if (!o.minimize.empty() && !o.maximize.empty())
    throw Error(ErrorCode::kUsage, "--minimize and --maximize: one objective is meant");
  if (scene.place.given() && !(o.where.empty() && o.minimize.empty()))
    throw Error(ErrorCode::kUsage, "--where and --minimize: a scene with \"place\" says them there");
  if (!o.where.empty()) {
    scene.where = {o.where, "--where", 1, 1};
    scene.conditions.clear();
  }
  if (!o.minimize.empty() || !o.maximize.empty()) {
    scene.minimize = {o.minimize, "--minimize", 1, 1};
    scene.maximize = {o.maximize, "--maximize", 1, 1};
  }
  return scene;
}

io::Scene read(const Options& o) {
  const std::filesystem::path path(o.scene);
  if (o.scene_text) {
    ReadOptions limits = reading(o);
    if (limits.root.empty()) limits.root = std::filesystem::current_path();
    return asked(io::read_scene_text(*o.scene_text, limits.root, o.scene, limits), o);
  }
  if (is_board(path))
    return io::board_scene(std::make_shared<const io::Board>(io::read_board(read_text(path, o.input_limit), o.scene)),
                           question_of_board(o));
  if (!o.move.empty() || !o.free.empty() || !o.fixed.empty() || !o.groups.empty())
    throw Error(ErrorCode::kUsage, "--move, --free, --fixed and --group are for boards; a scene says them itself");
  const bool drawing = std::find(kDrawings.begin(), kDrawings.end(), path.extension().string()) != kDrawings.end();
  if (!drawing && (o.unit || o.id || o.layer || o.index))
    throw Error(ErrorCode::kUsage, "--unit, --id, --layer and --index are for drawings; a scene says them itself");
  ReadOptions limits = reading(o);
  if (o.scene == "-") {
    const std::filesystem::path folder = std::filesystem::current_path();
    if (limits.root.empty()) limits.root = folder;  // whoever writes into the pipe may be anyone
    return asked(io::read_scene_text(read_standard_input(o.input_limit), folder, "standard input", limits), o);
  }
  if (!drawing) return asked(io::read_scene(path, limits), o);
  limits.files = true;  // the one that is named
  limits.root.clear();
  return asked(io::read_scene_text(scene_around(path, o), path.parent_path(), path.filename().string(), limits), o);
}

void add_names(const formula::Distance& distance, std::set<std::string>& names) {
  names.insert(distance.first.begin(), distance.first.end());
  names.insert(distance.second.begin(), distance.second.end());
}

}  // namespace

bool is_board(const std::filesystem::path& path) { return path.extension() == ".kicad_pcb"; }

Session::Session(const Options& options, Reporter& reporter) : options_(options), reporter_(reporter) {
  reporter.stage("reading the scene");
  scene_ = read(options);
  for (const std::string& note : scene_.notes) reporter.note(note);
}

Session::Session(const Options& options, Reporter& reporter, io::Scene scene)
    : options_(options), reporter_(reporter), scene_(std::move(scene)) {}

std::string Session::unit() const { return scene_.unit ? std::string(formula::name(*scene_.unit)) : ""; }

Shape Session::shape(const std::string& name) const { return io::public_shape(scene_, name); }

Region Session::shape_region(const std::string& name) const {
  reporter_.stage(fmt::format("shape {}", name));
  const Shape made = shape(name);
  const Shape::Rounded moved = made.rotated_points();
  if (moved.points > 0) reporter_.note(io::rotated_note(scene_, name, moved.points, moved.largest));
  return made.region();
}

std::vector<plane::Region> Session::regions(const std::vector<plane::ShapePtr>& shapes) const {
  std::vector<std::string> notes;
  std::vector<plane::Region> out = io::regions_of(scene_, shapes, notes);
  for (const std::string& note : notes) reporter_.note(note);
  return out;
}

void Session::require_positions(bool line) const {
  using Kind = io::Free::Kind;
  auto refuse = [&](const std::string& what) {
    throw Error(ErrorCode::kUnsupported, what + " is not computed by this version", scene_.file);
  };
  if (scene_.dimension != 2) refuse("a map of a 3D scene");
  if (scene_.free.kind != Kind::kPosition &&
      !(line && (scene_.free.kind == Kind::kLine || scene_.free.kind == Kind::kTime)))
    refuse("this kind of \"free\"");
  if (scene_.moving.empty())
    throw Error(ErrorCode::kBadValue, "the scene does not say which shape is \"moving\"", scene_.file);
}

void Session::require_positions_in_space(bool line, bool poses) const {
  auto refuse = [&](const std::string& what) {
    throw Error(ErrorCode::kUnsupported, what + " is not computed in 3D", scene_.file);
  };
  if (scene_.motion.given()) refuse("a scene with \"motion\"");
  asked_instant(*this);  // refuses --time: there is no motion
  using Kind = io::Free::Kind;
  if (scene_.free.kind != Kind::kPosition && !(poses && scene_.free.kind == Kind::kPose) &&
      !(line && scene_.free.kind == Kind::kLine))
    refuse("this kind of \"free\"");
  if (scene_.moving.empty())
    throw Error(ErrorCode::kBadValue, "the scene does not say which shape is \"moving\"", scene_.file);
}

formula::Context Session::context() const { return io::context_of(scene_); }

formula::Formula Session::formula(const io::FormulaText& text, const formula::Context& context) const {
  return io::read_formula(text, context);
}

formula::Goal Session::goal(const io::FormulaText& text, const formula::Context& context) const {
  return io::read_goal(text, context);
}

formula::Formula Session::where() const {
  const formula::Context known = context();
  if (scene_.conditions.empty()) return formula(scene_.where, known);
  std::vector<formula::Formula> all;
  for (const io::FormulaText& text : scene_.conditions) all.push_back(formula(text, known));
  return formula::conjunction(all);
}

std::optional<Session::Goal> Session::goal() const {
  const bool least = !scene_.minimize.empty();
  const io::FormulaText& text = least ? scene_.minimize : scene_.maximize;
  if (text.empty()) return std::nullopt;
  if (least && !scene_.maximize.empty()) {
    throw Error(ErrorCode::kBadValue, "the scene has both \"minimize\" and \"maximize\"", scene_.file);
  }
  try {
    return Goal{formula::parse_objective(text.text, context()),
                least ? distance::Sense::kMinimum : distance::Sense::kMaximum, text.text};
  } catch (const Error& e) {
    throw io::placed(e, text);
  }
}

formula::World Session::world() const {
  return scene_.named_only ? world_of(where()) : world_with(scene_.shapes, true);
}

World Session::public_world() const {
  return in_space() ? io::public_world(scene_) : io::public_world(scene_, world());
}

Formula Session::public_where() const {
  where();  // says where a mistake is
  return scene_.where.empty() ? Formula("true") : Formula(scene_.where.text);
}

formula::World Session::world_of(const formula::Formula& formula, bool parts) const {
  std::set<std::string> named(scene_.moving.begin(), scene_.moving.end());
  const std::optional<Goal> goal = this->goal();
  named.merge(formula.shapes());
  if (goal)
    for (const formula::Distance& d : formula::distances_of(goal->objective)) add_names(d, named);
  for (const io::Movement& m : scene_.motion.movements) named.insert(m.shape);
  std::set<const plane::Shape*> of_others;
  std::vector<const plane::Shape*> todo;
  for (const plane::ShapePtr& s : scene_.shapes) todo.push_back(s.get());
  while (!todo.empty()) {
    const plane::Shape* shape = todo.back();
    todo.pop_back();
    for (const plane::ShapePtr& child : shape->children)
      if (of_others.insert(child.get()).second) todo.push_back(child.get());
  }
  std::vector<plane::ShapePtr> wanted;
  for (const plane::ShapePtr& s : scene_.shapes)
    if (named.count(s->name) != 0 || (!scene_.named_only && of_others.count(s.get()) == 0)) wanted.push_back(s);
  return world_with(wanted, parts);
}

formula::World Session::world_with(const std::vector<plane::ShapePtr>& shapes, bool parts) const {
  reporter_.stage("building the shapes");
  formula::World world;
  std::vector<plane::Region> built = regions(shapes);
  for (std::size_t k = 0; k < built.size(); ++k) world.shapes.emplace(shapes[k]->name, std::move(built[k]));
  world.moving = scene_.moving;
  world.step = step();
  world.motion = io::motion_of(scene_);
  world.instant = asked_instant(*this);
  for (const plane::ShapePtr& s : shapes) {
    if (!s->collection || !parts) continue;
    std::vector<plane::Region> built_parts = regions(s->children);
    for (std::size_t k = 0; k < built_parts.size(); ++k) {
      const std::string& name = s->children[k]->name;
      world.parts[s->name].emplace_back(name.empty() ? std::to_string(k) : name, std::move(built_parts[k]));
    }
  }
  return world;
}

void Session::forget_shapes() {
  for (plane::ShapePtr& s : scene_.shapes) {
    auto bare = std::make_shared<plane::Shape>();
    bare->name = s->name;
    s = std::move(bare);
  }
}

}  // namespace findspace::app
