// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "report/measured_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "findspace/error.h"
#include "formula/language/names.h"
#include "formula/language/text.h"

namespace findspace::app {
namespace {

constexpr std::array<std::string_view, 5> kShown{"gap", "margin", "reach", "protrusion", "hausdorff"};

/// "gap" of "inf gap(B, A)".
std::string_view word_of(std::string_view text) {
  const std::string_view before = text.substr(0, text.find('('));
  const std::size_t blank = before.rfind(' ');
  return blank == std::string_view::npos ? before : before.substr(blank + 1);
}

struct Ranked {
  MeasuredRow row;
  std::size_t pair = 0, rank = 0;
};

}  // namespace

std::vector<MeasuredRow> measured_rows(const std::vector<formula::DistanceAt>& distances, bool all) {
  std::vector<Ranked> rows;
  std::size_t pair = 0;
  bool in_gap = false;
  for (std::size_t k = 0; k < distances.size(); ++k) {
    const formula::PlainText plain = formula::plain(distances[k].text);
    const std::string_view word = word_of(plain.text);
    const bool directional = plain.text.find('=') != std::string::npos;
    if (word == kShown[0] && !directional && !in_gap) ++pair;
    in_gap = word == kShown[0];
    const auto rank = std::size_t(std::find(kShown.begin(), kShown.end(), word) - kShown.begin());
    if (rank == kShown.size() && !all && !directional) continue;
    rows.push_back(
        {{k, plain.text, plain.negated}, directional ? distances.size() : pair, all || directional ? 0 : rank});
  }
  std::stable_sort(rows.begin(), rows.end(), [](const Ranked& a, const Ranked& b) {
    return a.pair != b.pair ? a.pair < b.pair : a.rank < b.rank;
  });
  std::vector<MeasuredRow> out;
  for (Ranked& r : rows) out.push_back(std::move(r.row));
  return out;
}

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
  for (const std::string_view name : kShown) kinds.push_back(kind_of(std::string(name)));
  return kinds;
}

std::vector<formula::DistanceAt> only_wanted(std::vector<formula::DistanceAt> distances, const Options& options) {
  if (options.only.empty()) return distances;
  const formula::Kind kind = kind_of(options.only);
  std::erase_if(distances, [&](const formula::DistanceAt& d) {
    const formula::PlainText plain = formula::plain(d.text);
    return kind_of(std::string(word_of(plain.text))) != kind;
  });
  return distances;
}

std::string said_distance(const formula::Atom& atom) {
  return atom.predicate == nullptr ? "" : std::string(atom.distance.spelled->name) + " ";
}

std::string explained(distance::Way way, double milliseconds) {
  const std::string by = way == distance::Way::kNone ? "" : fmt::format(" by {}", distance::name(way));
  return fmt::format(",{} in {:.3f} ms", by, milliseconds);
}

}  // namespace findspace::app
