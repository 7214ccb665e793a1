// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Shapes that scenes state by coordinates.
#include <fmt/format.h>

#include <array>

#include "io/read/read_file.h"
#include "io/scene/scene_curves.h"
#include "io/scene/scene_shapes.h"
#include "io/scene/scene_space.h"
#include "io/text/file_kind.h"
#include "io/text/outline_shapes.h"
#include "io/text/read_cells.h"
#include "io/text/svg_path.h"
#include "plane/contour/contour.h"

namespace findspace::io {
namespace {

using exact::Real;
using plane::Contour;
using plane::GridPoint;
using plane::Shape;
using plane::ShapePtr;

Contour read_contour(ShapeReader& reader, const JsonValue& value, const Label& label) {
  reader.json().expect(value, JsonValue::Kind::kArray, "a list of points", label);
  Contour contour;
  contour.reserve(value.size());
  for (std::size_t i = 0; i < value.size(); ++i) {
    contour.push_back({.start = reader.json().point(value.items()[i], label.part("vertex", i))});
  }
  return contour;
}

/// A ring may repeat its first point at the end, as many formats write it.
Contour read_ring(ShapeReader& reader, const JsonValue& value, const Label& label) {
  Contour ring = read_contour(reader, value, label);
  if (ring.size() > 1 && ring.front().start == ring.back().start) ring.pop_back();
  return ring;
}

ShapePtr build_polygon(ShapeReader& reader, const JsonValue& object, const JsonValue& value, const Label& label) {
  reader.use_dimension(2, label, value);
  std::vector<Contour> rings{read_ring(reader, value, label)};
  if (const JsonValue* holes = object.find("holes")) {
    reader.json().expect(*holes, JsonValue::Kind::kArray, "\"holes\"", label);
    for (std::size_t i = 0; i < holes->size(); ++i) {
      rings.push_back(read_ring(reader, holes->items()[i], label.part("hole", i)));
    }
  }
  ReadContext& context = reader.context();
  plane::RingSet set =
      reader.json().placed(label, value, [&] { return plane::make_rings(std::move(rings), context.grid.step_size()); });
  context.repeated_points += set.repeated_points;
  context.reversed_rings += set.reversed_rings;
  Shape shape = reader.node(Shape::Kind::kRings, label, object);
  shape.contours = std::move(set.contours);
  return share(std::move(shape));
}

ShapePtr build_disc(ShapeReader& reader, const JsonValue& object, const JsonValue& value, const Label& label) {
  reader.use_dimension(2, label, value);
  const SceneReader& json = reader.json();
  static constexpr std::array<std::string_view, 2> kKeys{"center", "radius"};
  json.expect(value, JsonValue::Kind::kObject, "\"disc\"", label);
  json.check_keys(value, kKeys, label);
  Shape shape = reader.node(Shape::Kind::kDisc, label, object);
  shape.points = {json.point(json.need(value, "center", label), label.part("center"))};
  const JsonValue& radius = json.need(value, "radius", label);
  shape.amount = json.length(radius, label.part("radius"));
  if (shape.amount.sign() <= 0)
    json.fail(ErrorCode::kBadValue, "a radius must be more than 0", label.part("radius"), radius);
  return share(std::move(shape));
}

ShapePtr build_box(ShapeReader& reader, const JsonValue& object, const JsonValue& value, const Label& label) {
  const SceneReader& json = reader.json();
  static constexpr std::array<std::string_view, 2> kKeys{"min", "max"};
  json.expect(value, JsonValue::Kind::kObject, "\"box\"", label);
  json.check_keys(value, kKeys, label);
  const JsonValue& low = json.need(value, "min", label);
  if (low.is(JsonValue::Kind::kArray) && low.size() == 3) return build_space_box(reader, object, value, label);
  reader.use_dimension(2, label, value);
  GridPoint a = json.point(low, label.part("min"));
  GridPoint b = json.point(json.need(value, "max", label), label.part("max"));
  if (a.x >= b.x || a.y >= b.y) {
    json.fail(ErrorCode::kGeometry, "\"min\" of a box must be less than \"max\" in every coordinate", label, value);
  }
  Shape shape = reader.node(Shape::Kind::kRings, label, object);
  Contour& ring = shape.contours.emplace_back();
  ring.reserve(4);
  for (GridPoint p : {a, GridPoint{b.x, a.y}, b, GridPoint{a.x, b.y}}) ring.push_back({.start = p});
  return share(std::move(shape));
}

ShapePtr build_points(ShapeReader& reader, const JsonValue& object, const JsonValue& value, const Label& label) {
  reader.use_dimension(2, label, value);
  reader.json().expect(value, JsonValue::Kind::kArray, "\"points\"", label);
  if (value.size() == 0) reader.json().fail(ErrorCode::kGeometry, "\"points\" is an empty list", label, value);
  Shape shape = reader.node(Shape::Kind::kPoints, label, object);
  for (std::size_t i = 0; i < value.size(); ++i) {
    shape.points.push_back(reader.json().point(value.items()[i], label.part("point", i)));
  }
  return share(std::move(shape));
}

ShapePtr build_polyline(ShapeReader& reader, const JsonValue& object, const JsonValue& value, const Label& label) {
  reader.use_dimension(2, label, value);
  Contour chain = read_contour(reader, value, label);
  Shape shape = reader.node(Shape::Kind::kPolyline, label, object);
  shape.contours.push_back(reader.json().placed(
      label, value, [&] { return plane::make_chain(std::move(chain), reader.context().repeated_points); }));
  return share(std::move(shape));
}

/// Commands of a path in the scene's own coordinates.
class OutlineSink : public PathSink {
 public:
  explicit OutlineSink(Outline& outline) : outline_(outline) {}
  void move_to(const Real& x, const Real& y) override { outline_.move_to(x, y); }
  void line_to(const Real& x, const Real& y) override { outline_.line_to(x, y); }
  void arc_to(const Real& radius, bool large, bool sweep, const Real& x, const Real& y) override {
    outline_.arc_to(radius, large, sweep, x, y);
  }
  void curve_to(std::span<const plane::CurvePoint> points) override { outline_.curve_to(points); }
  void ellipse_to(const EllipseArc& arc, const Real& x, const Real& y) override { outline_.ellipse_to(arc, x, y); }
  void close() override { outline_.close(); }

