// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "report/position_report.h"

#include <fmt/format.h>

#include <algorithm>

#include "formula/language/text.h"
#include "io/draw/draw_layout.h"
#include "io/write/write_witness.h"
#include "report/measured_rows.h"

namespace findspace::app {
namespace {

/// A length, or a number of degrees.
std::string amount_text(const formula::DistanceAt& d, double amount, std::string_view unit) {
  const std::string number = io::shown(amount);
  return d.in_degrees ? number + "°" : unit.empty() ? number : fmt::format("{} {}", number, unit);
}

/// How far the true value may be from the one that is shown; empty where that is exact.
std::string within_text(const formula::DistanceAt& d) {
  if (!d.answer || d.answer->proven || d.answer->minus_infinity) return "";
  const distance::Enclosure between = d.answer->bounds();
  if (!between.lower && !between.upper) return " (not certain)";
  if (!between.lower) return fmt::format(" (at most {})", io::shown(between.upper->to_double()));
  if (!between.upper) return fmt::format(" (at least {})", io::shown(between.lower->to_double()));
  const exact::Real below = d.answer->value - *between.lower, above = *between.upper - d.answer->value;
  constexpr double kRoundedUp = 1.1;  // to two digits
  return fmt::format(" (within {:.1e})", std::max(below, above).to_double() * kRoundedUp);
}

std::string value_text(const formula::DistanceAt& d, std::string_view unit) {
  if (!d.refused.empty()) return "not computed";
  const auto value = d.value();
  return value ? amount_text(d, *value, unit) + within_text(d) : "undefined";
}

/// With the value that its word says.
formula::DistanceAt as_said(const formula::DistanceAt& d, bool negated) { return negated ? formula::minus(d) : d; }

std::size_t widest(const std::vector<std::string>& texts) {
  std::size_t width = 0;
  for (const std::string& t : texts) width = std::max(width, t.size());
  return width;
}

}  // namespace

std::string check_text(const formula::Check& check, std::string_view at, const distance::Coordinates& place,
                       std::string_view unit, const formula::AskedNearest& nearest, bool explain) {
  std::vector<std::string> texts;
  for (const auto& a : check.atoms) texts.push_back(formula::written(a.atom));
  const std::size_t width = widest(texts);
  std::string out = fmt::format("{} {}\n", at, check.holds ? "is feasible" : "is not feasible");
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const formula::AtomAt& a = check.atoms[i];
    out +=
        fmt::format("  {}  {:<{}}  {}", a.holds ? "yes" : "no ", texts[i], width,
                    said_distance(a.atom) + value_text(as_said(a.distance, formula::negated(a.atom.distance)), unit));
    if (a.lacks)
      out += fmt::format(", {} {}", *a.lacks > 0 ? "off by" : "not allowed: off by",
                         amount_text(a.distance, *a.lacks, unit));
    if (explain) out += explained(a.way, a.milliseconds);
    const std::string where = io::witness_words(a.distance);
    const std::string way = a.holds ? "" : io::way_words(a.distance, place);
    out += "\n";
    if (!where.empty()) out += fmt::format("       {:<{}}  between {}\n", "", width, where);
    if (!way.empty()) out += fmt::format("       {:<{}}  {}\n", "", width, way);
  }
  return out + io::nearest_words(nearest, unit);
}

std::string measure_text(const std::vector<formula::DistanceAt>& distances, std::string_view at,
                         const distance::Coordinates& place, std::string_view unit, bool all) {
  const std::vector<MeasuredRow> rows = measured_rows(distances, all);
  std::vector<std::string> texts, values;
  for (const MeasuredRow& row : rows) {
    texts.push_back(row.text);
    values.push_back(value_text(as_said(distances[row.of], row.negated), unit));
  }
  const std::size_t width = widest(texts), columns = widest(values);
  std::string out = fmt::format("at {}\n", at);
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const formula::DistanceAt& d = distances[rows[i].of];
    const std::string points = io::witness_words(d), where = points.empty() ? io::way_words(d, place) : points;
    out += fmt::format("  {:<{}}  {:<{}}{}\n", texts[i], width, values[i], where.empty() ? 0 : columns,
                       where.empty() ? "" : "  " + where);
  }
  return out;
}

}  // namespace findspace::app
