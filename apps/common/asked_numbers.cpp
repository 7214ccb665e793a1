// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "common/asked_numbers.h"

#include <fmt/format.h>

#include <algorithm>

namespace findspace::app {

using exact::Real;

std::optional<Real> asked_instant(const Session& session) {
  if (!session.options().time) return std::nullopt;
  const io::Motion& motion = session.scene().motion;
  if (!motion.given()) throw Error(ErrorCode::kUsage, "--time: the scene has no \"motion\"");
  Real t;
  try {
    t = Real::parse_decimal(*session.options().time);
  } catch (const Error&) {
    throw Error(ErrorCode::kUsage, fmt::format("--time wants a decimal number, not '{}'", *session.options().time));
  }
  if (t < motion.start || motion.end < t) {
    throw Error(ErrorCode::kUsage, fmt::format("--time {}: the motion is from {} to {}", *session.options().time,
                                               motion.start.text(), motion.end.text()));
  }
  return t;
}

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

Real asked_angle(const Session& session) {
  if (!session.options().angle) return {};
  constexpr int kMostDegrees = 1'000'000'000;
  try {
    const Real degrees = Real::parse_decimal(*session.options().angle);
    if (degrees > Real(kMostDegrees) || degrees < Real(-kMostDegrees))
      throw Error(ErrorCode::kOutOfRange, "too far round");
    return degrees;
  } catch (const Error&) {
    throw Error(ErrorCode::kUsage,
                fmt::format("--angle wants a decimal number of degrees, not '{}'", *session.options().angle));
  }
}

namespace {

/// An axis, x y z or three decimals, and degrees: "1,1,1:120".
space::Rotation about_axis(const std::string& text, std::size_t colon, const space::Point& about) {
  const std::string axis = text.substr(0, colon);
  const std::size_t letter = axis.size() == 1 ? std::string_view("xyz").find(axis) : std::string_view::npos;
  space::RealVector direction;
  if (letter != std::string_view::npos) {
    direction[letter] = Real(1);
  } else {
    const std::vector<Real> numbers = decimals(axis);
    if (numbers.size() != 3) throw Error(ErrorCode::kSyntax, "too few or too many numbers");
    std::copy(numbers.begin(), numbers.end(), direction.begin());
  }
  return space::Rotation::about_direction(direction, Real::parse_decimal(text.substr(colon + 1)), about);
}

space::Rotation rotation_of(const std::string& text, const space::Point& about) {
  if (const std::size_t colon = text.find(':'); colon != std::string::npos) return about_axis(text, colon, about);
  const std::vector<Real> n = decimals(text);
  if (n.size() == 4) return space::Rotation::of_quaternion({n[0], n[1], n[2], n[3]}, about);
  if (n.size() != 9) throw Error(ErrorCode::kSyntax, "too few or too many numbers");
  return space::Rotation::of_matrix({space::RealVector{n[0], n[1], n[2]}, {n[3], n[4], n[5]}, {n[6], n[7], n[8]}},
                                    about);
}

}  // namespace

std::optional<io::Orientation> asked_orientation(const Session& session) {
  const Options& options = session.options();
  const io::GridPosition& c = session.scene().free.about;
  const space::Point about{c[0], c[1], c[2]};
  if (options.angle)
    return io::Orientation{space::Rotation::about_axis(2, asked_angle(session), about), "--angle " + *options.angle};
  if (!options.orientation) return std::nullopt;
  const std::string text = "--orientation " + *options.orientation;
  try {
    return io::Orientation{rotation_of(*options.orientation, about), text};
  } catch (const Error& e) {
    if (e.code() == ErrorCode::kBadValue) throw Error(ErrorCode::kUsage, fmt::format("{}: {}", text, e.message()));
    throw Error(ErrorCode::kUsage,
                fmt::format("{}: a quaternion w,x,y,z, an axis and degrees such as z:90 or 1,1,0:45, or the nine "
                            "numbers of a matrix, row by row, are meant",
                            text));
  }
}

}  // namespace findspace::app
