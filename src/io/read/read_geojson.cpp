// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// GeoJSON (RFC 7946): geometries, features and collections of them. Coordinates are read as plane coordinates; a third
// one is refused. `id` chooses by a feature's "id" or its property "id" or "name", `index` by position.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "findspace/error.h"
#include "io/read/read_file.h"
#include "io/text/json_tree.h"
#include "io/text/outline_shapes.h"
#include "io/text/scene_reader.h"

namespace findspace::io {
namespace {

using exact::Real;
using plane::Shape;
using plane::ShapePtr;
using Kind = JsonValue::Kind;

constexpr const char* kTypes =
    "Point, MultiPoint, LineString, MultiLineString, Polygon, MultiPolygon, GeometryCollection, Feature and "
    "FeatureCollection";

/// Those that have coordinates.
constexpr std::array<std::string_view, 6> kGeometries{"Point",           "MultiPoint", "LineString",
                                                      "MultiLineString", "Polygon",    "MultiPolygon"};

class GeoJsonReader {
 public:
  GeoJsonReader(const std::string& name, const FileChoice& choice, ReadContext& context, Real scale)
      : json_(name, context), choice_(choice), context_(context), scale_(std::move(scale)) {}

  std::vector<ShapePtr> read(const JsonValue& root) {
    object(root, "");
    if (unlocated_ > 0)
      context_.notes.push_back(fmt::format("{}: {} {} no geometry, left out", json_.file(), unlocated_,
                                           unlocated_ == 1 ? "feature has" : "features have"));
    if (parts_.empty() && choice_.id) {
      throw Error(ErrorCode::kUnknownName,
                  fmt::format("there is no feature '{}'{}", *choice_.id, choice("features", *choice_.id, ids_)),
                  json_.file());
    }
    if (!nests(choice_, context_) || outlines_ < 2) return std::move(parts_);
    context_.repeated_points = repeated_;  // they are met again
    return closed_parts(std::move(pool_), context_, json_.file());
  }

 private:
  std::string place(const JsonValue& at) const { return json_.place({}, at); }

  std::string_view type(const JsonValue& value) const {
    json_.expect(value, Kind::kObject, "a GeoJSON object", {});
    return json_.text(json_.need(value, "type", {}), "\"type\"", {});
  }

  std::span<const JsonValue> list(const JsonValue& value, const char* what) const {
    json_.expect(value, Kind::kArray, what, {});
    if (value.size() == 0) json_.fail(ErrorCode::kGeometry, fmt::format("{} is empty", what), {}, value);
    return value.items();
  }

  void object(const JsonValue& value, const std::string& id) {
    const std::string_view kind = type(value);
    if (kind == "FeatureCollection") {
      for (const JsonValue& one : list(json_.need(value, "features", {}), "\"features\"")) object(one, "");
    } else if (kind == "Feature") {
      feature(value);
    } else if (!choice_.id || *choice_.id == id) {
      feature_ = id;
      Shape shape = *geometry(value);
      shape.name = id;
      parts_.push_back(std::make_shared<const Shape>(std::move(shape)));
    }
  }

  void feature(const JsonValue& value) {
    const JsonValue& drawn = json_.need(value, "geometry", {});
    const std::string own = feature_id(value);
    if (drawn.is(Kind::kNull)) {
      unlocated_ += !choice_.id || *choice_.id == own ? 1 : 0;
      return;
    }
    if (!own.empty()) ids_.push_back(own);
    object(drawn, own);
  }

  static std::string feature_id(const JsonValue& feature) {
    const JsonValue* properties = feature.find("properties");
    std::vector<const JsonValue*> candidates{feature.find("id")};
    if (properties && properties->is(Kind::kObject)) {
      candidates.push_back(properties->find("id"));
      candidates.push_back(properties->find("name"));
    }
    for (const JsonValue* id : candidates) {
      if (id && !id->text().empty()) return std::string(id->text());
    }
    return {};
  }

