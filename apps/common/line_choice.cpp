// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "common/line_choice.h"

#include <fmt/format.h>

#include "findspace/error.h"

namespace findspace::app {
namespace {

std::int64_t grid_steps(const Session& session, const std::string& text) {
  try {
    const auto steps = (exact::Real::parse_decimal(text) / session.step()).integer();
    if (steps && *steps >= 1 && *steps <= exact::kRayLimit) return static_cast<std::int64_t>(*steps);
  } catch (const Error&) {
  }
  throw Error(
      ErrorCode::kUsage,
      fmt::format("--step wants a decimal number of at least one grid step, and a multiple of it, not '{}'", text));
}

}  // namespace

space::RayGrid LineChoice::grid(const space::Point& low, const space::Point& high) const {
  return apart > 0 ? space::ray_grid_by_step(low, high, axis, apart) : space::ray_grid(low, high, axis, count);
}

space::RayLattice LineChoice::lattice(const space::Point& low, const space::Point& high) const {
  return apart > 0 ? space::ray_lattice_by_step(low, high, apart) : space::ray_lattice(low, high, count);
}

std::optional<LineChoice> asked_lines(const Session& session) {
  const Options& options = session.options();
  if (options.resolution == 0 && options.spacing.empty()) {
    if (!options.side.empty() || !options.axis.empty())
      throw Error(ErrorCode::kUsage, "--side and --axis are for maps on lines: they need --resolution or --step");
    return std::nullopt;
  }
  LineChoice out;
  out.count = options.resolution;
  if (!options.spacing.empty()) out.apart = grid_steps(session, options.spacing);
  if (!options.axis.empty()) out.axis = options.axis[0] - 'x';
  out.axes = options.axes;
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
