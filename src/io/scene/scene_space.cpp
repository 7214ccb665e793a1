// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// 3D primitives: polytope, ball, prism, height field, mesh, and the box with three coordinates.
#include "io/scene/scene_space.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <string_view>
#include <system_error>

#include "io/cad/read_cad.h"
#include "io/mesh/read_height_grid.h"
#include "io/mesh/read_mesh.h"
#include "io/scene/scene_curves.h"
#include "io/scene/scene_shapes.h"
#include "io/text/file_kind.h"
#include "io/text/outline_shapes.h"
#include "plane/contour/contour.h"
#include "space/mesh/height_field.h"
#include "space/mesh/mesh.h"

namespace findspace::io {
namespace {

using plane::Shape;
using plane::ShapePtr;
using space::Solid;

ShapePtr share_solid(ShapeReader& reader, Solid solid, const Label& label, const JsonValue& at) {
  reader.use_dimension(3, label, at);
  solid.step = reader.context().grid.step_size();
  Shape shape = reader.node(Shape::Kind::kPoints, label, at);
  shape.solid = std::make_shared<const Solid>(std::move(solid));
  return share(std::move(shape));
}

space::Point point(const SceneReader& json, const JsonValue& value, const Label& label) {
  const GridPosition p = json.position(value, 3, label);
  return {p[0], p[1], p[2]};
}

std::vector<space::Point> points(const SceneReader& json, const JsonValue& value, const Label& label) {
  json.expect(value, JsonValue::Kind::kArray, "a list of points [x, y, z]", label);
  std::vector<space::Point> result;
  result.reserve(value.size());
  for (std::size_t i = 0; i < value.size(); ++i)
    result.push_back(point(json, value.items()[i], label.part("vertex", i)));
  return result;
}

ShapePtr build_polytope(ShapeReader& reader, const JsonValue& object, const JsonValue& value, const Label& label) {
  Solid solid;
  solid.mesh.vertices = points(reader.json(), value, label);
  return share_solid(reader, std::move(solid), label, object);
}

ShapePtr build_ball(ShapeReader& reader, const JsonValue& object, const JsonValue& value, const Label& label) {
  const SceneReader& json = reader.json();
  static constexpr std::array<std::string_view, 2> kKeys{"center", "radius"};
  json.expect(value, JsonValue::Kind::kObject, "\"ball\"", label);
  json.check_keys(value, kKeys, label);
  Solid solid;
  solid.form = Solid::Form::kBall;
  solid.mesh.vertices = {point(json, json.need(value, "center", label), label.part("center"))};
  const JsonValue& radius = json.need(value, "radius", label);
  solid.radius = json.length(radius, label.part("radius"));
  if (solid.radius.sign() <= 0)
    json.fail(ErrorCode::kBadValue, "a radius must be more than 0", label.part("radius"), radius);
  return share_solid(reader, std::move(solid), label, object);
}

plane::Contour ring(const SceneReader& json, const JsonValue& value, const Label& label) {
  json.expect(value, JsonValue::Kind::kArray, "a list of points [x, y]", label);
  plane::Contour contour;
  for (std::size_t i = 0; i < value.size(); ++i) {
    contour.push_back({.start = json.point(value.items()[i], label.part("vertex", i))});
  }
  if (contour.size() > 1 && contour.front().start == contour.back().start) contour.pop_back();
  return contour;
}

ShapePtr build_prism(ShapeReader& reader, const JsonValue& object, const JsonValue& value, const Label& label) {
  const SceneReader& json = reader.json();
  static constexpr std::array<std::string_view, 3> kKeys{"polygon", "holes", "z"};
  json.expect(value, JsonValue::Kind::kObject, "\"prism\"", label);
  json.check_keys(value, kKeys, label);
  std::vector<plane::Contour> rings{ring(json, json.need(value, "polygon", label), label.part("polygon"))};
  if (const JsonValue* holes = value.find("holes")) {
    json.expect(*holes, JsonValue::Kind::kArray, "\"holes\"", label);
    for (std::size_t i = 0; i < holes->size(); ++i)
      rings.push_back(ring(json, holes->items()[i], label.part("hole", i)));
  }
  const JsonValue& z = json.need(value, "z", label);
  json.expect(z, JsonValue::Kind::kArray, "\"z\"", label);
  if (z.size() != 2) json.fail(ErrorCode::kBadValue, "\"z\" is [low, high]", label, z);
  ReadContext& context = reader.context();
  plane::RingSet set =
      json.placed(label, value, [&] { return plane::make_rings(std::move(rings), context.grid.step_size()); });
  context.repeated_points += set.repeated_points;
  context.reversed_rings += set.reversed_rings;
  Solid solid;
  solid.form = Solid::Form::kPrism;
  solid.contours = std::move(set.contours);
  double moved[2] = {0, 0};
  solid.low = json.coordinate(z.items()[0], moved[0], label.part("z"));
  solid.high = json.coordinate(z.items()[1], moved[1], label.part("z"));
  for (const double m : moved) context.rounding.add(m, 0);
  if (solid.low >= solid.high) json.fail(ErrorCode::kGeometry, "the height of a prism must be more than 0", label, z);
  return share_solid(reader, std::move(solid), label, object);
}

std::array<exact::Real, 2> pair(const SceneReader& json, const JsonValue& value, const Label& label) {
  if (!value.is(JsonValue::Kind::kArray) || value.size() != 2)
    json.fail(ErrorCode::kBadValue, fmt::format("\"{}\" is [x, y]", label.what), label, value);
  return {json.number(value.items()[0], label), json.number(value.items()[1], label)};
}

ShapePtr build_height_field(ShapeReader& reader, const JsonValue& object, const JsonValue& value, const Label& label) {
  const SceneReader& json = reader.json();
  static constexpr std::array<std::string_view, 4> kKeys{"heights", "at", "step", "floor"};
  json.expect(value, JsonValue::Kind::kObject, "\"height_field\"", label);
  json.check_keys(value, kKeys, label);
  const JsonValue &heights = json.need(value, "heights", label), &floor = json.need(value, "floor", label);
  json.expect(heights, JsonValue::Kind::kArray, "\"heights\"", label);
  space::FieldFrame frame{0, heights.size(), {}, {}, json.number(floor, label.part("floor"))};
  if (const JsonValue* at = value.find("at")) frame.at = pair(json, *at, label.part("at"));
  frame.step = pair(json, json.need(value, "step", label), label.part("step"));
  for (std::size_t j = 0; j < heights.size(); ++j) {
    const JsonValue& row = heights.items()[j];
    json.expect(row, JsonValue::Kind::kArray, "a row of heights", label.part("row", j));
    if (j == 0) frame.columns = row.size();
    if (row.size() != frame.columns)
      json.fail(ErrorCode::kBadValue,
                fmt::format("a row of {} height{}, and the first has {}", row.size(), row.size() == 1 ? "" : "s",
                            frame.columns),
                label.part("row", j), row);
  }
  ReadContext& context = reader.context();
  context.work.charge(kHeightFieldSquare * frame.columns * frame.rows, "a height field of so many heights");
  return json.placed(label, value, [&] {
    space::HeightField field(frame, context.grid);
    for (std::size_t j = 0; j < frame.rows; ++j)
      for (std::size_t i = 0; i < frame.columns; ++i) {
        const JsonValue& height = heights.items()[j].items()[i];
        if (height.is(JsonValue::Kind::kNull)) continue;
        const Label row = label.part("row", j), here = row.part("column", i);
        double moved = 0;
        const std::int64_t z = json.coordinate(height, moved, here);
        json.placed(here, height, [&] { field.put(i, j, z, moved); });
      }
    return share_solid(reader, field.solid(context.rounding, context.notes), label, object);
  });
}

/// The usual case goes without exact numbers.
int vertex_index(const SceneReader& json, const JsonValue& value, std::size_t vertices, const Label& label) {
  const std::string_view text = value.is(JsonValue::Kind::kNumber) ? value.text() : std::string_view();
  int plain = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), plain);
  if (fault == std::errc() && end == text.data() + text.size() && plain >= 0 &&
      static_cast<std::size_t>(plain) < vertices)
    return plain;
  const auto index = json.number(value, label).integer();
  if (!index || *index < 0 || *index >= static_cast<exact::int128>(vertices)) {
    json.fail(ErrorCode::kBadValue,
              fmt::format("a face counts vertices from 0 to {}, not {}", vertices - 1, value.text()), label, value);
  }
  return static_cast<int>(*index);
}

