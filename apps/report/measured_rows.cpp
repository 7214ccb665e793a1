// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "report/measured_rows.h"

#include <fmt/format.h>

#include <algorithm>

#include "findspace/error.h"
#include "formula/language/names.h"
#include "formula/language/text.h"
#include "io/report/position_report.h"

namespace findspace::app {
namespace {

formula::Kind kind_of(const std::string& name) {
  if (const formula::DistanceName* row = formula::find_distance(name)) return row->kind;
  std::vector<std::string> names;
  for (const formula::DistanceName& row : formula::distance_names()) names.emplace_back(row.name);
  const std::string near = formula::nearest(name, names);
  throw Error(ErrorCode::kUsage, fmt::format("--only {}: there is no such distance{}", name,
                                             near.empty() ? "" : fmt::format("; did you mean '{}'?", near)));
}

}  // namespace

std::vector<formula::Kind> wanted_kinds(const Options& options) {
  if (!options.only.empty()) return {kind_of(options.only)};
  const bool file = std::any_of(options.outputs.begin(), options.outputs.end(),
                                [](const auto& path) { return path.extension() == ".json"; });
  if (options.all || options.json || file) return {};
  std::vector<formula::Kind> kinds;
  for (const std::string_view name : io::kUsualDistances) kinds.push_back(kind_of(std::string(name)));
  return kinds;
}

std::vector<formula::DistanceAt> only_wanted(std::vector<formula::DistanceAt> distances, const Options& options) {
  if (options.only.empty()) return distances;
  const formula::Kind kind = kind_of(options.only);
  std::erase_if(distances, [&](const formula::DistanceAt& d) {
    const formula::PlainText plain = formula::plain(d.text);
    return kind_of(std::string(io::distance_word(plain.text))) != kind;
  });
  return distances;
}

}  // namespace findspace::app
