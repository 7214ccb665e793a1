// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "io/scene/scene_placement.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "io/scene/scene_rotation.h"

namespace findspace::io {
namespace {

using exact::Real;
using Kind = JsonValue::Kind;

constexpr exact::int128 kMostCopies = 10000;

std::vector<FormulaText> read_formula_list(const JsonValue* value, const SceneReader& json, const Label& label) {
  std::vector<FormulaText> all;
  if (!value) return all;
  if (value->is(Kind::kString)) return {json.formula(*value, label)};
  json.expect(*value, Kind::kArray, fmt::format("\"{}\"", label.what), label);
  for (const JsonValue& item : value->items()) all.push_back(json.formula(item, label));
  return all;
}

PlacedBody read_body(const JsonValue& value, ShapeReader& shapes, std::vector<std::string>& known, const Label& label) {
  const SceneReader& json = shapes.json();
  PlacedBody body;
  body.shapes = json.texts(value, "a placed shape", label);
  for (std::size_t i = 0; i < body.shapes.size(); ++i) {
    const std::string& name = body.shapes[i];
    const JsonValue& at = value.is(Kind::kArray) ? value.items()[i] : value;
    shapes.named(name, at, label);
    if (std::find(known.begin(), known.end(), name) != known.end())
      json.fail(ErrorCode::kBadValue, fmt::format("'{}' stands here twice; several of a shape are a \"count\"", name),
                label, at);
    known.push_back(name);
  }
  body.name = fmt::format("{}", fmt::join(body.shapes, "+"));
  return body;
}

void read_bodies(const JsonValue& value, ShapeReader& shapes, Placement& place, const Label& label) {
  const SceneReader& json = shapes.json();
  std::vector<std::string> known;
  if (value.is(Kind::kString)) {
    place.bodies.push_back(read_body(value, shapes, known, label));
    return;
  }
  json.expect(value, Kind::kArray, "\"shapes\"", label);
  for (const JsonValue& item : value.items()) place.bodies.push_back(read_body(item, shapes, known, label));
  if (place.bodies.empty()) json.fail(ErrorCode::kBadValue, "\"shapes\" is an empty list", label, value);
}

/// A value for all bodies, or an object with one for each body it names.
template <class Read>
void for_bodies(const JsonValue* value, Placement& place, const SceneReader& json, const Label& label, Read read) {
  if (!value) return;
  if (!value->is(Kind::kObject)) {
    for (PlacedBody& body : place.bodies) read(body, *value, label);
    return;
  }
  std::vector<std::string> names;
  for (const PlacedBody& body : place.bodies) names.push_back(body.name);
  for (std::size_t i = 0; i < value->size(); ++i) {
    const std::string_view name = value->keys()[i];
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) {
      json.fail(ErrorCode::kUnknownName,
                fmt::format("'{}' is not among the placed shapes{}", name, choice("placed ones", name, names)), label,
                value->items()[i]);
    }
    read(place.bodies[std::size_t(found - names.begin())], value->items()[i], label.part(name));
  }
}

void add_angle(PlacedBody& body, Real angle) {
  angle = angle - Real(360) * Real(exact::floor(angle / Real(360)));
  const auto same = [&](const planning::Orientation& t) { return !t.rotation && t.degrees == angle; };
  if (std::none_of(body.angles.begin(), body.angles.end(), same)) body.angles.emplace_back(std::move(angle));
}

void add_orientation(PlacedBody& body, const JsonValue& value, const SceneReader& json, const Label& label) {
  Orientation o = read_orientation(value, nullptr, {}, json, label);
  const auto same = [&](const planning::Orientation& t) { return t.rotation && t.rotation->rows == o.rotation.rows; };
  if (std::none_of(body.angles.begin(), body.angles.end(), same))
    body.angles.emplace_back(std::move(o.rotation), std::move(o.text));
}

/// Degrees; in space orientations too.
void read_body_angles(PlacedBody& body, const JsonValue& value, int dimension, const SceneReader& json,
                      const Label& label) {
  json.expect(value, Kind::kArray, "a list of angles", label);
  body.angles.clear();
  for (std::size_t i = 0; i < value.size(); ++i) {
    const Label part = label.part("angle", i);
    if (dimension == 3 && value.items()[i].is(Kind::kObject))
      add_orientation(body, value.items()[i], json, part);
    else
      add_angle(body, json.number(value.items()[i], part));
  }
  if (body.angles.empty()) json.fail(ErrorCode::kBadValue, "an empty list of angles: nothing is allowed", label, value);
}

void read_count(PlacedBody& body, const JsonValue& value, const SceneReader& json, const Label& label) {
  const auto count = json.number(value, label).integer();
  if (!count || *count < 1 || *count > kMostCopies)
    json.fail(ErrorCode::kBadValue, fmt::format("a count is a whole number from 1 to {}", int(kMostCopies)), label,
              value);
  body.count = int(*count);
}

Placement::Method read_method(const JsonValue* value, const SceneReader& json, const Label& label) {
  if (!value) return Placement::Method::kSequential;
  const std::string_view word = json.text(*value, "\"method\"", label);
  if (word == "simultaneous") return Placement::Method::kSimultaneous;
  if (word == "sequential") return Placement::Method::kSequential;
  json.fail(ErrorCode::kUnknownName, fmt::format("\"method\" is sequential or simultaneous, not '{}'", word), label,
            *value);
}

}  // namespace

Placement read_placement(const JsonValue& value, ShapeReader& shapes) {
  const SceneReader& json = shapes.json();
  Label label{nullptr, "place"};
  static constexpr std::array<std::string_view, 8> kKeys{"shapes",   "each",   "pairs",  "constraints",
                                                         "minimize", "method", "angles", "count"};
  json.expect(value, Kind::kObject, "\"place\"", label);
  json.check_keys(value, kKeys, label);
  Placement place;
  read_bodies(json.need(value, "shapes", label), shapes, place, label.part("shapes"));
  for_bodies(
      value.find("angles"), place, json, label.part("angles"),
      [&](PlacedBody& b, const JsonValue& v, const Label& l) { read_body_angles(b, v, shapes.dimension(), json, l); });
  for_bodies(value.find("count"), place, json, label.part("count"),
             [&](PlacedBody& b, const JsonValue& v, const Label& l) { read_count(b, v, json, l); });
  if (const JsonValue* each = value.find("each")) place.each = json.formula(*each, label.part("each"));
  if (const JsonValue* pairs = value.find("pairs")) place.pairs = json.formula(*pairs, label.part("pairs"));
  place.constraints = read_formula_list(value.find("constraints"), json, label.part("constraints"));
  place.minimize = read_formula_list(value.find("minimize"), json, label.part("minimize"));
  for (const char* word : {"self", "other"}) {
    const std::vector<std::string>& names = shapes.names();
    if (std::find(names.begin(), names.end(), word) == names.end()) continue;
    json.fail(ErrorCode::kBadValue, fmt::format("with \"place\" no shape may be called '{}'", word), label, value);
  }
  place.method = read_method(value.find("method"), json, label.part("method"));
  return place;
}

}  // namespace findspace::io
