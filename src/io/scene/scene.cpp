// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/scene/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>
#include <system_error>

#include "io/scene/scene_curves.h"
#include "io/scene/scene_extras.h"
#include "io/scene/scene_shapes.h"
#include "io/text/read_text.h"

namespace findspace::io {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

constexpr std::array<std::string_view, 24> kKeys{
    "mend",  "curves",   "tolerance", "join",      "open_lines", "parts", "repair", "close_holes",
    "y",     "groups",   "$schema",   "findspace", "unit",       "grid",  "shapes", "moving",
    "where", "minimize", "maximize",  "free",      "motion",     "place", "about",  "angles"};

/// Decimals of a number as it is written.
int decimals_of(std::string_view text) {
  const std::size_t exponent = std::min(text.find_first_of("eE"), text.size()), point = text.find('.');
  int decimals = point < exponent ? static_cast<int>(exponent - point) - 1 : 0;
  if (exponent < text.size()) decimals -= std::atoi(std::string(text.substr(exponent + 1)).c_str());
  return std::max(decimals, 0);
}

/// Too large is infinite, too small is 0.
double to_double(std::string_view text) {
  double number = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  return read.ec == std::errc{} ? number : std::strtod(std::string(text).c_str(), nullptr);
}

/// The largest number in a value, and the most decimals of one.
struct NumberRange {
  double largest = 0;
  int decimals = 0;

  void add(const JsonValue& value) {
    if (value.is(JsonValue::Kind::kNumber)) add(value.text());
    for (const JsonValue& item : value.items()) add(item);
  }

  void add(std::string_view number) {
    if (add_usual(number)) return;
    largest = std::max(largest, std::abs(to_double(number)));
    decimals = std::max(decimals, decimals_of(number));
  }

  /// A number of few digits before the point and without an exponent does not pass 2^40 steps of 10^-6: how large it is
  /// decides nothing.
  bool add_usual(std::string_view number) {
    constexpr std::ptrdiff_t kFewDigits = 6;
    const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
    const char *const end = number.data() + number.size(), *const whole = number.data() + number.starts_with('-');
    const char* const point = std::find_if_not(whole, end, is_digit);
    if (point - whole > kFewDigits) return false;
    if (point == end) return true;
    if (*point != '.' || std::find_if_not(point + 1, end, is_digit) != end) return false;
    decimals = std::max(decimals, static_cast<int>(end - point) - 1);
    return true;
  }
};

/// 10^-6 of the unit, or coarser where numbers of the scene would lie beyond the grid and none loses a digit.
Grid usual_grid(const JsonValue& shapes) {
  NumberRange range;
  range.add(shapes);
  constexpr int kUsualDecimals = 6;
  constexpr double kMost = double(Grid::kLimit) / 4;  // leaves room to move
  int decimals = kUsualDecimals;
  const double most = range.largest * std::pow(10.0, kUsualDecimals) > double(Grid::kLimit) ? kMost : kInfinite;
  while (decimals > range.decimals && decimals > 0 && range.largest * std::pow(10.0, decimals) > most) --decimals;
  exact::int128 steps = 1;
  for (int k = 0; k < decimals; ++k) steps *= 10;
  return Grid(exact::Real::ratio(1, steps));
}

void read_header(const JsonValue& root, const SceneReader& json, Scene& scene) {
  json.expect(root, JsonValue::Kind::kObject, "a scene", {});
  json.check_keys(root, kKeys, {});
  if (const JsonValue* schema = root.find("$schema"))  // for editors: docs/scene.schema.json
    json.expect(*schema, JsonValue::Kind::kString, "\"$schema\"", {});
  const JsonValue& version = json.need(root, "findspace", {});
  Label label{nullptr, "findspace"};
  if (json.number(version, label).integer() != exact::int128(1)) {
    json.fail(ErrorCode::kUnsupported,
              fmt::format("this program reads format 1, not \"findspace\": {}", version.text()), label, version);
  }
  ReadContext& context = json.context();
  if (const JsonValue* unit = root.find("unit")) {
    Label at{nullptr, "unit"};
    const std::string_view name = json.text(*unit, "\"unit\"", at);
    context.unit = json.placed(at, *unit, [&] { return parse_unit(name); });
  }
  if (const JsonValue* grid = root.find("grid")) {
    Label at{nullptr, "grid"};
    exact::Real step = json.number(*grid, at);
    if (step.sign() <= 0) json.fail(ErrorCode::kBadValue, "\"grid\" must be more than 0", at, *grid);
    context.grid = Grid(step);
  } else if (const JsonValue* shapes = root.find("shapes")) {
    context.grid = usual_grid(*shapes);
  }
  context.scene_rules = read_drawing_rules(json, root, {});
  json.placed({}, root, [&] { context.use(context.options.drawings.over(context.scene_rules)); });
  scene.unit = context.unit;
  scene.grid = context.grid;
}

/// A formula, or a list of them that must all hold.
void read_where(const JsonValue& value, const SceneReader& json, Scene& scene) {
  const Label label{nullptr, "where"};
  if (!value.is(JsonValue::Kind::kArray)) {
    scene.where = json.formula(value, label);
    return;
  }
  if (value.size() == 0) json.fail(ErrorCode::kBadValue, "\"where\" is an empty list", label, value);
  for (std::size_t i = 0; i < value.size(); ++i)
    scene.conditions.push_back(json.formula(value.items()[i], label.part("condition", i)));
  for (const FormulaText& text : scene.conditions)
    scene.where.text += (scene.where.text.empty() ? "(" : " and (") + text.text + ")";
  scene.where.file = scene.conditions.front().file;
  scene.where.line = scene.conditions.front().line;
  scene.where.column = scene.conditions.front().column;
}

void read_direction_of_y(const JsonValue& value, const SceneReader& json, Scene& scene) {
  const Label label{nullptr, "y"};
  const std::string_view word = json.text(value, "\"y\"", label);
  if (word != "up" && word != "down")
    json.fail(ErrorCode::kBadValue, fmt::format("\"y\" runs \"up\" or \"down\", not '{}'", word), label, value);
  scene.y_down = word == "down";
}

void read_formulas(const JsonValue& root, const SceneReader& json, Scene& scene) {
  if (const JsonValue* value = root.find("where")) read_where(*value, json, scene);
  if (const JsonValue* value = root.find("y")) read_direction_of_y(*value, json, scene);
  if (const JsonValue* value = root.find("minimize")) scene.minimize = json.formula(*value, {nullptr, "minimize"});
  if (const JsonValue* value = root.find("maximize")) scene.maximize = json.formula(*value, {nullptr, "maximize"});
}

}  // namespace

