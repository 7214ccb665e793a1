// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "common/line_choice.h"

#include <findspace/error.h>
#include <findspace/surface.h>
#include <fmt/format.h>

#include "common/outputs.h"

namespace findspace::app {
namespace {

std::optional<MapLines> asked_lines(const Options& options) {
  if (options.resolution == 0 && options.spacing.empty()) {
    if (!options.side.empty() || !options.axis.empty() || options.axes)
      throw Error(ErrorCode::kUsage,
                  "--side, --axis and --axes are for maps on lines: they need --resolution or --step");
    return std::nullopt;
  }
  MapLines out;
  out.count = options.resolution;
  if (!options.spacing.empty()) out.apart = options.spacing;
  if (!options.axis.empty()) out.axis = Shape::Axis(options.axis[0] - 'x');
  out.axes = options.axes;
  if (!options.side.empty()) out.side = options.side == "inner" ? MapLines::Side::kInner : MapLines::Side::kOuter;
  return out;
}

}  // namespace

std::vector<std::string> space_formats() {
  std::vector<std::string> out = Surface::endings();
  out.insert(out.begin(), ".json");
  return out;
}

SetInSpace asked_in_space(const Options& options) {
  SetInSpace out{asked_lines(options), options.json, false};
  const bool cells = out.lines && out.lines->side != MapLines::Side::kNone;  // which have no surface
  check_outputs(options, cells ? std::vector<std::string>{".json"} : space_formats());
  for (const auto& path : options.outputs) (path.extension() == ".json" ? out.listed : out.surface) = true;
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
