// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "serve/loaded.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "findspace/board.h"
#include "findspace/error.h"
#include "findspace/text.h"
#include "findspace/vocabulary.h"
#include "serve/loaded_plane.h"
#include "serve/loaded_space.h"

namespace findspace::app {
namespace {

using Kind = Scene::Free::Kind;

constexpr std::array<const char*, 5> kFreeNames{"position", "line", "angle", "time", "pose"};

bool holds(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string numbers(const std::vector<Number>& values) {
  return json_list(values, [](const Number& v) { return json_number(v.value()); });
}

/// What formulas are written with.
std::string words() {
  std::vector<std::string> all;
  for (PredicateWord& row : predicate_words()) all.push_back(std::move(row.word));
  for (DistanceWord& row : distance_words()) all.push_back(std::move(row.word));
  return json_list(all, json_string);
}

/// The error with its place within the formula alone.
Error within_formula(const Error& error) {
  constexpr std::string_view kBefore = "where:";
  const std::string& place = error.place();
  Error out(error.code(), error.message(), place.rfind(kBefore, 0) == 0 ? place.substr(kBefore.size()) : place);
  for (const std::array<double, 2>& p : error.geometry()) out.at(p[0], p[1]);
  return out;
}

Scene::Question with_where(const std::string& where) {
  Scene::Question question;
  question.where = where;
  return question;
}

}  // namespace

Scene Loaded::asking(const Scene& scene, const Scene::Question& question) {
  Scene other = scene.asking(question);
  try {
    if (other.asks()) other.used();
  } catch (const Error& error) {
    throw within_formula(error);
  }
  return other;
}

Loaded::Loaded(const Scene& scene) : scene_(scene.prepared()), asked_(asked_of(scene_)) {
  scene_.used();  // refuses a formula that is none
}

std::unique_ptr<Loaded> Loaded::make(const Scene& scene) {
  if (scene.dimension() == 3) return std::make_unique<LoadedSpace>(scene);
  return std::make_unique<LoadedPlane>(scene);
}

Scene Loaded::asked_of(const Scene& scene) {
  Scene::Question question;
  if (!scene.asks()) question.where = "true";
  const Kind free = scene.free().kind;
  if (scene.dimension() == 2 && free != Kind::kPosition && free != Kind::kLine) question.free = Kind::kPosition;
  return question.where || question.free ? scene.asking(question) : scene;
}

void Loaded::refuse(const std::string& what) const {
  throw Error(ErrorCode::kUnsupported, what + " is not computed", scene_.name());
}

void Loaded::require_moving() const {
  if (scene_.moving().empty())
    throw Error(ErrorCode::kBadValue, "the scene does not say which shape is \"moving\"", scene_.name());
}

Scene Loaded::asking(const Scene& scene, const std::string& where) {
  return asking(scene, with_where(where.empty() ? "true" : where));
}

void Loaded::set_where(const std::string& where) {
  scene_ = asking(scene_, with_where(where));
  asked_ = asked_of(scene_);
  forget_answers();
}

std::string Loaded::shape_json(const std::string& name, const std::vector<std::string>& used, bool drawing) const {
  const bool moves = holds(scene_.moving(), name), named = holds(used, name);
  std::string out = fmt::format(R"({{"name": {}, "moving": {}, "used": {})", json_string(name), moves, named);
  // A board has many shapes: only those that the formula looks at are built.
  const std::string look = drawing && (moves || named || !scene_.board()) ? drawing_of(name) : "";
  if (!look.empty()) out += ", \"drawing\": " + look;
  return out + "}";
}

std::string Loaded::free_json() const {
  const Scene::Free& free = scene_.free();
  std::string out = fmt::format(R"("free": "{}")", kFreeNames[static_cast<std::size_t>(free.kind)]);
  if (!free.about.empty()) out += ", \"about\": " + numbers(free.about);
  if (free.kind == Kind::kPose) out += ", \"angles\": " + numbers(free.angles);
  return out;
}

std::string Loaded::motion_json() const {
  const std::optional<Motion> motion = scene_.motion();
  if (!motion) return "";
  const auto movement = [](const auto& path) {
    const auto& [shape, points] = path;
    return fmt::format(R"({{"shape": {}, "path": {}, "times": {}, "angles": {}}})", json_string(shape),
                       json_list(points,
                                 [](const WayPoint& p) {
                                   return fmt::format("[{}, {}]", json_number(p.at.x.value()),
                                                      json_number(p.at.y.value()));
                                 }),
                       json_list(points, [](const WayPoint& p) { return json_number(p.time.value()); }),
                       json_list(points, [](const WayPoint& p) { return json_number(p.degrees.value()); }));
  };
  return fmt::format(R"(, "motion": {{"start": {}, "end": {}, "movements": {}}})", json_number(motion->start.value()),
                     json_number(motion->end.value()), json_list(motion->paths, movement));
}

std::string Loaded::summary_json(bool drawing) const {
  const std::vector<std::string> used = scene_.used();
  const std::string shapes =
      json_list(scene_.names(), [&](const std::string& name) { return shape_json(name, used, drawing); });
  const std::string unit = scene_.unit();
  const std::string unit_key = unit.empty() ? "" : fmt::format("\"unit\": {}, ", json_string(unit));
  return fmt::format(
      R"({{"dimension": {}, {}"step": {}, "y": "{}", "clockwise": {}, "where": {}, "moving": {}, {}{}, "place": {}, )"
      R"("shapes": {}, "words": {}}})",
      scene_.dimension(), unit_key, json_number(scene_.grid().step.value()), scene_.y_down() ? "down" : "up",
      scene_.clockwise(), json_string(scene_.asks() ? scene_.where().text() : ""),
      json_list(scene_.moving(), json_string), free_json(), motion_json(), scene_.places(), shapes, words());
}

std::string Loaded::explain_json(const Spot& spot, const std::optional<Kind>& over) const {
  require_moving();
  if (over) {
    Scene::Question free;
    free.free = *over;
    return asked().asking(free).explain({spot.at, {}, {}}).json();
  }
  const bool drawn = spot.angle || !(is_free(Kind::kAngle) || is_free(Kind::kPose) || is_free(Kind::kTime));
  const Scene question = drawn ? asked() : scene_.asks() ? scene_ : asking(scene_, "");
  return question.explain({spot.at, spot.angle, spot.time}).json();
}

std::string Loaded::place_json(double seconds, const PlaceQuestion& question) const {
  if (!scene_.places()) throw Error(ErrorCode::kBadValue, "the scene has no \"place\"", scene_.name());
  findspace::Options limits;
  limits.seconds = seconds;
  return scene_.with(limits).place(question).json();
}

std::string with_member(std::string object, std::string_view name, std::string_view value) {
  object.resize(object.rfind('}'));
  return fmt::format("{}, \"{}\": {}}}", object, name, value);
}

}  // namespace findspace::app