std::string Scene::moving_text() const {
  return moving_name.empty() ? fmt::format("{}", fmt::join(moving, ", ")) : moving_name;
}

plane::ShapePtr Scene::find(std::string_view name) const {
  auto found = std::find_if(shapes.begin(), shapes.end(), [&](const plane::ShapePtr& s) { return s->name == name; });
  return found == shapes.end() ? nullptr : *found;
}

plane::ShapePtr Scene::shape(std::string_view name) const {
  if (plane::ShapePtr shape = find(name)) return shape;
  std::vector<std::string> names;
  for (const plane::ShapePtr& s : shapes) names.push_back(s->name);
  throw Error(ErrorCode::kUnknownName, fmt::format("unknown shape '{}'{}", name, choice("shapes", name, names)), file);
}

namespace {

/// The scene of one shape that stands alone, in the unit that its cells state.
Scene scene_of_shape(std::string_view shape, const JsonValue& value, JsonTree& tree, const std::string& name,
                     ReadContext& context) {
  const JsonValue* cells = value.find("cells");
  const JsonValue* unit = cells == nullptr ? nullptr : cells->find("unit");
  if (unit != nullptr) context.unit = formula::find_unit(unit->text());
  const JsonValue root = tree.object(shape, value);
  const SceneReader json(name, context);
  ShapeReader shapes(json, root);
  Scene scene;
  scene.file = name;
  scene.grid = context.grid;
  scene.unit = context.unit;
  scene.work_limit = context.options.work_limit;
  scene.shapes = shapes.all();
  scene.dimension = shapes.dimension();
  scene.notes = context.summary();
  return scene;
}

/// Of a result with its exact cells, in the place of a scene: the set, called as the file is; nothing of a scene.
std::optional<Scene> scene_of_cells(JsonTree& tree, const std::string& name, ReadContext& context) {
  const JsonValue& root = tree.root();
  const JsonValue* exact = root.is(JsonValue::Kind::kObject) ? root.find("exact") : nullptr;
  if (exact == nullptr || root.find("findspace") != nullptr || root.find("shapes") != nullptr) return std::nullopt;
  JsonValue shape = tree.object("cells", *exact);
  shape.line = root.line;
  shape.column = root.column;
  return scene_of_shape(std::filesystem::path(name).stem().string(), shape, tree, name, context);
}

}  // namespace

Scene read_scene_text(std::string_view text, const std::filesystem::path& folder, const std::string& name,
                      const ReadOptions& options) {
  ReadContext context(options);
  context.folder = folder;
  context.take_bytes(text.size(), name);
  JsonTree tree = parse_json(text, name, context.work);
  if (std::optional<Scene> alone = scene_of_cells(tree, name, context)) return *std::move(alone);
  const JsonValue& root = tree.root();
  SceneReader json(name, context);
  Scene scene;
  scene.file = name;
  scene.work_limit = options.work_limit;
  read_header(root, json, scene);
  ShapeReader shapes(json, json.need(root, "shapes", {}));
  scene.shapes = shapes.all();
  scene.dimension = shapes.dimension();
  read_formulas(root, json, scene);
  read_question(root, shapes, scene);
  scene.notes = context.summary();
  return scene;
}

Scene read_shape_text(std::string_view text, const exact::Real& grid, const std::filesystem::path& folder,
                      const std::string& name, const ReadOptions& options) {
  ReadContext context(options);
  context.folder = folder;
  context.grid = Grid(grid);
  context.take_bytes(text.size(), name);
  JsonTree tree = parse_json(text, name, context.work);
  return scene_of_shape("shape", tree.root(), tree, name, context);
}

Scene read_scene(const std::filesystem::path& path, const ReadOptions& options) {
  return read_scene_text(read_text(path, options.input_limit), path.parent_path(), path.string(), options);
}

}  // namespace findspace::io