 private:
  Outline& outline_;
};

ShapePtr build_path(ShapeReader& reader, const JsonValue& object, const JsonValue& value, const Label& label) {
  reader.use_dimension(2, label, value);
  const RulesBeside rules(reader, object, label);
  const std::string_view data = reader.json().text(value, "\"path\"", label);
  return reader.json().placed(label, value, [&] {
    Outline outline(reader.context());
    OutlineSink sink(outline);
    read_svg_path(data, sink);
    return shape_of(outline.take(), reader.context(), reader.json().place(label, value));
  });
}

FileChoice read_choice(ShapeReader& reader, const JsonValue& object, const Label& label) {
  const SceneReader& json = reader.json();
  FileChoice choice;
  if (const JsonValue* id = object.find("id")) choice.id = json.text(*id, "\"id\"", label);
  if (const JsonValue* layer = object.find("layer")) choice.layer = json.text(*layer, "\"layer\"", label);
  if (const JsonValue* index = object.find("index")) {
    auto n = json.number(*index, label).integer();
    if (!n || *n < 0 || *n > 1 << 30)
      json.fail(ErrorCode::kBadValue, "\"index\" is a whole number from 0", label, *index);
    choice.index = static_cast<std::size_t>(*n);
  }
  if (const JsonValue* floor = object.find("floor")) choice.floor = json.number(*floor, label.part("floor"));
  if (const JsonValue* unit = object.find("unit")) {
    const std::string_view name = json.text(*unit, "\"unit\"", label);
    choice.unit = json.placed(label, *unit, [&] { return parse_unit(name); });
  }
  return choice;
}

ShapePtr build_file(ShapeReader& reader, const JsonValue& object, const JsonValue& value, const Label& label) {
  const SceneReader& json = reader.json();
  std::filesystem::path path = json.context().folder / json.text(value, "\"file\"", label);
  const std::string ending = lower_ending(path.extension().string());
  if (is_plane_ending(ending)) reader.use_dimension(2, label, value);
  FileChoice choice = read_choice(reader, object, label);
  const RulesBeside rules(reader, object, label);
  if (is_space_ending(ending)) return build_space_file(reader, path, choice, value, label);
  return json.placed_file(label, value,
                          [&] { return read_shape_file(path, choice, json.context(), reader.stated_dimension()); });
}

ShapePtr build_cells(ShapeReader& reader, const JsonValue&, const JsonValue& value, const Label& label) {
  reader.use_dimension(2, label, value);
  return read_cells(reader.json(), value, label);
}

}  // namespace

std::span<const ShapeKind> primitive_kinds() {
  static const std::array<ShapeKind, 8> kinds{{{"polygon", {"holes"}, build_polygon},
                                               {"disc", {}, build_disc},
                                               {"box", {}, build_box},
                                               {"points", {}, build_points},
                                               {"polyline", {}, build_polyline},
                                               {"path", {"curves", "tolerance"}, build_path},
                                               {"cells", {}, build_cells},
                                               {"file",
                                                {"id", "layer", "index", "unit", "floor", "curves", "tolerance", "join",
                                                 "mend", "open_lines", "parts", "repair", "close_holes"},
                                                build_file}}};
  return kinds;
}

}  // namespace findspace::io
