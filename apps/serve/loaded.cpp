// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "serve/loaded.h"

#include <fmt/format.h>

#include <algorithm>

#include "findspace/error.h"
#include "findspace/text.h"
#include "findspace/vocabulary.h"
#include "io/write/write_position.h"
#include "io/write/write_witness.h"
#include "serve/loaded_plane.h"
#include "serve/loaded_space.h"

namespace findspace::app {
namespace {

constexpr std::array<const char*, 5> kFreeNames{"position", "line", "angle", "time", "pose"};

bool holds(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string numbers(const std::vector<exact::Real>& values) {
  return json_list(values, [](const exact::Real& v) { return json_number(v.to_double()); });
}

/// What formulas are written with.
std::string words() {
  std::vector<std::string> all;
  for (PredicateWord& row : predicate_words()) all.push_back(std::move(row.word));
  for (DistanceWord& row : distance_words()) all.push_back(std::move(row.word));
  return json_list(all, json_string);
}

}  // namespace

std::unique_ptr<Loaded> Loaded::make(io::Scene scene) {
  if (scene.dimension == 3) return std::make_unique<LoadedSpace>(std::move(scene));
  return std::make_unique<LoadedPlane>(std::move(scene));
}

std::string Loaded::unit() const { return scene_.unit ? std::string(formula::name(*scene_.unit)) : ""; }

void Loaded::refuse(const std::string& what) const {
  throw Error(ErrorCode::kUnsupported, what + " is not computed", scene_.file);
}

void Loaded::require_moving() const {
  if (scene_.moving.empty())
    throw Error(ErrorCode::kBadValue, "the scene does not say which shape is \"moving\"", scene_.file);
}

void Loaded::read_formula() {
  formula_ = with_session([](const Session& session) { return session.where(); });
}

formula::Formula Loaded::parsed(const std::string& where) const {
  if (where.empty()) return {};
  return with_session([&](const Session& session) { return formula::parse_formula(where, session.context()); });
}

void Loaded::set_where(const std::string& where) {
  formula::Formula other = parsed(where);
  formula_ = std::move(other);
  scene_.where = {where, "formula", 1, 1};
  scene_.conditions.clear();
  forget_answers();
}

std::string Loaded::shape_json(const std::string& name, bool drawing) const {
  const auto& atoms = formula_.atoms();
  const bool used = std::any_of(atoms.begin(), atoms.end(), [&](const formula::Atom& a) {
    return holds(a.distance.first, name) || holds(a.distance.second, name);
  });
  std::string out =
      fmt::format(R"({{"name": {}, "moving": {}, "used": {})", json_string(name), holds(scene_.moving, name), used);
  const std::string look = drawing ? drawing_of(name) : "";
  if (!look.empty()) out += ", \"drawing\": " + look;
  return out + "}";
}

std::string Loaded::free_json() const {
  using Kind = io::Free::Kind;
  const io::Free& free = scene_.free;
  std::string out = fmt::format(R"("free": "{}")", kFreeNames[static_cast<std::size_t>(free.kind)]);
  if (free.kind == Kind::kAngle || free.kind == Kind::kPose)
    out += fmt::format(R"(, "about": [{}, {}])", json_number(double(free.about[0]) * step()),
                       json_number(double(free.about[1]) * step()));
  if (free.kind == Kind::kPose) out += ", \"angles\": " + numbers(free.angles);
  return out;
}

std::string Loaded::motion_json() const {
  if (!scene_.motion.given()) return "";
  const auto movement = [&](const io::Movement& m) {
    const std::string path = json_list(m.path, [&](const io::GridPosition& p) {
      return fmt::format("[{}, {}]", json_number(double(p[0]) * step()), json_number(double(p[1]) * step()));
    });
    return fmt::format(R"({{"shape": {}, "path": {}, "times": {}, "angles": {}}})", json_string(m.shape), path,
                       numbers(m.times), numbers(m.angles));
  };
  return fmt::format(R"(, "motion": {{"start": {}, "end": {}, "movements": {}}})",
                     json_number(scene_.motion.start.to_double()), json_number(scene_.motion.end.to_double()),
                     json_list(scene_.motion.movements, movement));
}

std::string Loaded::summary_json(bool drawing) const {
  std::vector<std::string> names;
  for (const plane::ShapePtr& s : scene_.shapes) names.push_back(s->name);
  const std::string shapes = json_list(names, [&](const std::string& name) { return shape_json(name, drawing); });
  const std::string unit_key = unit().empty() ? "" : fmt::format("\"unit\": {}, ", json_string(unit()));
  return fmt::format(R"({{"dimension": {}, {}"step": {}, "y": "{}", "where": {}, "moving": {}, {}{}, "place": {}, )"
                     R"("shapes": {}, "words": {}}})",
                     scene_.dimension, unit_key, json_number(step()), scene_.y_down ? "down" : "up",
                     json_string(scene_.where.text), json_list(scene_.moving, json_string), free_json(), motion_json(),
                     scene_.place.given(), shapes, words());
}

std::string Loaded::place_json(double seconds, const PlaceQuestion& question) const {
  if (!scene_.place.given()) throw Error(ErrorCode::kBadValue, "the scene has no \"place\"", scene_.file);
  findspace::Options limits;
  limits.seconds = seconds;
  return with_session([&](const Session& session) { return session.asked().with(limits).place(question).json(); });
}

std::string Loaded::nearest_json(const Spot& spot) const {
  require_moving();
  const formula::TriedNearest near = nearest(spot);
  if (near) return "{" + io::nearest_member(*near) + "}";
  return fmt::format(R"({{"not_computed": {{"nearest_feasible": {}}}}})", json_string(near.refusal().error.message()));
}

std::string with_member(std::string object, std::string_view name, std::string_view value) {
  object.resize(object.rfind('}'));
  return fmt::format("{}, \"{}\": {}}}", object, name, value);
}

void check_reach(const io::Scene& scene, const Spot& spot) {
  if (spot.at.size() != std::size_t(scene.dimension))
    throw Error(ErrorCode::kBadValue, fmt::format("a position of this scene has {} numbers", scene.dimension),
                scene.file);
  for (const exact::Real& c : spot.at) scene.grid.steps(c);
}

}  // namespace findspace::app