std::vector<int> face(const SceneReader& json, const JsonValue& value, std::size_t vertices, const Label& label) {
  json.expect(value, JsonValue::Kind::kArray, "a face", label);
  std::vector<int> circuit;
  circuit.reserve(value.size());
  for (const JsonValue& item : value.items()) circuit.push_back(vertex_index(json, item, vertices, label));
  return circuit;
}

ShapePtr build_mesh(ShapeReader& reader, const JsonValue& object, const JsonValue& value, const Label& label) {
  const SceneReader& json = reader.json();
  static constexpr std::array<std::string_view, 2> kKeys{"vertices", "faces"};
  json.expect(value, JsonValue::Kind::kObject, "\"mesh\"", label);
  json.check_keys(value, kKeys, label);
  const RulesBeside rules(reader, object, label);
  Solid solid;
  solid.form = Solid::Form::kMesh;
  solid.mesh.vertices = points(json, json.need(value, "vertices", label), label.part("vertices"));
  const JsonValue& faces = json.need(value, "faces", label);
  json.expect(faces, JsonValue::Kind::kArray, "\"faces\"", label);
  solid.mesh.faces.reserve(faces.size());
  for (std::size_t i = 0; i < faces.size(); ++i) {
    solid.mesh.faces.push_back(face(json, faces.items()[i], solid.mesh.vertices.size(), label.part("face", i)));
  }
  json.placed(label, value, [&] {
    for (std::string& note :
         space::clean(solid.mesh, reader.context().grid.step_size(), reader.context().drawing.repair))
      reader.context().notes.push_back(label.text() + ": " + note);
  });
  return share_solid(reader, std::move(solid), label, object);
}

}  // namespace

