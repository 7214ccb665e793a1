// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Constructive nodes: shapes made from shapes. The trees keep them as they are; nothing is computed here.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "io/scene/mirror_tree.h"
#include "io/scene/scene_rotation.h"
#include "io/scene/scene_shapes.h"
#include "space/shape/rotated_shape.h"

namespace findspace::io {
namespace {

using plane::Shape;
using plane::ShapePtr;

constexpr std::size_t kAny = ~std::size_t{0};

template <Shape::Kind kind, std::size_t least, std::size_t most>
ShapePtr build_several(ShapeReader& reader, const JsonValue& object, const JsonValue& value, const Label& label) {
  const SceneReader& json = reader.json();
  json.expect(value, JsonValue::Kind::kArray, fmt::format("\"{}\"", object.keys()[0]), label);
  if (value.size() < least || value.size() > most) {
    std::string many = least == most ? fmt::format("exactly {}", least) : fmt::format("at least {}", least);
    json.fail(
        ErrorCode::kBadValue,
        fmt::format("\"{}\" needs {} shape{}, not {}", object.keys()[0], many, least == 1 ? "" : "s", value.size()),
        label, value);
  }
  Shape shape = reader.node(kind, label, object);
  shape.children.reserve(value.size());
  for (std::size_t i = 0; i < value.size(); ++i) {
    shape.children.push_back(reader.shape(value.items()[i], label.part("operand", i)));
  }
  if constexpr (kind == Shape::Kind::kMinkowskiSum || kind == Shape::Kind::kMinkowskiDifference)
    reader.json().placed(label, value, [&] { reader.charge_pairs(shape); });
  return share(std::move(shape));
}

template <Shape::Kind kind>
ShapePtr build_one(ShapeReader& reader, const JsonValue& object, const JsonValue& value, const Label& label) {
  Shape shape = reader.node(kind, label, object);
  shape.children = {reader.shape(value, label.part("operand"))};
  return share(std::move(shape));
}

ShapePtr operand(ShapeReader& reader, const JsonValue& object, const Label& label) {
  return reader.shape(reader.json().need(object, "of", label), label.part("of"));
}

ShapePtr build_translate(ShapeReader& reader, const JsonValue& object, const JsonValue& value, const Label& label) {
  Shape shape = reader.node(Shape::Kind::kTranslate, label, object);
  shape.children = {operand(reader, object, label)};
  GridPosition shift = reader.json().position(value, reader.dimension(), label.part("translate"));
  shape.points = {{shift[0], shift[1]}};
  shape.lift = shift[2];
  return share(std::move(shape));
}

/// In 3D the rotated tree itself.
ShapePtr rotated_solid(ShapeReader& reader, const JsonValue& object, const Shape& child, const JsonValue& value,
                       const Label& label) {
  const SceneReader& json = reader.json();
  const JsonValue* about = object.find("about");
  const GridPosition center = about ? json.position(*about, 3, label.part("about")) : GridPosition{};
  const Orientation orientation = read_orientation(value, object.find("axis"), center, json, label.part("rotate"));
  return json.placed(label, object, [&] {
    reader.charge_rotated(child);
    plane::Rounding rounding;
    Shape rotated = *space::rotated(child, orientation.rotation, rounding);
    reader.note_rotated(rotated);
    rotated.name.clear();
    rotated.place = json.place(label, object);
    if (rounding.points > 0) {
      reader.context().notes.push_back(fmt::format("{}: {} rotated points were put on the grid, moved by at most {}",
                                                   label.text(), rounding.points,
                                                   reader.context().length_text(rounding.largest)));
    }
    return share(std::move(rotated));
  });
}

ShapePtr build_rotate(ShapeReader& reader, const JsonValue& object, const JsonValue& value, const Label& label) {
  Shape shape = reader.node(Shape::Kind::kRotate, label, object);
  shape.children = {operand(reader, object, label)};
  if (reader.dimension() == 3) return rotated_solid(reader, object, *shape.children[0], value, label);
  if (value.is(JsonValue::Kind::kObject))
    reader.json().fail(ErrorCode::kBadValue, "an orientation is for 3D shapes; in the plane \"rotate\" is degrees",
                       label, value);
  shape.degrees = reader.json().number(value, label.part("rotate"));
  if (const JsonValue* axis = object.find("axis"))
    reader.json().fail(ErrorCode::kBadValue, "\"axis\" is for 3D shapes", label, *axis);
  const JsonValue* about = object.find("about");
  shape.points = {about ? reader.json().point(*about, label.part("about")) : plane::GridPoint{}};
  return share(std::move(shape));
}

ShapePtr build_offset(ShapeReader& reader, const JsonValue& object, const JsonValue& value, const Label& label) {
  Shape shape = reader.node(Shape::Kind::kOffset, label, object);
  shape.children = {operand(reader, object, label)};
  shape.amount = reader.json().length(value, label.part("offset"));
  return share(std::move(shape));
}

ShapePtr over_one(ShapeReader& reader, Shape::Kind kind, ShapePtr child, plane::GridPoint point,
                  const JsonValue& object, const Label& label) {
  Shape shape = reader.node(kind, label, object);
  shape.children = {std::move(child)};
  shape.points = {point};
  return share(std::move(shape));
}

/// About an axis through `about`, `mirror` degrees from the x axis; of a shape alone, through the origin.
ShapePtr build_mirror(ShapeReader& reader, const JsonValue& object, const JsonValue& value, const Label& label) {
  const SceneReader& json = reader.json();
  if (!value.is(JsonValue::Kind::kNumber)) {
    if (object.find("about") != nullptr || object.find("of") != nullptr)
      json.fail(ErrorCode::kBadValue, "\"about\" and \"of\" go with \"mirror\" in degrees, not with a shape", label,
                value);
    const std::string note = "\"mirror\" of a shape alone is its reflection through the origin: \"point_reflection\"";
    std::vector<std::string>& notes = reader.context().notes;
    if (std::find(notes.begin(), notes.end(), note) == notes.end()) notes.push_back(note);
    return build_one<Shape::Kind::kMirror>(reader, object, value, label);
  }
  const exact::Real degrees = json.number(value, label.part("mirror"));
  const JsonValue* about = object.find("about");
  const plane::GridPoint q = about ? json.point(*about, label.part("about")) : plane::GridPoint{};
  ShapePtr shape = operand(reader, object, label);
  const bool moved = q != plane::GridPoint{};
  if (moved) shape = over_one(reader, Shape::Kind::kTranslate, shape, {-q.x, -q.y}, object, label);
  shape = json.placed(label, value, [&] { return mirrored_in_x_axis(shape); });
  if (degrees.sign() != 0) {
    Shape rotated = *over_one(reader, Shape::Kind::kRotate, shape, {}, object, label);
    rotated.degrees = degrees + degrees;
    shape = share(std::move(rotated));
  }
  return moved ? over_one(reader, Shape::Kind::kTranslate, shape, q, object, label) : shape;
}

}  // namespace

std::span<const ShapeKind> node_kinds() {
  using Kind = Shape::Kind;
  static const std::array<ShapeKind, 16> kinds{
      {{"union", {}, build_several<Kind::kUnion, 1, kAny>},
       {"intersection", {}, build_several<Kind::kIntersection, 1, kAny>},
       {"difference", {}, build_several<Kind::kDifference, 2, kAny>},
       {"complement", {}, build_one<Kind::kComplement>},
       {"interior", {}, build_one<Kind::kInterior>},
       {"closure", {}, build_one<Kind::kClosure>},
       {"boundary", {}, build_one<Kind::kBoundary>},
       {"regularize", {}, build_one<Kind::kRegularize>},
       {"translate", {"of"}, build_translate},
       {"rotate", {"about", "axis", "of"}, build_rotate},
       {"mirror", {"about", "of"}, build_mirror},
       {"point_reflection", {}, build_one<Kind::kMirror>},
       {"minkowski_sum", {}, build_several<Kind::kMinkowskiSum, 2, 2>},
       {"minkowski_difference", {}, build_several<Kind::kMinkowskiDifference, 2, 2>},
       {"offset", {"of"}, build_offset},
       {"hull", {}, build_one<Kind::kHull>}}};
  return kinds;
}

}  // namespace findspace::io
