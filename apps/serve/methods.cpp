// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "serve/methods.h"

#include <fmt/format.h>

#include <algorithm>

#include "formula/language/names.h"
#include "io/write/json_text.h"

namespace findspace::app {
namespace {

using exact::Real;
using exact::RealPoint;
using io::JsonValue;
using JsonKind = JsonValue::Kind;

constexpr std::string_view
    kText = R"({"type": "string"})",
    kFlag = R"({"type": "boolean", "default": false})",
    kNames = R"({"type": "array", "items": {"type": "string"}, "minItems": 1})",
    kPosition = R"({"type": "array", "items": {"type": ["number", "string"]}, "minItems": 2, "maxItems": 2})",
    kLength = R"({"type": "number", "minimum": 0})", kName = R"({"type": "string", "default": "scene"})";
constexpr Parameter kOfScene{"scene", kName, "the name under which the scene was loaded"};
constexpr Parameter kAt{"at", kPosition, "the position [x, y] in the scene's unit; a string is taken exactly", true};
constexpr Parameter kDrawing{"drawing", kFlag, "path data too, in the scene's unit with y down"};

constexpr Parameter kLoadParameters[] = {
    kOfScene,
    {"path", kText, "the scene file, below the folder that is served"},
    {"text", kText, "or the scene itself; it reads no files"},
    kDrawing,
};
constexpr Parameter kSceneParameters[] = {kOfScene, kDrawing};
constexpr Parameter kMapParameters[] = {
    kOfScene, kDrawing, {"where", kText, "of this formula instead; the scene keeps its own"}};
constexpr Parameter kSetParameters[] = {
    kOfScene, {"where", kText, "another formula"}, {"moving", kNames, "other moving shapes"}};
constexpr Parameter kPositionParameters[] = {kOfScene, kAt};
constexpr Parameter kCheckParameters[] = {
    kOfScene,
    kAt,
    {"nearest", kFlag, "the nearest feasible position too, where this one is not"},
    {"snap", kLength, "where the nearest feasible position is no farther, the answer is about that one, exactly"}};
constexpr Parameter kExplainParameters[] = {kOfScene, {"at", kPosition, "what stands in the way of this position too"}};
constexpr Parameter kUnloadParameters[] = {kOfScene};

[[noreturn]] void refuse(std::string message) { throw RequestError{RequestError::kParams, std::move(message)}; }

const JsonValue* find(const JsonValue& parameters, std::string_view key, JsonKind kind, std::string_view wanted) {
  const JsonValue* value = parameters.find(key);
  if (value != nullptr && !value->is(kind))
    refuse(fmt::format("\"{}\" is {}, not {}", key, wanted, value->kind_name()));
  return value;
}

std::optional<std::string> text(const JsonValue& parameters, std::string_view key) {
  const JsonValue* value = find(parameters, key, JsonKind::kString, "a string");
  return value == nullptr ? std::nullopt : std::optional(value->text);
}

bool flag(const JsonValue& parameters, std::string_view key) {
  const JsonValue* value = find(parameters, key, JsonKind::kBoolean, "true or false");
  return value != nullptr && value->boolean;
}

std::string name_of(const JsonValue& parameters) { return text(parameters, "scene").value_or("scene"); }

std::optional<RealPoint> position(const JsonValue& parameters) {
  const JsonValue* value = find(parameters, "at", JsonKind::kArray, "a list of two numbers");
  if (value == nullptr) return std::nullopt;
  if (value->size() != 2) refuse("\"at\" is a list of two numbers");
  std::array<Real, 2> p;
  for (std::size_t k : {0, 1}) {
    const JsonValue& item = value->items[k];
    if (!item.is(JsonKind::kNumber) && !item.is(JsonKind::kString)) refuse("\"at\" is a list of two numbers");
    p[k] = Real::parse_decimal(item.text);
  }
  return RealPoint{p[0], p[1]};
}

RealPoint needed_position(const JsonValue& parameters) {
  const auto p = position(parameters);
  if (!p) refuse("\"at\" is missing");
  return *p;
}

std::string load(SceneStore& store, const JsonValue& parameters) {
  const auto path = text(parameters, "path"), content = text(parameters, "text");
  if (path.has_value() == content.has_value()) refuse("load takes either \"path\" or \"text\"");
  const std::string name = name_of(parameters);
  io::ReadOptions without_files = store.reading();
  without_files.files = false;
  store.keep(name, path ? io::read_scene(store.within_root(*path), store.reading())
                        : io::read_scene_text(*content, store.root(), name, without_files));
  return store.scene(name).summary_json(flag(parameters, "drawing"));
}

std::string scene(SceneStore& store, const JsonValue& parameters) {
  return store.scene(name_of(parameters)).summary_json(flag(parameters, "drawing"));
}

std::string set(SceneStore& store, const JsonValue& parameters) {
  LoadedScene& scene = store.scene(name_of(parameters));
  if (const JsonValue* moving = find(parameters, "moving", JsonKind::kArray, "a list of names")) {
    std::vector<std::string> names;
    for (const JsonValue& item : moving->items) names.push_back(item.text);
    scene.set_moving(names);
  }
  if (const auto where = text(parameters, "where")) scene.set_where(*where);
  return scene.summary_json(false);
}

std::string map(SceneStore& store, const JsonValue& parameters) {
  return store.scene(name_of(parameters)).map_json(flag(parameters, "drawing"), text(parameters, "where"));
}

std::string check(SceneStore& store, const JsonValue& parameters) {
  const JsonValue* snap = find(parameters, "snap", JsonKind::kNumber, "a number");
  return store.scene(name_of(parameters))
      .check_json(needed_position(parameters), flag(parameters, "nearest"),
                  snap == nullptr ? Real() : Real::parse_decimal(snap->text));
}

std::string nearest(SceneStore& store, const JsonValue& parameters) {
  return store.scene(name_of(parameters)).nearest_json(needed_position(parameters));
}

std::string measure(SceneStore& store, const JsonValue& parameters) {
  return store.scene(name_of(parameters)).measure_json(needed_position(parameters));
}

std::string explain(SceneStore& store, const JsonValue& parameters) {
  return store.scene(name_of(parameters)).explain_json(position(parameters));
}

std::string unload(SceneStore& store, const JsonValue& parameters) {
  store.forget(name_of(parameters));
  return "{}";
}

constexpr Method kMethods[] = {
    {"load", "Reads a scene, keeps it, and says what it has.", kLoadParameters, load},
    {"scene", "Says what a loaded scene has: unit, shapes, what moves, the formula.", kSceneParameters, scene},
    {"set", "Gives a loaded scene another formula or other moving shapes.", kSetParameters, set},
    {"map", "Where can the moving shape go: the exact region of all feasible positions.", kMapParameters, map},
    {"check", "Is this position feasible: the value and truth of every condition.", kCheckParameters, check},
    {"nearest", "The nearest feasible position.", kPositionParameters, nearest},
    {"measure", "How far the moving shape is from each other shape.", kPositionParameters, measure},
    {"explain", "Why no position is feasible and what would change that; else how much slack each level has.",
     kExplainParameters, explain},
    {"unload", "Forgets a scene.", kUnloadParameters, unload},
};

std::vector<std::string> names_of(std::span<const Parameter> parameters) {
  std::vector<std::string> out;
  for (const Parameter& p : parameters) out.emplace_back(p.name);
  return out;
}

/// A name that the table does not have is a mistake, not something to pass over.
void check_names(const Method& method, const JsonValue& parameters) {
  const std::vector<std::string> known = names_of(method.parameters);
  for (const std::string& key : parameters.keys) {
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    refuse(fmt::format("{} has no parameter \"{}\"; it has {}", method.name, key, fmt::join(known, ", ")));
  }
}

}  // namespace

std::span<const Method> methods() { return kMethods; }

std::string parameters_schema(const Method& method) {
  std::string properties;
  std::vector<std::string> required;
  for (const Parameter& p : method.parameters) {
    std::string schema(p.schema);
    schema.pop_back();
    io::put(properties, R"({}"{}": {}, "description": {}}})", properties.empty() ? "" : ", ", p.name, schema,
            io::json_string(p.about));
    if (p.required) required.emplace_back(p.name);
  }
  const std::string must =
      required.empty() ? "" : fmt::format(R"(, "required": {})", io::list(required, io::json_string));
  return fmt::format(R"({{"type": "object", "properties": {{{}}}{}, "additionalProperties": false}})", properties,
                     must);
}

std::string protocol_json() {
  std::string out = "{\"protocol\": \"findspace\", \"version\": 1,\n  \"methods\": ";
  out += io::list(
      methods(),
      [](const Method& m) {
        return fmt::format("{{\"name\": \"{}\", \"description\": {},\n       \"params\": {}}}", m.name,
                           io::json_string(m.about), parameters_schema(m));
      },
      true);
  return out + "}\n";
}

std::string SceneStore::call(std::string_view name, const JsonValue& parameters) {
  for (const Method& m : methods()) {
    if (m.name != name) continue;
    if (!parameters.is(JsonKind::kObject) && !parameters.is(JsonKind::kNull)) refuse("params are an object");
    check_names(m, parameters);
    return m.run(*this, parameters);
  }
  throw RequestError{RequestError::kMethod, fmt::format("there is no method '{}'", name)};
}

LoadedScene& SceneStore::scene(const std::string& name) {
  const auto found = scenes_.find(name);
  if (found == scenes_.end()) refuse(fmt::format("no scene '{}' is loaded", name));
  return *found->second;
}

void SceneStore::keep(const std::string& name, io::Scene scene) {
  scenes_[name] = std::make_unique<LoadedScene>(std::move(scene));
}

void SceneStore::forget(const std::string& name) {
  scene(name);
  scenes_.erase(name);
}

SceneStore::SceneStore(const Options& options) : reading_(app::reading(options)) {
  const std::filesystem::path scene(options.scene);
  if (reading_.root.empty())
    reading_.root = scene.parent_path().empty() ? std::filesystem::current_path() : scene.parent_path();
  reading_.root = std::filesystem::weakly_canonical(reading_.root);
  if (!scene.empty()) keep("scene", io::read_scene(scene, reading_));
}

std::filesystem::path SceneStore::within_root(const std::string& path) const {
  const std::filesystem::path whole = std::filesystem::weakly_canonical(root() / path);
  const auto [end, unused] = std::mismatch(root().begin(), root().end(), whole.begin(), whole.end());
  if (end != root().end()) throw Error(ErrorCode::kFile, "lies outside the folder that is served", path);
  return whole;
}

}  // namespace findspace::app
