// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The numbers of the command line: --at, --time and --angle, as exact as they are written.

#include <fmt/format.h>

#include <algorithm>

#include "session.h"

namespace findspace::app {

using exact::Real;

std::optional<Real> Session::instant() const {
  if (!options_.time) return std::nullopt;
  const io::Motion& motion = scene_.motion;
  if (!motion.given()) throw Error(ErrorCode::kUsage, "--time: the scene has no \"motion\"");
  Real t;
  try {
    t = Real::parse_decimal(*options_.time);
  } catch (const Error&) {
    throw Error(ErrorCode::kUsage, fmt::format("--time wants a decimal number, not '{}'", *options_.time));
  }
  if (t < motion.start || motion.end < t) {
    throw Error(ErrorCode::kUsage, fmt::format("--time {}: the motion is from {} to {}", *options_.time,
                                               motion.start.text(), motion.end.text()));
  }
  return t;
}

exact::RealPoint Session::position() const {
  const std::vector<Real> p = coordinates(2);
  return {p[0], p[1]};
}

std::array<Real, 3> Session::position_in_space() const {
  const std::vector<Real> p = coordinates(3);
  return {p[0], p[1], p[2]};
}

std::vector<Real> Session::coordinates(std::size_t count) const {
  std::vector<Real> out = position_anywhere(count);
  try {
    for (const Real& c : out) scene_.grid.steps(c);
  } catch (const Error& e) {
    throw Error(ErrorCode::kUsage, fmt::format("--at {}: {}", *options_.at, e.message()));
  }
  return out;
}

std::vector<Real> Session::position_anywhere(std::size_t count) const {
  std::vector<Real> out;
  if (!options_.at) return std::vector<Real>(count);
  const std::string& text = *options_.at;
  try {
    for (std::size_t begin = 0; begin <= text.size();) {
      const std::size_t end = std::min(text.find(',', begin), text.size());
      out.push_back(Real::parse_decimal(text.substr(begin, end - begin)));
      begin = end + 1;
    }
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

Real Session::angle() const {
  if (!options_.angle) return {};
  constexpr int kMostDegrees = 1'000'000'000;
  try {
    const Real degrees = Real::parse_decimal(*options_.angle);
    if (degrees > Real(kMostDegrees) || degrees < Real(-kMostDegrees))
      throw Error(ErrorCode::kOutOfRange, "too far round");
    return degrees;
  } catch (const Error&) {
    throw Error(ErrorCode::kUsage, fmt::format("--angle wants a decimal number of degrees, not '{}'", *options_.angle));
  }
}

}  // namespace findspace::app
