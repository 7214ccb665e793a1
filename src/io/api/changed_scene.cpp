// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "io/api/changed_scene.h"

#include <findspace/error.h>
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "space/shape/rotated_shape.h"

namespace findspace {
namespace {

/// As the program takes it: errors are kSyntax, but kBadValue for what is no rotation.
space::Rotation rotation_of(std::string_view text) {
  const auto decimals = [](std::string_view list) {
    std::vector<exact::Real> out;
    for (std::size_t at = 0; at <= list.size();) {
      const std::size_t end = std::min(list.find(',', at), list.size());
      out.push_back(exact::Real::parse_decimal(list.substr(at, end - at)));
      at = end + 1;
    }
    return out;
  };
  const auto refuse = [] { throw Error(ErrorCode::kSyntax, "too few or too many numbers"); };
  const space::Point origin{};
  if (const std::size_t colon = text.find(':'); colon != std::string_view::npos) {
    const std::string_view axis = text.substr(0, colon);
    const std::size_t letter = axis.size() == 1 ? std::string_view("xyz").find(axis) : std::string_view::npos;
    space::RealVector direction;
    if (letter != std::string_view::npos) {
      direction[letter] = exact::Real(1);
    } else {
      const std::vector<exact::Real> numbers = decimals(axis);
      if (numbers.size() != 3) refuse();
      std::copy(numbers.begin(), numbers.end(), direction.begin());
    }
    return space::Rotation::about_direction(direction, exact::Real::parse_decimal(text.substr(colon + 1)), origin);
  }
  const std::vector<exact::Real> n = decimals(text);
  if (n.size() == 4) return space::Rotation::of_quaternion({n[0], n[1], n[2], n[3]}, origin);
  if (n.size() != 9) refuse();
  return space::Rotation::of_matrix({space::RealVector{n[0], n[1], n[2]}, {n[3], n[4], n[5]}, {n[6], n[7], n[8]}},
                                    origin);
}

}  // namespace

Rotation Rotation::read(std::string_view text) {
  return Rotation(std::make_shared<const Data>(Data{std::string(text), rotation_of(text)}));
}
const std::string& Rotation::text() const { return data_->text; }
std::array<std::array<double, 3>, 3> Rotation::matrix() const {
  std::array<std::array<double, 3>, 3> out{};
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t k = 0; k < 3; ++k) out[r][k] = data_->rotation.rows[r][k].to_double();
  return out;
}
bool Rotation::exact() const { return !data_->rotation.rounded; }

namespace io {
namespace {

/// The construction that turns a shape.
plane::ShapePtr turned(const plane::ShapePtr& shape, const plane::GridPoint& about, const exact::Real& degrees) {
  auto out = std::make_shared<plane::Shape>();
  if (shape->collection) {  // its parts keep their names
    *out = *shape;
    for (plane::ShapePtr& part : out->children) part = turned(part, about, degrees);
    return out;
  }
  out->kind = plane::Shape::Kind::kRotate;
  out->name = shape->name;
  out->place = shape->place;
  out->children = {shape};
  out->points = {about};
  out->degrees = degrees;
  return out;
}

/// The scene over positions, or over angles or instants at one.
void range_over(Scene& scene, findspace::Scene::Free::Kind kind) {
  using Kind = findspace::Scene::Free::Kind;
  if (int(scene.free.kind) == int(kind)) return;
  if (kind == Kind::kLine || kind == Kind::kPose)
    throw Error(ErrorCode::kBadValue, "a line and poses are said by \"free\" of the scene", scene.file);
  if (kind == Kind::kTime && !scene.motion.given())
    throw Error(ErrorCode::kBadValue, "the scene has no \"motion\"", scene.file);
  scene.free.kind = Free::Kind(kind);
}

}  // namespace

Scene rotated_scene(Scene scene, const Rotation::Data& given) {
  if (scene.dimension != 3)
    throw Error(ErrorCode::kUnsupported, "orientations are for 3D scenes; in the plane an angle says all", scene.file);
  space::Rotation rotation = given.rotation;
  if (!given.whole) {
    const GridPosition& c = scene.free.about;
    const space::RealVector about{exact::Real(c[0]), exact::Real(c[1]), exact::Real(c[2])};
    const space::RealVector moved = rotation.linear(about);
    for (std::size_t k = 0; k < 3; ++k) rotation.by[k] = about[k] - moved[k];
  }
  scene.free.kind = Free::Kind::kPosition;
  plane::Rounding rounding;
  for (plane::ShapePtr& shape : scene.shapes) {
    if (std::find(scene.moving.begin(), scene.moving.end(), shape->name) == scene.moving.end()) continue;
    plane::Shape turned = *space::rotated(*shape, rotation, rounding);
    turned.name = shape->name;
    shape = std::make_shared<const plane::Shape>(std::move(turned));
  }
  if (rounding.points > 0)
    scene.notes.push_back(fmt::format("{} points were put on the grid, moved by at most {:.2g}{}{}", rounding.points,
                                      rounding.largest * scene.grid.step_size(), scene.unit ? " " : "",
                                      scene.unit ? formula::name(*scene.unit) : ""));
  return scene;
}

Scene turned_scene(Scene scene, const exact::Real& degrees) {
  if (scene.dimension == 3)
    throw Error(ErrorCode::kUnsupported, "in space an orientation says how a shape is turned", scene.file);
  if (scene.motion.given())
    throw Error(ErrorCode::kUnsupported, "an angle in a scene with \"motion\" is not computed", scene.file);
  const plane::GridPoint about{scene.free.about[0], scene.free.about[1]};
  if (scene.free.kind != Free::Kind::kLine) scene.free.kind = Free::Kind::kPosition;
  if (degrees.sign() == 0) return scene;
  for (plane::ShapePtr& shape : scene.shapes)
    if (std::find(scene.moving.begin(), scene.moving.end(), shape->name) != scene.moving.end())
      shape = turned(shape, about, degrees);
  return scene;
}

Scene asking_scene(Scene scene, const findspace::Scene::Question& question) {
  if (question.minimize && question.maximize && !question.minimize->empty() && !question.maximize->empty())
    throw Error(ErrorCode::kBadValue, "\"minimize\" and \"maximize\": one objective is meant");
  if (question.where) {
    scene.where = {*question.where, question.before + "where", 1, 1};
    scene.conditions.clear();
  }
  if (question.minimize || question.maximize) {
    scene.minimize = {question.minimize.value_or(""), question.before + "minimize", 1, 1};
    scene.maximize = {question.maximize.value_or(""), question.before + "maximize", 1, 1};
  }
  if (question.moving) {
    scene.moving.clear();
    for (const std::string& name : *question.moving) scene.moving.push_back(scene.shape(name)->name);
  }
  if (question.free) range_over(scene, *question.free);
  return scene;
}

}  // namespace io
}  // namespace findspace
