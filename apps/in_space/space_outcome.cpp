// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "in_space/space_outcome.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "io/mesh/space_surface.h"
#include "io/write/write_json_space.h"
#include "io/write/write_summary.h"

namespace findspace::app {

using exact::Real;

std::vector<std::string> space_formats() {
  std::vector<std::string> out{".json"};
  out.insert(out.end(), io::kSurfaceEndings.begin(), io::kSurfaceEndings.end());
  return out;
}

/// JSON, and the surface in every format.
Writers space_writers(std::function<std::string()> json, std::function<io::Surface()> surface, const std::string& title,
                      const std::string& unit) {
  Writers out{{".json", std::move(json)}};
  for (const char* ending : io::kSurfaceEndings)
    out.emplace(ending, [=] { return io::surface_text(surface(), title, ending, unit); });
  return out;
}

Outcome polytope_outcome(const Session& session, const space::ConvexSet& set, const Real& step,
                         const std::string& title, const distance::OptimalValue* best) {
  const Options& options = session.options();
  const space::SpaceSummary summary = space::summarize(set, step);
  const auto json = [&] { return io::space_json(set, summary, step, session.unit(), best); };
  const auto surface = [&] { return io::convex_surface(set, step); };
  write_outputs(options, space_writers(json, surface, title, session.unit()));
  return {options.json ? json() : io::summary_text(title, summary, session.unit(), best),
          summary.empty ? kEmpty : kDone};
}

/// What the facets of a grown polytope do not give.
bool wants_surface(const Session& session) {
  const auto& outputs = session.options().outputs;
  return std::any_of(outputs.begin(), outputs.end(),
                     [](const std::filesystem::path& name) { return name.extension() != ".json"; });
}

void check_lines_outputs(const Session& session, const MapLines& lines) {
  check_outputs(session.options(),
                lines.side == MapLines::Side::kNone ? space_formats() : std::vector<std::string>{".json"});
}

}  // namespace findspace::app
