// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/scene/scene_rotation.h"

#include <fmt/format.h>

#include <array>

namespace findspace::io {
namespace {

using exact::Real;
using Kind = JsonValue::Kind;
using space::Rotation;

constexpr int kMostDegrees = 1'000'000'000, kMostAngles = 10'000;

template <std::size_t n>
std::array<Real, n> read_row(const JsonValue& value, std::string_view what, const SceneReader& json,
                             const Label& label) {
  json.expect(value, Kind::kArray, what, label);
  if (value.size() != n)
    json.fail(ErrorCode::kBadValue, fmt::format("{} has {} numbers, not {}", what, n, value.size()), label, value);
  std::array<Real, n> out;
  for (std::size_t k = 0; k < n; ++k) out[k] = json.number(value.items()[k], label);
  return out;
}

template <std::size_t n>
std::string row_text(const std::array<Real, n>& row) {
  std::string out;
  for (const Real& x : row) out += (out.empty() ? "" : ", ") + fmt::format("{}", x.to_double());
  return "(" + out + ")";
}

space::RealVector read_axis(const JsonValue& value, const SceneReader& json, const Label& label) {
  if (!value.is(Kind::kString)) return read_row<3>(value, "an axis", json, label);
  const std::string_view word = value.text();
  const std::size_t k = word.size() == 1 ? std::string_view("xyz").find(word) : std::string_view::npos;
  if (k == std::string_view::npos)
    json.fail(ErrorCode::kBadValue, "\"axis\" is \"x\", \"y\" or \"z\", or a direction [x, y, z]", label, value);
  space::RealVector out;
  out[k] = Real(1);
  return out;
}

Orientation about_axis(const JsonValue& degrees, const JsonValue* axis, const space::Point& about,
                       const SceneReader& json, const Label& label) {
  const Real angle = json.number(degrees, label);
  if (exact::abs(angle) > Real(kMostDegrees))
    json.fail(ErrorCode::kOutOfRange, "an angle of more than 1e9 degrees", label, degrees);
  const space::RealVector direction =
      axis ? read_axis(*axis, json, label.part("axis")) : space::RealVector{Real(0), Real(0), Real(1)};
  return {Rotation::about_direction(direction, angle, about),
          fmt::format("{}° about {}", angle.to_double(), row_text(direction))};
}

Orientation of_matrix(const JsonValue& value, const space::Point& about, const SceneReader& json, const Label& label) {
  json.expect(value, Kind::kArray, "\"matrix\"", label);
  if (value.size() != 3)
    json.fail(ErrorCode::kBadValue, fmt::format("\"matrix\" has 3 rows, not {}", value.size()), label, value);
  Rotation::Matrix rows;
  std::string text;
  for (std::size_t k = 0; k < 3; ++k) {
    rows[k] = read_row<3>(value.items()[k], "a row", json, label.part("row", k));
    text += (k > 0 ? " " : "") + row_text(rows[k]);
  }
  return {Rotation::of_matrix(rows, about), "matrix " + text};
}

Orientation of_object(const JsonValue& value, const space::Point& about, const SceneReader& json, const Label& label) {
  const JsonValue *quaternion = value.find("quaternion"), *matrix = value.find("matrix"),
                  *degrees = value.find("degrees"), *axis = value.find("axis");
  static constexpr std::array<std::string_view, 4> kKeys{"quaternion", "matrix", "axis", "degrees"};
  json.check_keys(value, kKeys, label);
  if ((quaternion != nullptr) + (matrix != nullptr) + (degrees != nullptr) != 1 || (axis && !degrees))
    json.fail(ErrorCode::kBadValue,
              "an orientation is {\"quaternion\": [w, x, y, z]}, {\"matrix\": [row, row, row]} or "
              "{\"axis\": [x, y, z], \"degrees\": d}",
              label, value);
  if (degrees) return about_axis(*degrees, axis, about, json, label);
  if (matrix) return of_matrix(*matrix, about, json, label.part("matrix"));
  const auto q = read_row<4>(*quaternion, "a quaternion", json, label.part("quaternion"));
  return {Rotation::of_quaternion(q, about), "quaternion " + row_text(q)};
}

}  // namespace

Orientation read_orientation(const JsonValue& value, const JsonValue* axis, const GridPosition& about,
                             const SceneReader& json, const Label& label) {
  const space::Point center{about[0], about[1], about[2]};
  return json.placed(label, value, [&] {
    if (!value.is(Kind::kObject)) return about_axis(value, axis, center, json, label);
    if (axis)
      json.fail(ErrorCode::kBadValue, "\"axis\" stands beside a number of degrees, or in the orientation", label,
                *axis);
    return of_object(value, center, json, label);
  });
}

std::vector<Orientation> read_orientations(const JsonValue& value, const GridPosition& about, const SceneReader& json,
                                           const Label& label) {
  std::vector<Orientation> out;
  if (value.is(Kind::kArray)) {
    for (std::size_t k = 0; k < value.size(); ++k)
      out.push_back(read_orientation(value.items()[k], nullptr, about, json, label.part("orientation", k)));
    if (out.empty()) json.fail(ErrorCode::kBadValue, "\"angles\" is an empty list", label, value);
    return out;
  }
  const auto count = json.number(value, label).integer();
  if (!count || *count < 1 || *count > kMostAngles)
    json.fail(ErrorCode::kBadValue,
              fmt::format("\"angles\" must be a list or a whole number from 1 to {}", kMostAngles), label, value);
  const space::Point center{about[0], about[1], about[2]};
  for (exact::int128 k = 0; k < *count; ++k) {
    const Real degrees = Real::ratio(360 * k, *count);
    out.push_back({Rotation::about_axis(2, degrees, center), fmt::format("{}° about (0, 0, 1)", degrees.to_double())});
  }
  return out;
}

}  // namespace findspace::io