  ShapePtr geometry(const JsonValue& value) {
    const std::string_view kind = type(value);
    if (kind == "GeometryCollection") {
      std::vector<ShapePtr> parts;
      for (const JsonValue& item : list(json_.need(value, "geometries", {}), "\"geometries\""))
        parts.push_back(geometry(item));
      return united(std::move(parts), place(value));
    }
    if (std::find(kGeometries.begin(), kGeometries.end(), kind) == kGeometries.end())
      json_.fail(ErrorCode::kUnknownName, fmt::format("'{}' is not a type of GeoJSON; the types are {}", kind, kTypes),
                 {}, value);
    const JsonValue& coordinates = json_.need(value, "coordinates", {});
    if (kind == "Polygon") return polygon(coordinates);
    if (kind == "MultiPolygon") {
      std::vector<ShapePtr> parts;
      for (const JsonValue& item : list(coordinates, "\"coordinates\"")) parts.push_back(polygon(item));
      return united(std::move(parts), place(value));
    }
    Outline outline(context_, scale_);
    outline.set_name(feature_);
    if (kind == "Point") {
      point(coordinates, outline);
    } else if (kind == "MultiPoint") {
      for (const JsonValue& item : list(coordinates, "\"coordinates\"")) point(item, outline);
    } else if (kind == "LineString") {
      line(coordinates, outline);
    } else {
      for (const JsonValue& item : list(coordinates, "\"coordinates\"")) line(item, outline);
    }
    pool(outline.drawn());
    return json_.placed({}, value, [&] { return lines_of(outline.take(), context_, place(value)); });
  }

  void pool(const Drawing& drawing) {
    ++outlines_;
    append(pool_, drawing);
  }

  template <class Take>
  void position(const JsonValue& value, Take take) const {
    json_.expect(value, Kind::kArray, "a position", {});
    if (value.size() != 2) json_.fail(ErrorCode::kUnsupported, "a position that is not [x, y]", {}, value);
    Real x = json_.number(value.items()[0], {}), y = json_.number(value.items()[1], {});
    json_.placed({}, value, [&] { take(x, y); });
  }

  void point(const JsonValue& value, Outline& outline) const {
    position(value, [&](const Real& x, const Real& y) { outline.point(x, y); });
  }

  void line(const JsonValue& value, Outline& outline) const {
    bool first = true;
    for (const JsonValue& item : list(value, "a line")) {
      position(item, [&](const Real& x, const Real& y) { first ? outline.move_to(x, y) : outline.line_to(x, y); });
      first = false;
    }
    outline.finish();
  }

  ShapePtr polygon(const JsonValue& value) {
    Outline outline(context_, scale_);
    outline.set_name(feature_);
    for (const JsonValue& ring : list(value, "a polygon")) {
      const std::size_t before = outline.drawn().chains.size();
      line(ring, outline);
      const std::vector<Chain>& rings = outline.drawn().chains;
      if (rings.size() == before + 1 && rings.back().closed) continue;
      json_.fail(ErrorCode::kGeometry, "a ring must have an area and end at its first point", {}, ring);
    }
    pool(outline.drawn());
    return json_.placed({}, value, [&] { return polygon_of(outline.take(), context_, place(value)); });
  }

  SceneReader json_;
  const FileChoice& choice_;
  ReadContext& context_;
  Real scale_;
  Drawing pool_;         // the outlines of all geometries
  std::string feature_;  // that is read
  int outlines_ = 0, unlocated_ = 0;
  std::int64_t repeated_ = context_.repeated_points;  // before
  std::vector<ShapePtr> parts_;
  std::vector<std::string> ids_;
};

}  // namespace

ShapePtr read_geojson(std::string_view text, const std::string& name, const FileChoice& choice, ReadContext& context) {
  refuse_choice(choice.layer.has_value(), "layer", "GeoJSON", name);
  const JsonTree tree = parse_json(text, name, context.work);
  Real scale = file_scale(std::nullopt, name, choice, context);
  return chosen(GeoJsonReader(name, choice, context, scale).read(tree.root()), name, choice);
}

}  // namespace findspace::io
