// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "io/report/position_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "formula/language/text.h"
#include "io/draw/draw_layout.h"
#include "io/write/write_witness.h"

namespace findspace::io {
namespace {

struct Ranked {
  MeasuredRow row;
  std::size_t pair = 0, rank = 0;
};

/// A value with how far the true one may be from it; of one that has one end only, that end.
std::string answer_text(const formula::DistanceAt& d, double value, std::string_view unit) {
  const std::string amount = amount_words(d, value, unit);
  if (d.answer->proven || d.answer->minus_infinity) return amount;
  const distance::Enclosure between = d.answer->bounds();
  if (!between.lower && !between.upper) return amount + " (not certain)";
  if (!between.lower || !between.upper) {
    const std::string end = amount_words(d, (between.lower ? between.lower : between.upper)->to_double(), unit);
    return fmt::format("{} {}", between.lower ? "at least" : "at most", end);
  }
  const exact::Real below = d.answer->value - *between.lower, above = *between.upper - d.answer->value;
  constexpr double kRoundedUp = 1.1;  // to two digits
  return fmt::format("{} (within {:.1e})", amount, std::max(below, above).to_double() * kRoundedUp);
}

std::string value_text(const formula::DistanceAt& d, std::string_view unit) {
  if (!d.refused.empty()) return "not computed";
  const auto value = d.value();
  return value ? answer_text(d, *value, unit) : "undefined";
}

/// With the value that its word says.
formula::DistanceAt as_said(const formula::DistanceAt& d, bool negated) { return negated ? formula::minus(d) : d; }

std::size_t widest(const std::vector<std::string>& texts) {
  std::size_t width = 0;
  for (const std::string& t : texts) width = std::max(width, t.size());
  return width;
}

}  // namespace

/// "gap" of "inf gap(B, A)".
std::string_view distance_word(std::string_view text) {
  const std::string_view before = text.substr(0, text.find('('));
  const std::size_t blank = before.rfind(' ');
  return blank == std::string_view::npos ? before : before.substr(blank + 1);
}

bool is_directional(std::string_view text) { return text.find('=') != std::string_view::npos; }

std::vector<MeasuredRow> measured_rows(const std::vector<formula::DistanceAt>& distances, bool all) {
  std::vector<Ranked> rows;
  std::size_t pair = 0;
  bool in_gap = false;
  for (std::size_t k = 0; k < distances.size(); ++k) {
    const formula::PlainText plain = formula::plain(distances[k].text);
    const std::string_view word = distance_word(plain.text);
    const bool directional = is_directional(plain.text);
    if (word == kUsualDistances[0] && !directional && !in_gap) ++pair;
    in_gap = word == kUsualDistances[0];
    const auto rank =
        std::size_t(std::find(kUsualDistances.begin(), kUsualDistances.end(), word) - kUsualDistances.begin());
    if (rank == kUsualDistances.size() && !all && !directional) continue;
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

std::string said_distance(const formula::Atom& atom) {
  return atom.predicate == nullptr ? "" : std::string(atom.distance.spelled->name) + " ";
}

std::string explained(distance::Way way, double milliseconds) {
  const std::string by = way == distance::Way::kNone ? "" : fmt::format(" by {}", distance::name(way));
  return fmt::format(",{} in {:.3f} ms", by, milliseconds);
}

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
    if (a.lacks) out += fmt::format(", {}{}", *a.lacks > 0 ? "" : "not allowed: ", lacks_words(a, unit));
    if (explain) out += explained(a.way, a.milliseconds);
    const std::string where = witness_words(a.distance);
    const std::string way = a.holds && !where.empty() ? "" : way_words(a.distance, place);
    out += "\n";
    if (!where.empty()) out += fmt::format("       {:<{}}  between {}\n", "", width, where);
    if (!way.empty()) out += fmt::format("       {:<{}}  {}\n", "", width, way);
  }
  return out + nearest_words(nearest, unit);
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
    const std::string points = witness_words(d), where = points.empty() ? way_words(d, place) : points;
    out += fmt::format("  {:<{}}  {:<{}}{}\n", texts[i], width, values[i], where.empty() ? 0 : columns,
                       where.empty() ? "" : "  " + where);
  }
  return out;
}

}  // namespace findspace::io
