// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "common/line_choice.h"

#include <fmt/format.h>

#include "exact/solid/ray_sign.h"
#include "findspace/error.h"

namespace findspace::app {
namespace {

Number spacing(const Session& session, const std::string& text) {
  try {
    const auto steps = (exact::Real::parse_decimal(text) / session.step()).integer();
    if (steps && *steps >= 1 && *steps <= exact::kRayLimit) return Number(text);
  } catch (const Error&) {
  }
  throw Error(
      ErrorCode::kUsage,
      fmt::format("--step wants a decimal number of at least one grid step, and a multiple of it, not '{}'", text));
}

}  // namespace

std::optional<MapLines> asked_lines(const Session& session) {
  const Options& options = session.options();
  if (options.resolution == 0 && options.spacing.empty()) {
    if (!options.side.empty() || !options.axis.empty())
      throw Error(ErrorCode::kUsage, "--side and --axis are for maps on lines: they need --resolution or --step");
    return std::nullopt;
  }
  MapLines out;
  out.count = options.resolution;
  if (!options.spacing.empty()) out.apart = spacing(session, options.spacing);
  if (!options.axis.empty()) out.axis = Shape::Axis(options.axis[0] - 'x');
  out.axes = options.axes;
  if (!options.side.empty()) out.side = options.side == "inner" ? MapLines::Side::kInner : MapLines::Side::kOuter;
  return out;
}

void refuse_lines(const Options& options, const char* because) {
  const auto refuse = [&](bool given, const char* name) {
    if (given) throw Error(ErrorCode::kUsage, fmt::format("{} is {}", name, because));
  };
  refuse(options.resolution > 0, "--resolution");
  refuse(!options.spacing.empty(), "--step");
  refuse(!options.axis.empty(), "--axis");
  refuse(options.axes, "--axes");
  refuse(!options.side.empty(), "--side");
}

}  // namespace findspace::app
