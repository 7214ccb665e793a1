// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "io/write/write_placement.h"

#include <fmt/ranges.h>

#include <algorithm>

#include "io/draw/draw_layout.h"
#include "io/write/json_text.h"
#include "plane/query/measure_cells_twofold.h"

namespace findspace::io {
namespace {

using exact::Real;
using plane::Twofold;

std::string scaled(const Real& steps, const Real& step) {
  return json_number((Twofold(steps) * Twofold(step)).value());
}

/// The key and the value that say how a body is rotated.
std::string orientation_json(const planning::Orientation& turn) {
  if (!turn.rotation) return fmt::format("\"angle\": {}", json_number(turn.degrees.to_double()));
  return fmt::format("\"orientation\": {}", matrix_json(*turn.rotation));
}

std::string placed_json(const planning::BodyOutcome& p, const Real& step) {
  std::string out = fmt::format("{{\"shape\": {}", json_string(p.shape));
  if (p.copy > 0) put(out, ", \"copy\": {}", p.copy);
  if (!p.at.empty()) {
    std::vector<std::string> at;
    for (const Real& c : p.at) at.push_back(scaled(c, step));
    put(out, ", \"at\": [{}]", fmt::join(at, ", "));
    if (p.angle) put(out, ", {}", orientation_json(*p.angle));
    return out + (p.attained ? "}" : ", \"attained\": false}");
  }
  out += ", \"at\": null";
  if (!p.attained) {
    out += ", \"attained\": false, \"infimum\": [";
    for (std::size_t k = 0; k < p.infimum.size(); ++k)
      put(out, "{}{}", k > 0 ? ", " : "", p.infimum[k] ? json_number(p.infimum[k]->to_double()) : "null");
    out += "]";
  }
  return out + "}";
}

/// Without its last line end.
std::string_view region_text(const PositionsResult& p) {
  std::string_view text = p.region;
  while (!text.empty() && text.back() == '\n') text.remove_suffix(1);
  return text;
}

std::string regions_json(const PlacementResult& result) {
  std::string out = "{";
  const auto& all = result.regions;
  for (std::size_t k = 0; k < all.size();) {
    put(out, "{}\n{}: ", k > 0 ? "," : "", json_string(all[k].shape));
    if (!all[k].angle) {
      out += region_text(all[k++]);
      continue;
    }
    out += "[";
    for (std::size_t first = k; k < all.size() && all[k].shape == all[first].shape; ++k)
      put(out, "{}{{{}, \"positions\": {}}}", k > first ? ",\n" : "", orientation_json(*all[k].angle),
          region_text(all[k]));
    out += "]";
  }
  return out + "}";
}

}  // namespace

std::string matrix_json(const space::Rotation& rotation) {
  std::vector<std::string> rows;
  for (const space::RealVector& row : rotation.rows) {
    rows.push_back(fmt::format("[{}, {}, {}]", json_number(row[0].to_double()), json_number(row[1].to_double()),
                               json_number(row[2].to_double())));
  }
  return fmt::format("[{}]", fmt::join(rows, ", "));
}

std::string orientation_text(const planning::Orientation& turn) {
  return turn.rotation ? turn.text : fmt::format("{} deg", shown(turn.degrees.to_double()));
}

std::string placement_json(const PlacementResult& result, const Real& step, std::string_view unit) {
  std::string out = fmt::format("{{\"method\": {}, ", json_string(result.method));
  if (!unit.empty()) put(out, "\"unit\": {}, ", json_string(unit));
  put(out, "\"attained\": {}, \"proven\": {},", result.attained, !result.unproven);
  if (result.unproven) put(out, " \"reason\": {},", json_string(*result.unproven));
  out += "\n\"positions\": [";
  for (std::size_t k = 0; k < result.placed.size(); ++k)
    put(out, "{}\n  {}", k > 0 ? "," : "", placed_json(result.placed[k], step));
  return out + "],\n\"regions\": " + regions_json(result) + "}\n";
}

std::string placement_text(const PlacementResult& result, const Real& step, std::string_view unit) {
  const std::string suffix = unit.empty() ? "" : fmt::format(" {}", unit);
  std::size_t width = 0;
  for (const planning::BodyOutcome& p : result.placed) width = std::max(width, p.shape.size() + 5);
  std::string out = fmt::format("Placement, {}\n", result.method);
  for (const planning::BodyOutcome& p : result.placed) {
    const std::string name = p.copy > 0 ? fmt::format("{} {}", p.shape, p.copy) : p.shape;
    put(out, "  {:<{}}  ", name, width);
    if (!p.at.empty()) {
      std::vector<std::string> at;
      for (const Real& c : p.at) at.push_back(shown((Twofold(c) * Twofold(step)).value()));
      put(out, "({}){}", fmt::join(at, ", "), suffix);
      if (p.angle) put(out, ", rotated by {}", orientation_text(*p.angle));
      if (!p.attained) out += ", one of many: the least value is not taken";
    } else {
      out += p.attained ? "no free position" : "no best position: the least value is not taken";
    }
    out += "\n";
  }
  if (result.unproven) put(out, "not decided: {}\n", *result.unproven);
  return out;
}

}  // namespace findspace::io