std::span<const ShapeKind> space_kinds() {
  static const std::array<ShapeKind, 5> kinds{{{"polytope", {}, build_polytope},
                                               {"ball", {}, build_ball},
                                               {"prism", {}, build_prism},
                                               {"height_field", {}, build_height_field},
                                               {"mesh", {"repair", "close_holes"}, build_mesh}}};
  return kinds;
}

plane::ShapePtr build_space_box(ShapeReader& reader, const JsonValue& object, const JsonValue& value,
                                const Label& label) {
  const SceneReader& json = reader.json();
  const space::Point a = point(json, json.need(value, "min", label), label.part("min"));
  const space::Point b = point(json, json.need(value, "max", label), label.part("max"));
  if (a.x >= b.x || a.y >= b.y || a.z >= b.z) {
    json.fail(ErrorCode::kGeometry, "\"min\" of a box must be less than \"max\" in every coordinate", label, value);
  }
  Solid solid;
  for (int i = 0; i < 8; ++i) solid.mesh.vertices.push_back({i & 1 ? b.x : a.x, i & 2 ? b.y : a.y, i & 4 ? b.z : a.z});
  return share_solid(reader, std::move(solid), label, object);
}

namespace {

ShapePtr part_shape(ShapeReader& reader, CadPart part, const Label& label, const JsonValue& at) {
  if (part.balls.empty()) return share_solid(reader, std::move(part.solid), label, at);
  std::vector<ShapePtr> balls;
  for (Solid& ball : part.balls) balls.push_back(share_solid(reader, std::move(ball), label, at));
  if (balls.size() == 1) return balls[0];
  Shape hull = reader.node(Shape::Kind::kHull, label, at);
  hull.children = std::move(balls);
  return share(std::move(hull));
}

/// The solids of a CAD file that are chosen: one, or a collection.
ShapePtr cad_shape(ShapeReader& reader, const std::filesystem::path& path, const FileChoice& choice,
                   const JsonValue& at, const Label& label) {
  ReadContext& context = reader.context();
  const std::string name = path.string();
  std::vector<CadPart> parts = reader.json().placed_file(label, at, [&] {
    refuse_choice(choice.layer.has_value(), "layer", "a CAD file", name);
    refuse_choice(choice.floor.has_value(), "floor", "a CAD file", name);
    refuse_choice(choice.unit.has_value(), "unit", "a CAD file, which states its own", name);
    const std::string ending = lower_ending(path.extension().string());
    const std::string bytes = context.take_file(path);
    require_kind(bytes, ending, name);
    const exact::Real scale = file_scale(exact::Real(1), name, choice, context);
    try {
      return read_cad(bytes, ending, context, scale, {.id = choice.id, .index = choice.index});
    } catch (const Error& e) {
      throw e.within(name);
    }
  });
  std::vector<ShapePtr> shapes;
  for (CadPart& part : parts) shapes.push_back(part_shape(reader, std::move(part), label, at));
  return united(std::move(shapes), reader.json().place(label, at), true);
}

Solid height_grid(const std::filesystem::path& path, const FileChoice& choice, ReadContext& context) {
  const std::string name = path.string(), bytes = context.take_file(path);
  require_kind(bytes, std::string(kHeightGridEnding), name);
  if (!choice.floor)
    throw Error(ErrorCode::kBadValue, "a grid of heights needs a \"floor\" beside it (of convert, --floor)", name);
  const exact::Real scale = file_scale(std::nullopt, name, choice, context);
  try {
    return read_height_grid(bytes, scale, *choice.floor, context);
  } catch (const Error& e) {
    throw e.within(name);
  }
}

}  // namespace

plane::ShapePtr build_space_file(ShapeReader& reader, const std::filesystem::path& path, const FileChoice& choice,
                                 const JsonValue& at, const Label& label) {
  const std::string ending = lower_ending(path.extension().string()), name = path.string();
  ReadContext& context = reader.context();
  if (is_cad_ending(ending)) return cad_shape(reader, path, choice, at, label);
  Solid solid = reader.json().placed_file(label, at, [&] {
    refuse_choice(choice.id.has_value(), "id", "a mesh", name);
    refuse_choice(choice.layer.has_value(), "layer", "a mesh", name);
    refuse_choice(choice.index.has_value(), "index", "a mesh", name);
    if (ending == kHeightGridEnding) return height_grid(path, choice, context);
    refuse_choice(choice.floor.has_value(), "floor", "a mesh", name);
    Solid read;
    read.form = Solid::Form::kMesh;
    read.mesh = read_mesh(path, context,
                          [&](const auto& millimetres) { return file_scale(millimetres, name, choice, context); });
    return read;
  });
  return share_solid(reader, std::move(solid), label, at);
}

}  // namespace findspace::io
