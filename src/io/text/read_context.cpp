// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/text/read_context.h"

#include <fmt/format.h>

#include "exact/number/decimal.h"
#include "findspace/error.h"
#include "io/text/drawing_rules.h"
#include "io/text/read_text.h"
#include "plane/curve/curve_arcs.h"

namespace findspace::io {
namespace {

std::string count(std::int64_t n, const char* one, const char* many) {
  return fmt::format("{} {}", n, n == 1 ? one : many);
}

/// What a rule says, in grid steps; throws Error with its name.
exact::Real steps_of(const char* rule, const std::string& length, const ReadContext& context) {
  try {
    return context.grid.steps(parse_length(length, context.unit));
  } catch (const Error& e) {
    throw e.within(rule);
  }
}

/// As it is written, with the scene's unit where it has none of its own: rounded, it might look like the least one.
std::string stated_length(const std::string& length, std::optional<Unit> unit) {
  const bool plain = scan_number(length) == length.size();
  return plain && unit ? fmt::format("{} {}", length, formula::name(*unit)) : length;
}

/// Rounded down.
std::int64_t whole_steps_of(const char* rule, const std::string& length, const ReadContext& context) {
  const exact::Real steps = steps_of(rule, length, context);
  if (steps > exact::Real(exact::int128(exact::kMaxGridCoordinate)))
    throw Error(ErrorCode::kBadValue, fmt::format("the length '{}' is larger than any mesh may be", length), rule);
  return std::int64_t(steps.to_double());
}

}  // namespace

std::string ReadContext::take_file(const std::filesystem::path& path) {
  if (!options.files) throw Error(ErrorCode::kUnsupported, "shapes from files are switched off here", path.string());
  std::string text = read_text(path, bytes_left, options.root);
  bytes_left -= text.size();
  return text;
}

void ReadContext::take_bytes(std::uint64_t bytes, const std::string& what) {
  if (bytes > bytes_left) {
    throw Error(ErrorCode::kLimit, fmt::format("{} unpacks to {} bytes; {} bytes of input are allowed, which "
                                               "--input-limit raises",
                                               what, bytes, options.input_limit));
  }
  bytes_left -= bytes;
}

void ReadContext::use(const DrawingRules& rules) {
  drawing = {};
  if (rules.curves) drawing.curves = *rules.curves;
  const exact::Real thousandth = exact::Real::ratio(1, 1000);
  const exact::Real usual = unit ? thousandth * formula::factor(Unit::kMillimetre, *unit) : thousandth;
  drawing.tolerance = std::max((usual / grid.step()).to_double(), plane::kLeastBound);
  if (rules.tolerance) drawing.tolerance = steps_of("tolerance", *rules.tolerance, *this).to_double();
  if (rules.join) drawing.join = steps_of("join", *rules.join, *this).to_double();
  if (rules.mend) drawing.mend = steps_of("mend", *rules.mend, *this).to_double();
  if (rules.open_lines) drawing.open_lines = *rules.open_lines;
  drawing.parts = rules.parts;
  if (rules.repair) drawing.repair.width = whole_steps_of("repair", *rules.repair, *this);
  if (rules.close_holes) drawing.repair.hole = whole_steps_of("close_holes", *rules.close_holes, *this);
  if (drawing.tolerance < plane::kLeastBound)
    throw Error(ErrorCode::kBadValue,
                fmt::format("a tolerance of {} is too small; at least {} is needed, so give the scene a finer \"grid\"",
                            stated_length(*rules.tolerance, unit), length_text(plane::kLeastBound)));
}

std::string ReadContext::length_text(double steps) const {
  const std::string blank_unit = unit ? fmt::format(" {}", formula::name(*unit)) : "";
  return fmt::format("{:.3g}{}", steps * grid.step_size(), blank_unit);
}

std::string ReadContext::point_text(double x, double y) const {
  return fmt::format("({:.10g}, {:.10g})", x * grid.step_size(), y * grid.step_size());
}

std::vector<std::string> ReadContext::summary() const {
  std::vector<std::string> all = notes;
  if (rounding.points > 0) {
    std::string blank_unit = unit ? fmt::format(" {}", formula::name(*unit)) : "";
    all.push_back(fmt::format("{} rounded to the grid, largest move {:.2g}{}",
                              count(rounding.points, "point", "points"), rounding.largest * grid.step_size(),
                              blank_unit));
  }
  if (curves.curves > 0) {
    all.push_back(fmt::format("{} became {}, proved to be within {:.10g}{} ({})",
                              count(curves.curves, "curve", "curves"), count(curves.arcs, "arc", "arcs and segments"),
                              curves.bound * grid.step_size(), unit ? fmt::format(" {}", formula::name(*unit)) : "",
                              curves.sides));
  }
  if (grown_arcs > 0) {
    all.push_back(fmt::format("{} enlarged to reach both ends", count(grown_arcs, "arc", "arcs")));
  }
  if (repeated_points > 0)
    all.push_back(fmt::format("{} dropped", count(repeated_points, "repeated point", "repeated points")));
  if (reversed_rings > 0) {
    all.push_back(fmt::format("{} reversed to run counter-clockwise",
                              count(reversed_rings, "clockwise ring", "clockwise rings")));
  }
  return all;
}

}  // namespace findspace::io
