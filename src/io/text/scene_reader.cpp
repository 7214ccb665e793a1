// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/text/scene_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "exact/number/decimal.h"
#include "formula/language/lexer.h"
#include "formula/language/names.h"
#include "io/text/file_kind.h"

namespace findspace::io {

using exact::Real;

namespace {

constexpr std::string_view kMoreLevels = ", ... (";

void add_text(std::string_view text, fmt::memory_buffer& all) { all.append(text.data(), text.data() + text.size()); }

void add_number(long number, fmt::memory_buffer& all) {
  const fmt::format_int digits(number);
  add_text({digits.data(), digits.size()}, all);
}

/// Of such a file a scene was made, whose lines nobody has seen.
bool is_shape_file(std::string_view name) {
  const std::size_t dot = name.rfind('.');
  const std::string_view ending = dot == std::string_view::npos ? std::string_view() : name.substr(dot);
  if (ending.empty() || ending == ".json") return false;
  const std::string small = lower_ending(std::string(ending));
  return is_space_ending(small) || is_plane_ending(small);
}

}  // namespace

// Every shape has its place, so it is put together without formats.
std::size_t Label::put(fmt::memory_buffer& all, std::size_t within) const {
  constexpr std::size_t kFirst = 3, kLast = 3;  // of a long way the levels that are said
  const std::size_t about = outer != nullptr ? outer->put(all, within + 1) : 0, levels = about + 1 + within;
  if (levels > kFirst + kLast + 1 && about >= kFirst && within >= kLast) {
    if (about == kFirst) {
      add_text(kMoreLevels, all);
      add_number(static_cast<long>(levels - kFirst - kLast), all);
      add_text(" more)", all);
    }
    return about + 1;
  }
  if (all.size() > 0 && !what.empty()) add_text(", ", all);
  add_text(what, all);
  if (!name.empty()) {
    add_text(" '", all);
    add_text(name, all);
    add_text("'", all);
  }
  if (index >= 0) {
    add_text(" ", all);
    add_number(index, all);
  }
  return about + 1;
}

std::string Label::text() const {
  fmt::memory_buffer all;
  put(all);
  return fmt::to_string(all);
}

std::string SceneReader::place(const Label& label, const JsonValue& at) const {
  fmt::memory_buffer all;
  label.put(all);
  const bool bare = all.size() == 0;
  if (!bare) add_text(" (", all);
  add_text(file_, all);
  if (!is_shape_file(file_)) {
    add_text(":", all);
    add_number(at.line, all);
    add_text(":", all);
    add_number(at.column, all);
  }
  if (!bare) add_text(")", all);
  return fmt::to_string(all);
}

bool SceneReader::is_within(std::string_view place, const Label& label) {
  const std::string outer = label.text();
  // Of a long way the first levels are said, which the label may pass.
  const std::string_view first = place.substr(0, place.find(kMoreLevels));
  if (first.size() < place.size() && outer.size() > first.size() && outer.starts_with(first))
    return std::string_view(outer).substr(first.size()).starts_with(", ");
  if (outer.empty() || !place.starts_with(outer)) return false;
  place.remove_prefix(outer.size());
  return place.starts_with(", ") || place.starts_with(" (");
}

void SceneReader::fail(ErrorCode code, const std::string& message, const Label& label, const JsonValue& at) const {
  throw Error(code, message, place(label, at));
}

void SceneReader::expect(const JsonValue& value, JsonValue::Kind kind, std::string_view meaning,
                         const Label& label) const {
  if (value.kind == kind) return;
  fail(ErrorCode::kBadValue,
       fmt::format("{} must be {}, not {}", meaning, JsonValue(kind).kind_name(), value.kind_name()), label, value);
}

void SceneReader::check_keys(const JsonValue& object, std::span<const std::string_view> allowed,
                             const Label& label) const {
  for (std::size_t i = 0; i < object.size(); ++i) {
    const std::string_view key = object.keys()[i];
    if (std::find(allowed.begin(), allowed.end(), key) != allowed.end()) continue;
    std::vector<std::string> names(allowed.begin(), allowed.end());
    std::string hint = suggestion(key, names);
    if (hint.empty()) hint = fmt::format("; known here: {}", fmt::join(names, ", "));
    fail(ErrorCode::kUnknownName, fmt::format("unknown key '{}'{}", key, hint), label, object.items()[i]);
  }
}

const JsonValue& SceneReader::need(const JsonValue& object, std::string_view key, const Label& label) const {
  if (const JsonValue* value = object.find(key)) return *value;
  fail(ErrorCode::kBadValue, fmt::format("\"{}\" is missing", key), label, object);
}

Real SceneReader::number(const JsonValue& value, const Label& label) const {
  expect(value, JsonValue::Kind::kNumber, "this", label);
  return placed(label, value, [&] { return Real::parse_decimal(value.text()); });
}

std::string_view SceneReader::text(const JsonValue& value, std::string_view meaning, const Label& label) const {
  expect(value, JsonValue::Kind::kString, meaning, label);
  if (value.text().empty()) fail(ErrorCode::kBadValue, fmt::format("{} is an empty text", meaning), label, value);
  return value.text();
}

std::vector<std::string> SceneReader::texts(const JsonValue& value, std::string_view meaning,
                                            const Label& label) const {
  if (value.is(JsonValue::Kind::kString)) return {std::string(text(value, meaning, label))};
  expect(value, JsonValue::Kind::kArray, fmt::format("{} (if it is not a text)", meaning), label);
  if (value.size() == 0) fail(ErrorCode::kBadValue, fmt::format("{} is an empty list", meaning), label, value);
  std::vector<std::string> all;
  for (const JsonValue& item : value.items()) all.emplace_back(text(item, meaning, label));
  return all;
}

FormulaText SceneReader::formula(const JsonValue& value, const Label& label) const {
  return {std::string(text(value, fmt::format("\"{}\"", label.what), label)), file_, value.line, value.column + 1};
}

Real SceneReader::length(const JsonValue& value, const Label& label) const {
  Real number_of_units = number(value, label);
  return placed(label, value, [&] { return context_.grid.steps(number_of_units); });
}

plane::GridPoint SceneReader::point(const JsonValue& value, const Label& label) const {
  GridPosition p = position(value, 2, label);
  return {p[0], p[1]};
}

/// The usual case goes without big numbers.
std::int64_t SceneReader::coordinate(const JsonValue& value, double& moved, const Label& label) const {
  moved = 0;
  if (value.is(JsonValue::Kind::kNumber))
    if (const auto steps = exact::grid_integer(value.text(), context_.grid.step())) return *steps;
  const Real x = number(value, label);
  return placed(label, value, [&] { return context_.grid.nearest(x, moved); });
}

GridPosition SceneReader::position(const JsonValue& value, int dimension, const Label& label) const {
  expect(value, JsonValue::Kind::kArray, dimension == 2 ? "a point [x, y]" : "a point [x, y, z]", label);
  if (value.size() != static_cast<std::size_t>(dimension)) {
    fail(ErrorCode::kBadValue, fmt::format("a point needs {} coordinates, not {}", dimension, value.size()), label,
         value);
  }
  GridPosition result{};
  std::array<double, 3> moved{};
  for (std::size_t i = 0; i < value.size(); ++i) result[i] = coordinate(value.items()[i], moved[i], label);
  if (moved != std::array<double, 3>{}) context_.rounding.add(moved[0], std::hypot(moved[1], moved[2]));
  return result;
}

std::string suggestion(std::string_view wrong, const std::vector<std::string>& names) {
  std::string nearest = formula::nearest(wrong, names);
  return nearest.empty() ? "" : fmt::format(", did you mean '{}'?", nearest);
}

std::string choice(std::string_view what, std::string_view wrong, const std::vector<std::string>& names) {
  const std::string near = suggestion(wrong, names);
  if (!near.empty() || names.empty()) return near;
  return fmt::format("; the {} are {}", what, formula::listed(names));
}

}  // namespace findspace::io
