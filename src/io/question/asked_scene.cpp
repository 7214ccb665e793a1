// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "io/question/asked_scene.h"

#include <findspace/error.h>
#include <fmt/format.h>

#include <set>

#include "formula/language/condition_work.h"
#include "io/scene/scene_formulas.h"
#include "io/scene/scene_regions.h"

namespace findspace::io {
namespace {

void add_names(const formula::Distance& distance, std::set<std::string>& names) {
  names.insert(distance.first.begin(), distance.first.end());
  names.insert(distance.second.begin(), distance.second.end());
}

/// The motion of its shapes, in grid steps.
formula::Motion motion_of(const Scene& scene) {
  formula::Motion out{scene.motion.start, scene.motion.end, {}};
  for (const Movement& m : scene.motion.movements) {
    formula::Trajectory t{m.times, {}, m.angles};
    for (const GridPosition& p : m.path) t.path.push_back({exact::Real(p[0]), exact::Real(p[1])});
    out.of.emplace(m.shape, std::move(t));
  }
  return out;
}

}  // namespace

void AskedScene::note(const std::string& text) const {
  if (terms_.listener.note) terms_.listener.note(text);
}

void AskedScene::note_rotated(const plane::Rounding& rounding, std::string_view more) const {
  if (rounding.points == 0) return;
  note(fmt::format("{} rotated vertices were put on the grid, moved by at most {:.2g}{}{}{}", rounding.points,
                   rounding.largest * scene_->grid.step_size(), unit().empty() ? "" : " ", unit(), more));
}

void AskedScene::stage(const std::string& text) const {
  if (terms_.listener.stage) terms_.listener.stage(text);
}

std::string AskedScene::unit() const { return scene_->unit ? std::string(formula::name(*scene_->unit)) : ""; }

std::vector<plane::Region> AskedScene::regions(const std::vector<plane::ShapePtr>& shapes) const {
  std::vector<std::string> notes;
  std::vector<plane::Region> out = regions_of(*scene_, shapes, notes);
  for (const std::string& text : notes) note(text);
  return out;
}

void AskedScene::require_positions(bool line) const {
  using Kind = Free::Kind;
  auto refuse = [&](const std::string& what) {
    throw Error(ErrorCode::kUnsupported, what + " is not computed by this version", scene_->file);
  };
  if (scene_->dimension != 2) refuse("a map of a 3D scene");
  if (scene_->free.kind != Kind::kPosition &&
      !(line && (scene_->free.kind == Kind::kLine || scene_->free.kind == Kind::kTime)))
    refuse("this kind of \"free\"");
  require_moving();
}

void AskedScene::require_positions_in_space(bool line, bool poses) const {
  auto refuse = [&](const std::string& what) {
    throw Error(ErrorCode::kUnsupported, what + " is not computed in 3D", scene_->file);
  };
  if (scene_->motion.given()) refuse("a scene with \"motion\"");
  using Kind = Free::Kind;
  if (scene_->free.kind != Kind::kPosition && !(poses && scene_->free.kind == Kind::kPose) &&
      !(line && scene_->free.kind == Kind::kLine)) {
    const bool angle = scene_->free.kind == Kind::kAngle;
    refuse(angle ? "\"free\": \"angle\", which \"pose\" with a list of \"angles\" asks one by one,"
                 : "this kind of \"free\"");
  }
  require_moving();
}

void AskedScene::require_moving() const {
  if (scene_->moving.empty())
    throw Error(ErrorCode::kBadValue,
                scene_->board ? "nothing says which parts move: --move names them"
                              : "the scene does not say which shape is \"moving\"",
                scene_->file);
}

void AskedScene::require_question() const {
  if (scene_->where.empty() && !goal())
    throw Error(ErrorCode::kBadValue, "the scene has no \"where\": nothing says what must hold", scene_->file);
}

formula::Context AskedScene::context() const { return context_of(*scene_); }

formula::Formula AskedScene::formula(const FormulaText& text, const formula::Context& context) const {
  return read_formula(text, context);
}

formula::Goal AskedScene::goal(const FormulaText& text, const formula::Context& context) const {
  return read_goal(text, context);
}

formula::Formula AskedScene::where() const {
  return terms_.kept ? terms_.kept->where.get([&] { return read_where(); }) : read_where();
}

formula::Formula AskedScene::read_where() const {
  const formula::Context known = context();
  if (scene_->conditions.empty()) return formula(scene_->where, known);
  std::vector<formula::Formula> all;
  for (const FormulaText& text : scene_->conditions) all.push_back(formula(text, known));
  formula::Formula joined = formula::conjunction(all);
  try {
    formula::charge_conditions(joined, known.work_limit);
  } catch (const Error& e) {
    throw placed(e, scene_->where);
  }
  return joined;
}

std::optional<AskedScene::Goal> AskedScene::goal() const {
  const bool least = !scene_->minimize.empty();
  const FormulaText& text = least ? scene_->minimize : scene_->maximize;
  if (text.empty()) return std::nullopt;
  if (least && !scene_->maximize.empty()) {
    throw Error(ErrorCode::kBadValue, "the scene has both \"minimize\" and \"maximize\"", scene_->file);
  }
  try {
    return Goal{formula::parse_objective(text.text, context()),
                least ? distance::Sense::kMinimum : distance::Sense::kMaximum, text.text};
  } catch (const Error& e) {
    throw placed(e, text);
  }
}

formula::World AskedScene::world() const {
  return scene_->named_only ? world_of(where()) : world_with(scene_->shapes, true);
}

formula::World AskedScene::world_of(const formula::Formula& formula, bool parts) const {
  std::set<std::string> named(scene_->moving.begin(), scene_->moving.end());
  const std::optional<Goal> goal = this->goal();
  named.merge(formula.shapes());
  if (goal)
    for (const formula::Distance& d : formula::distances_of(goal->objective)) add_names(d, named);
  for (const Movement& m : scene_->motion.movements) named.insert(m.shape);
  std::set<const plane::Shape*> of_others;
  std::vector<const plane::Shape*> todo;
  for (const plane::ShapePtr& s : scene_->shapes) todo.push_back(s.get());
  while (!todo.empty()) {
    const plane::Shape* shape = todo.back();
    todo.pop_back();
    for (const plane::ShapePtr& child : shape->children) {
      if (child->name.empty() && child->children.empty()) continue;  // no shape of the scene, and made of none
      if (of_others.insert(child.get()).second) todo.push_back(child.get());
    }
  }
  std::vector<plane::ShapePtr> wanted;
  for (const plane::ShapePtr& s : scene_->shapes)
    if (named.count(s->name) != 0 || (!scene_->named_only && of_others.count(s.get()) == 0)) wanted.push_back(s);
  return world_with(wanted, parts);
}

formula::World AskedScene::world_with(const std::vector<plane::ShapePtr>& shapes, bool parts) const {
  stage("building the shapes");
  formula::World world;
  std::vector<plane::Region> built = regions(shapes);
  for (std::size_t k = 0; k < built.size(); ++k) world.shapes.emplace(shapes[k]->name, std::move(built[k]));
  world.moving = scene_->moving;
  world.step = step();
  world.motion = motion_of(*scene_);
  world.instant = terms_.instant;
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

AskedScene AskedScene::over_time() const {
  AskedScene out = *this;
  out.terms_.instant.reset();
  return out;
}

std::shared_ptr<const formula::Solver> AskedScene::solver() const {
  if (!terms_.kept) return std::make_shared<const formula::Solver>(world());
  const KeptShapes& shapes = *terms_.kept->shapes;
  const std::shared_ptr<const formula::Solver>& all = shapes.planar.get([&] {
    return std::make_shared<const formula::Solver>(shapes.world ? shapes.world(*this) : over_time().world());
  });
  if (!terms_.instant) return all;
  formula::World then = all->world();
  then.instant = terms_.instant;
  return std::make_shared<const formula::Solver>(std::move(then));
}

std::shared_ptr<const formula::Solver> AskedScene::solver_of(const formula::Formula& formula, bool parts) const {
  return terms_.kept ? solver() : std::make_shared<const formula::Solver>(world_of(formula, parts));
}

void AskedScene::want(std::vector<Placement::Near> near) {
  auto changed = std::make_shared<Scene>(*scene_);
  changed->place.near = std::move(near);
  scene_ = std::move(changed);
}

void AskedScene::forget_shapes() {
  auto bare = std::make_shared<Scene>(*scene_);
  for (plane::ShapePtr& s : bare->shapes) {
    auto named = std::make_shared<plane::Shape>();
    named->name = s->name;
    s = std::move(named);
  }
  scene_ = std::move(bare);
}

}  // namespace findspace::io
