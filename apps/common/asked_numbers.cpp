// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "common/asked_numbers.h"

#include <fmt/format.h>

#include <algorithm>

namespace findspace::app {

using exact::Real;

namespace {

/// Decimals with commas between them.
std::vector<Real> decimals(const std::string& text) {
  std::vector<Real> out;
  for (const std::string& number : at_commas(text)) out.push_back(Real::parse_decimal(number));
  return out;
}

}  // namespace

namespace {

/// Zeros without --at; not held to the grid's range.
std::vector<Real> asked_anywhere(const Session& session, std::size_t count) {
  if (!session.options().at) return std::vector<Real>(count);
  const std::string& text = *session.options().at;
  try {
    std::vector<Real> out = decimals(text);
    if (out.size() != count) throw Error(ErrorCode::kSyntax, "too few or too many numbers");
    return out;
  } catch (const Error& e) {
    if (e.code() == ErrorCode::kOutOfRange)
      throw Error(ErrorCode::kUsage, fmt::format("--at {}: {}", text, e.message()));
    throw Error(ErrorCode::kUsage,
                fmt::format("--at wants {}, not '{}'",
                            count == 2 ? "two decimal numbers x,y" : "three decimal numbers x,y,z", text));
  }
}

/// Within the grid's range.
std::vector<Real> coordinates(const Session& session, std::size_t count) {
  std::vector<Real> out = asked_anywhere(session, count);
  try {
    for (const Real& c : out) session.scene().grid.steps(c);
  } catch (const Error& e) {
    throw Error(ErrorCode::kUsage, fmt::format("--at {}: {}", *session.options().at, e.message()));
  }
  return out;
}

}  // namespace

exact::RealPoint asked_position(const Session& session) {
  const std::vector<Real> p = coordinates(session, 2);
  return {p[0], p[1]};
}

std::vector<Number> asked_coordinates(const Session& session, std::size_t count) {
  if (!session.options().at) return {};
  asked_anywhere(session, count);  // refuses what is none
  std::vector<Number> out;
  for (const std::string& number : at_commas(*session.options().at)) out.emplace_back(number);
  return out;
}

std::optional<Point> asked_point(const Session& session) {
  const std::vector<Number> c = asked_coordinates(session, 2);
  if (c.empty()) return std::nullopt;
  asked_position(session);  // refuses what is too far away
  return Point{c[0], c[1]};
}

std::optional<Point3> asked_point_in_space(const Session& session) {
  const std::vector<Number> c = asked_coordinates(session, 3);
  if (c.empty()) return std::nullopt;
  asked_position_in_space(session);  // refuses what is too far away
  return Point3{c[0], c[1], c[2]};
}

std::array<Real, 3> asked_position_in_space(const Session& session) {
  const std::vector<Real> p = coordinates(session, 3);
  return {p[0], p[1], p[2]};
}

namespace {

/// Throws where --angle is no number of degrees.
void check_angle(const std::string& angle) {
  constexpr int kMostDegrees = 1'000'000'000;
  try {
    const Number degrees(angle);
    if (degrees > kMostDegrees || degrees < -kMostDegrees) throw Error(ErrorCode::kOutOfRange, "too far round");
  } catch (const Error&) {
    throw Error(ErrorCode::kUsage, fmt::format("--angle wants a decimal number of degrees, not '{}'", angle));
  }
}

/// --time, an instant of the scene's motion.
Number instant(const Session& session, const std::string& time) {
  const std::optional<Motion> motion = session.asked().motion();
  if (!motion) throw Error(ErrorCode::kUsage, "--time: the scene has no \"motion\"");
  const Number t(time);
  bool inside = false;
  try {
    inside = t >= motion->start && t <= motion->end;
  } catch (const Error&) {
    throw Error(ErrorCode::kUsage, fmt::format("--time wants a decimal number, not '{}'", time));
  }
  if (!inside)
    throw Error(ErrorCode::kUsage,
                fmt::format("--time {}: the motion is from {} to {}", time, motion->start.text(), motion->end.text()));
  return t;
}

}  // namespace

Pose asked_pose(const Session& session) {
  const Options& options = session.options();
  Pose pose;
  if (session.in_space())
    asked_position_in_space(session);  // refuses what is too far away
  else
    asked_position(session);
  pose.at = asked_coordinates(session, session.in_space() ? 3 : 2);
  if (options.angle && !session.in_space()) {
    check_angle(*options.angle);
    pose.degrees = *options.angle;
  }
  if (options.time) pose.time = instant(session, *options.time);
  return pose;
}

std::optional<Rotation> asked_rotation(const Session& session) {
  const Options& options = session.options();
  if (options.angle) {
    check_angle(*options.angle);
    return Rotation::read("z:" + *options.angle);
  }
  if (!options.orientation) return std::nullopt;
  const std::string text = "--orientation " + *options.orientation;
  try {
    return Rotation::read(*options.orientation);
  } catch (const Error& e) {
    if (e.code() == ErrorCode::kBadValue) throw Error(ErrorCode::kUsage, fmt::format("{}: {}", text, e.message()));
    throw Error(ErrorCode::kUsage,
                fmt::format("{}: a quaternion w,x,y,z, an axis and degrees such as z:90 or 1,1,0:45, or the nine "
                            "numbers of a matrix, row by row, are meant",
                            text));
  }
}

}  // namespace findspace::app
