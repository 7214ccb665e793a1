// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "common/asked_numbers.h"

#include <fmt/format.h>

#include <string_view>

namespace findspace::app {
namespace {

/// Throws where it is none; kOutOfRange for exponents beyond reason.
Number read_decimal(const std::string& text) {
  Number out(text);
  if (text.find('/') != text.npos) throw Error(ErrorCode::kSyntax, "a fraction");
  out.value();  // refuses what is none
  return out;
}

}  // namespace

std::optional<Number> decimal(const std::string& text) try { return read_decimal(text); } catch (const Error&) {
  return std::nullopt;
}

std::vector<Number> asked_coordinates(const Session& session, std::size_t count) {
  if (!session.options().at) return {};
  const std::string& text = *session.options().at;
  try {
    std::vector<Number> out;
    for (const std::string& number : at_commas(text)) out.push_back(read_decimal(number));
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

std::vector<Number> asked_position(const Session& session) {
  Pose pose{asked_coordinates(session, session.in_space() ? 3 : 2)};
  try {
    session.scene().require(pose);
  } catch (const Error& e) {
    throw Error(ErrorCode::kUsage, fmt::format("--at {}: {}", *session.options().at, e.message()));
  }
  return std::move(pose.at);
}

namespace {

void refuse_fraction(const std::string& number) {
  if (number.find('/') != std::string::npos) throw Error(ErrorCode::kBadValue, "a fraction");
}

/// Throws where --angle is no number of degrees.
void check_angle(const std::string& angle) {
  constexpr int kMostDegrees = 1'000'000'000;
  try {
    const Number degrees(angle);
    refuse_fraction(angle);
    if (degrees > kMostDegrees || degrees < -kMostDegrees) throw Error(ErrorCode::kOutOfRange, "too far round");
  } catch (const Error&) {
    throw Error(ErrorCode::kUsage, fmt::format("--angle wants a decimal number of degrees, not '{}'", angle));
  }
}

/// --time, an instant of the scene's motion.
Number instant(const Session& session, const std::string& time) {
  const std::optional<Motion> motion = session.scene().motion();
  if (!motion) throw Error(ErrorCode::kUsage, "--time: the scene has no \"motion\"");
  const Number t(time);
  bool inside = false;
  try {
    refuse_fraction(time);
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
  Pose pose{asked_position(session)};
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
