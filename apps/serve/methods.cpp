// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "serve/methods.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "findspace/error.h"
#include "findspace/text.h"
#include "findspace/vocabulary.h"

namespace findspace::app {
namespace {

using JsonKind = JsonValue::Kind;

constexpr std::string_view
    kText = R"({"type": "string"})",
    kFlag = R"({"type": "boolean", "default": false})",
    kNames = R"({"type": "array", "items": {"type": "string"}, "minItems": 1})",
    kPosition = R"({"type": "array", "items": {"type": ["number", "string"]}, "minItems": 2, "maxItems": 3})",
    kPlace = R"({"type": "array", "items": {"type": ["number", "string"]}, "minItems": 2, "maxItems": 2})",
    kNumber = R"({"type": ["number", "string"]})", kLength = R"({"type": "number", "minimum": 0})",
    kCount = R"({"type": "integer", "minimum": 1, "maximum": 1024})", kWhole = R"({"type": "integer", "minimum": 0})",
    kOperation = R"({"enum": ["interior", "closure", "boundary", "regularize", "complement"]})",
    kNear =
        R"({"type": "array", "items": {"type": "object", "properties": {"shape": {"type": "string"}, "copy": {"type": "integer"}, "at": {"type": "array", "items": {"type": ["number", "string"]}, "minItems": 2, "maxItems": 3}, "angle": {"type": ["number", "string"]}}, "required": ["shape", "at"], "additionalProperties": false}})",
    kName = R"({"type": "string", "default": "scene"})";
constexpr Parameter kOfScene{"scene", kName, "the name under which the scene was loaded"};
constexpr Parameter kAt{"at", kPosition,
                        "the position [x, y] or [x, y, z] in the scene's unit; a string is taken exactly", true};
constexpr Parameter kAtLeftOut{"at", kPosition, "where the moving shape stands (default: as drawn)"};
constexpr Parameter kAngle{"angle", kNumber, "degrees by which the moving shape is rotated"};
constexpr Parameter kTime{"time", kNumber, "an instant of the motion; without it distances are over all its time"};
constexpr Parameter kDrawing{"drawing", kFlag,
                             "how it looks too, in the scene's unit: path data with y down, or faces in space"};

constexpr Parameter kLoadParameters[] = {
    kOfScene,
    {"path", kText, "the scene, drawing or board, below the folder that is served"},
    {"text", kText, "or the scene itself; it reads no files"},
    kDrawing,
};
constexpr Parameter kCopyParameters[] = {kOfScene, {"as", kText, "the other name", true}, kDrawing};
constexpr Parameter kSceneParameters[] = {kOfScene, kDrawing};
constexpr Parameter kMapParameters[] = {
    kOfScene,
    kDrawing,
    {"brief", kFlag, "only whether it is empty, one position of it, and how it looks"},
    {"where", kText, "of this formula instead; the scene keeps its own"},
    {"apply", kOperation, "what the region is made into"},
    kAngle,
    {"resolution", kCount, "in space, where the region is not exact: lines each way (default 64)"}};
constexpr Parameter kSetParameters[] = {
    kOfScene, {"where", kText, "another formula"}, {"moving", kNames, "other moving shapes"}};
constexpr Parameter kPositionParameters[] = {kOfScene, kAt, kAngle};
constexpr Parameter kPlainParameters[] = {kOfScene, kAt};
constexpr Parameter kCheckParameters[] = {
    kOfScene,
    kAt,
    kAngle,
    kTime,
    {"nearest", kFlag, "the nearest feasible position too, where this one is not"},
    {"snap", kLength,
     "where a corner, an edge or the nearest feasible position is no farther, the answer is about that "
     "one, exactly"}};
constexpr Parameter kExplainParameters[] = {
    kOfScene,
    {"at", kPosition, "what stands in the way of this position too"},
    kAngle,
    {"over", R"({"enum": ["angles", "instants"]})", "of all angles, or all instants of the motion, at the position"}};
constexpr Parameter kBetweenParameters[] = {kOfScene,
                                            {"from", kPlace, "a place at the first feature", true},
                                            {"to", kPlace, "a place at the second feature", true},
                                            kAtLeftOut,
                                            kAngle};
constexpr Parameter kPlaceParameters[] = {kOfScene,
                                          {"seconds", kLength, "give what there is after so long (0: never)"},
                                          {"near", kNear, "these come first, each as near to its place as it goes"}};
constexpr Parameter kUnloadParameters[] = {kOfScene};
constexpr Parameter kPackParameters[] = {
    kOfScene,
    {"path", kText, "the problem as nesting JSON, below the folder that is served"},
    {"text", kText, "or the problem itself; without both the one that is loaded"},
    {"height", kText, "the height of the strip, a decimal, instead of the problem's"},
    {"gap", kText, "the least distance of any two parts, a decimal"},
    {"edge", kText, "the least distance of a part to the sides of the strip, a decimal"},
    {"start", kText, "a layout to begin with, as JSON; it is the best one then"},
    {"seed", kWhole, "another search (default 1)"},
    {"threads", kCount, "of the search (default: one for each core)"},
    {"seconds", kLength, "end after so long (default: when no better layout comes for a while)"},
    {"search", R"({"type": "boolean", "default": true})", "begin to search; else only say what the problem is"},
    kDrawing};
constexpr Parameter kPackingParameters[] = {
    kOfScene, {"since", kWhole, "the number of the layout that is known already: it is not given again"}};
constexpr Parameter kSheet{"sheet", kWhole,
                           "of the layout, from 0, to which the item is moved; else it stays on its own"};
constexpr Parameter kContainer{"container", kWhole, "the same of solids"};
constexpr Parameter kRepairParameters[] = {
    kOfScene,
    {"item", kWhole, "the number of an item in the layout, from 0", true},
    {"at", kPosition, "where it is moved to: two numbers, of solids three", true},
    kSheet,
    kContainer};
constexpr Parameter kVerifyParameters[] = {
    kOfScene,
    {"item", kWhole, "the number of an item in the layout, from 0, that is moved"},
    {"at", kPosition, "where it is moved to: two numbers, of solids three"},
    kSheet,
    kContainer};

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

Number number_of(const JsonValue& item, std::string_view key) {
  if (!item.is(JsonKind::kNumber) && !item.is(JsonKind::kString)) refuse(fmt::format("\"{}\" wants numbers", key));
  Number out = item.text;
  try {
    out.value();
  } catch (const Error& e) {
    refuse(fmt::format("\"{}\": {}", key, e.message()));
  }
  return out;
}

std::optional<Number> number(const JsonValue& parameters, std::string_view key) {
  const JsonValue* value = parameters.find(key);
  return value == nullptr ? std::nullopt : std::optional(number_of(*value, key));
}

double double_of(const JsonValue& parameters, std::string_view key, double otherwise) {
  const JsonValue* value = find(parameters, key, JsonKind::kNumber, "a number");
  if (value == nullptr) return otherwise;
  const double given = Number(value->text).value();
  if (given < 0) refuse(fmt::format("\"{}\" is a number from 0 on", key));
  return given;
}

std::uint64_t whole(const JsonValue& parameters, std::string_view key, std::uint64_t otherwise) {
  constexpr int kMost = 1 << 30;
  const auto value = number(parameters, key);
  if (!value) return otherwise;
  const double whole = value->value();
  if (whole != std::floor(whole) || whole < 0 || whole > kMost) refuse(fmt::format("\"{}\" is a whole number", key));
  return static_cast<std::uint64_t>(whole);
}

unsigned threads_of(const JsonValue& parameters) {
  constexpr std::uint64_t kMost = 1024;
  const std::uint64_t threads = whole(parameters, "threads", 0);
  if (threads > kMost) refuse(fmt::format("\"threads\" is at most {}", kMost));
  return static_cast<unsigned>(threads);
}

/// A list of `count` numbers, or of two or three where that is 0.
std::vector<Number> numbers(const JsonValue& parameters, std::string_view key, std::size_t count) {
  const JsonValue* value = find(parameters, key, JsonKind::kArray, "a list of numbers");
  if (value == nullptr) return {};
  const bool fits = count > 0 ? value->size() == count : value->size() == 2 || value->size() == 3;
  if (!fits) refuse(fmt::format("\"{}\" is a list of {} numbers", key, count > 0 ? "two" : "two or three"));
  std::vector<Number> out;
  for (const JsonValue& item : value->items) out.push_back(number_of(item, key));
  return out;
}

Point needed_point(const JsonValue& parameters, std::string_view key) {
  const std::vector<Number> p = numbers(parameters, key, 2);
  if (p.empty()) refuse(fmt::format("\"{}\" is missing", key));
  return {p[0], p[1]};
}

Spot spot_of(const JsonValue& parameters) {
  return {numbers(parameters, "at", 0), number(parameters, "angle"), number(parameters, "time")};
}

Spot needed_spot(const JsonValue& parameters) {
  Spot spot = spot_of(parameters);
  if (spot.at.empty()) refuse("\"at\" is missing");
  return spot;
}

std::string load(SceneStore& store, const JsonValue& parameters) {
  const auto path = text(parameters, "path"), content = text(parameters, "text");
  if (path.has_value() == content.has_value()) refuse("load takes either \"path\" or \"text\"");
  const std::string name = name_of(parameters);
  if (path)
    store.load(name, *path);
  else
    store.load_text(name, *content);
  return store.scene(name).summary_json(flag(parameters, "drawing"));
}

std::string copy(SceneStore& store, const JsonValue& parameters) {
  const auto as = text(parameters, "as");
  if (!as) refuse("\"as\" is missing");
  store.copy(name_of(parameters), *as);
  return store.scene(*as).summary_json(flag(parameters, "drawing"));
}

std::string source(SceneStore& store, const JsonValue& parameters) {
  return fmt::format(R"({{"text": {}}})", json_string(store.source(name_of(parameters))));
}

std::string scene(SceneStore& store, const JsonValue& parameters) {
  return store.scene(name_of(parameters)).summary_json(flag(parameters, "drawing"));
}

std::string set(SceneStore& store, const JsonValue& parameters) {
  const std::string name = name_of(parameters);
  const auto where = text(parameters, "where");
  if (const JsonValue* moving = find(parameters, "moving", JsonKind::kArray, "a list of names")) {
    Scene::Question question;
    question.moving.emplace();
    for (const JsonValue& item : moving->items) question.moving->push_back(item.text);
    question.where = where;
    store.keep(name, Loaded::asking(store.scene(name).scene(), question));
  } else if (where) {
    store.scene(name).set_where(*where);
  }
  return store.scene(name).summary_json(false);
}

std::string map(SceneStore& store, const JsonValue& parameters) {
  RegionQuery query;
  query.drawing = flag(parameters, "drawing");
  query.brief = flag(parameters, "brief");
  query.where = text(parameters, "where");
  query.apply = text(parameters, "apply").value_or("");
  constexpr std::array<std::string_view, 6> kOperations{"",         "interior",   "closure",
                                                        "boundary", "regularize", "complement"};
  if (std::find(kOperations.begin(), kOperations.end(), query.apply) == kOperations.end())
    refuse("\"apply\" is one of interior, closure, boundary, regularize, complement");
  query.angle = number(parameters, "angle");
  constexpr std::uint64_t kMostLines = 1024;
  const std::uint64_t lines = whole(parameters, "resolution", 0);
  if (parameters.find("resolution") != nullptr && (lines < 1 || lines > kMostLines))
    refuse(fmt::format("\"resolution\" is a whole number from 1 to {}", kMostLines));
  query.resolution = static_cast<int>(lines);
  return store.scene(name_of(parameters)).map_json(query);
}

std::string check(SceneStore& store, const JsonValue& parameters) {
  const JsonValue* snap = find(parameters, "snap", JsonKind::kNumber, "a number");
  const Loaded& loaded = store.scene(name_of(parameters));
  CheckQuestion question{flag(parameters, "nearest"), {}};
  if (snap != nullptr) question.snap = snap->text;
  return loaded.check_json(needed_spot(parameters), question);
}

std::string nearest(SceneStore& store, const JsonValue& parameters) {
  const Loaded& loaded = store.scene(name_of(parameters));
  return loaded.nearest_json(needed_spot(parameters));
}

std::string measure(SceneStore& store, const JsonValue& parameters) {
  const Loaded& loaded = store.scene(name_of(parameters));
  return loaded.measure_json(needed_spot(parameters));
}

std::string between(SceneStore& store, const JsonValue& parameters) {
  const Loaded& loaded = store.scene(name_of(parameters));
  return loaded.between_json(spot_of(parameters), needed_point(parameters, "from"), needed_point(parameters, "to"));
}

std::string explain(SceneStore& store, const JsonValue& parameters) {
  const Loaded& loaded = store.scene(name_of(parameters));
  const std::string over = text(parameters, "over").value_or("");
  if (over.empty()) return loaded.explain_json(spot_of(parameters), std::nullopt);
  if (over != "angles" && over != "instants") refuse("\"over\" is \"angles\" or \"instants\"");
  return loaded.explain_json(needed_spot(parameters),
                             over == "angles" ? Scene::Free::Kind::kAngle : Scene::Free::Kind::kTime);
}

std::string angles(SceneStore& store, const JsonValue& parameters) {
  const Loaded& loaded = store.scene(name_of(parameters));
  return loaded.angles_json(needed_spot(parameters));
}

std::string instants(SceneStore& store, const JsonValue& parameters) {
  const Loaded& loaded = store.scene(name_of(parameters));
  return loaded.instants_json(needed_spot(parameters));
}

PlaceQuestion::Near near_of(const JsonValue& item) {
  if (!item.is(JsonKind::kObject)) refuse("\"near\" is a list of objects");
  PlaceQuestion::Near out;
  const auto shape = text(item, "shape");
  if (!shape) refuse("\"shape\" is missing in \"near\"");
  out.name = *shape;
  out.copy = static_cast<int>(whole(item, "copy", 0));
  if (numbers(item, "at", 0).empty()) refuse("\"at\" is missing in \"near\"");
  for (const JsonValue& c : item.find("at")->items) out.at.emplace_back(c.text);
  if (number(item, "angle")) out.degrees = item.find("angle")->text;
  return out;
}

std::string place(SceneStore& store, const JsonValue& parameters) {
  PlaceQuestion question;
  if (const JsonValue* given = find(parameters, "near", JsonKind::kArray, "a list"))
    for (const JsonValue& item : given->items) question.near.push_back(near_of(item));
  return store.scene(name_of(parameters)).place_json(double_of(parameters, "seconds", 0), question);
}

std::string pack(SceneStore& store, const JsonValue& parameters) {
  const auto path = text(parameters, "path"), content = text(parameters, "text");
  if (path && content) refuse("pack takes either \"path\" or \"text\"");
  const std::string name = name_of(parameters);
  if (path || content) {
    PackReading asked;
    if (const auto height = text(parameters, "height")) asked.height = *height;
    asked.gap = text(parameters, "gap").value_or("0");
    asked.edge = text(parameters, "edge").value_or("0");
    if (path)
      store.load_problem(name, *path, asked);
    else
      store.load_problem_text(name, *content, asked);
  }
  PackingJob& job = store.packing(name);
  if (const auto start = text(parameters, "start")) job.begin_with(*start);
  const JsonValue* search = find(parameters, "search", JsonKind::kBoolean, "true or false");
  if (search == nullptr || search->boolean)
    job.start({whole(parameters, "seed", 1), threads_of(parameters), double_of(parameters, "seconds", 0)});
  return job.problem_json(flag(parameters, "drawing"));
}

std::string packing(SceneStore& store, const JsonValue& parameters) {
  return store.packing(name_of(parameters)).state_json(whole(parameters, "since", 0));
}

std::string stop(SceneStore& store, const JsonValue& parameters) {
  PackingJob& job = store.packing(name_of(parameters));
  job.stop();
  return job.state_json(0);
}

/// Nothing where no item is named.
std::optional<MovedItem> moved_item(const JsonValue& parameters) {
  const JsonValue* at = find(parameters, "at", JsonKind::kArray, "a list of numbers");
  if ((at == nullptr) != (parameters.find("item") == nullptr)) refuse("\"item\" and \"at\" go together");
  if (at == nullptr) return std::nullopt;
  numbers(parameters, "at", 0);  // refuses what is none
  MovedItem result{whole(parameters, "item", 0), {}};
  for (const JsonValue& number : at->items) result.at.emplace_back(number.text);
  for (const char* holder : {"sheet", "container"})
    if (parameters.find(holder) != nullptr) result.in = whole(parameters, holder, 0);
  return result;
}

std::string repair(SceneStore& store, const JsonValue& parameters) {
  PackingJob& job = store.packing(name_of(parameters));
  const auto moved = moved_item(parameters);
  if (!moved) refuse("\"item\" is missing");
  job.repair(*moved);
  return job.state_json(0);
}

std::string verify(SceneStore& store, const JsonValue& parameters) {
  return store.packing(name_of(parameters)).verdict_json(moved_item(parameters));
}

std::string unload(SceneStore& store, const JsonValue& parameters) {
  store.forget(name_of(parameters));
  return "{}";
}

constexpr Method kMethods[] = {
    {"load", "Reads a scene, keeps it, and says what it has.", kLoadParameters, load},
    {"scene", "Says what a loaded scene has: unit, shapes, what moves, the formula.", kSceneParameters, scene},
    {"copy", "Keeps a loaded scene under another name too, where it has a formula of its own.", kCopyParameters, copy},
    {"source", "The text of a scene with the formula and the moving shapes that it has now.", kUnloadParameters,
     source},
    {"set", "Gives a loaded scene another formula or other moving shapes.", kSetParameters, set},
    {"map", "Where can the moving shape go: the exact region of all feasible positions.", kMapParameters, map},
    {"check", "Is this position feasible: the value and truth of every condition.", kCheckParameters, check},
    {"nearest", "The nearest feasible position.", kPositionParameters, nearest},
    {"measure", "How far the moving shape is from each other shape.", kPositionParameters, measure},
    {"between", "The distance between the vertices, edges or arcs that are nearest to two places.", kBetweenParameters,
     between},
    {"explain", "Why no position is feasible and what would change that; else how much slack each level has.",
     kExplainParameters, explain},
    {"angles", "At which angles the moving shape can stand at a position.", kPlainParameters, angles},
    {"instants", "At which instants of the motion the formula holds at a position.", kPlainParameters, instants},
    {"place", "The placement of several shapes that the scene asks for.", kPlaceParameters, place},
    {"pack", "Begins to pack the parts of a problem, in the plane or in space, or goes on with a loaded one.",
     kPackParameters, pack},
    {"packing", "How far a packing is: its best layout, proved, and whether it goes on.", kPackingParameters, packing},
    {"stop", "Ends a packing and keeps its best layout.", kUnloadParameters, stop},
    {"verify", "What is wrong with the best layout of a packing, perhaps with one part moved.", kVerifyParameters,
     verify},
    {"repair", "Moves one part of a layout and the others out of its way.", kRepairParameters, repair},
    {"unload", "Forgets a scene or a packing.", kUnloadParameters, unload},
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
    properties += fmt::format(R"({}"{}": {}, "description": {}}})", properties.empty() ? "" : ", ", p.name, schema,
                              json_string(p.about));
    if (p.required) required.emplace_back(p.name);
  }
  const std::string must = required.empty() ? "" : fmt::format(R"(, "required": {})", json_list(required, json_string));
  return fmt::format(R"({{"type": "object", "properties": {{{}}}{}, "additionalProperties": false}})", properties,
                     must);
}

std::string protocol_json() {
  std::string out = "{\"protocol\": \"findspace\", \"version\": 1,\n  \"methods\": ";
  out += json_list(
      methods(),
      [](const Method& m) {
        return fmt::format("{{\"name\": \"{}\", \"description\": {},\n       \"params\": {}}}", m.name,
                           json_string(m.about), parameters_schema(m));
      },
      true);
  return out + "}\n";
}

std::string run_method(SceneStore& store, std::string_view name, const JsonValue& parameters) {
  for (const Method& m : methods()) {
    if (m.name != name) continue;
    if (!parameters.is(JsonKind::kObject) && !parameters.is(JsonKind::kNull)) refuse("params are an object");
    check_names(m, parameters);
    return m.run(store, parameters);
  }
  std::vector<std::string> known;
  for (const Method& m : methods()) known.emplace_back(m.name);
  const std::string near = nearest_word(name, known);
  throw RequestError{RequestError::kMethod,
                     fmt::format("there is no method '{}'; {}", name,
                                 near.empty() ? fmt::format("the methods are {}", fmt::join(known, ", "))
                                              : fmt::format("did you mean '{}'?", near))};
}

}  // namespace findspace::app
