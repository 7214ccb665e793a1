// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "asked_numbers.h"

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

std::vector<Real> asked_anywhere(const Session& session, std::size_t count) {
  std::vector<Real> out;
  if (!session.options().at) return std::vector<Real>(count);
  const std::string& text = *session.options().at;
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

namespace {

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

}  // namespace findspace::app
