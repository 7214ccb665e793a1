// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "formula/language/names.h"

#include <algorithm>
#include <array>

namespace findspace::formula {
namespace {

constexpr std::array<DistanceName, 28> kDistances{{
    {"gamma1", Kind::kGamma1},
    {"gamma2", Kind::kGamma2},
    {"eta1", Kind::kEta1},
    {"eta2", Kind::kEta2},
    {"delta1", Kind::kDelta1},
    {"delta2", Kind::kDelta2},
    {"mu", Kind::kMu},
    {"hausdorff", Kind::kHausdorff},
    {"d1", Kind::kD1},
    {"d2", Kind::kD2},
    {"h", Kind::kH},
    {"dstar", Kind::kDstar},
    {"diameter", Kind::kDiameter},
    {"penetration", Kind::kPenetration},
    // Plain words.
    {"gap", Kind::kGamma1},
    {"reach", Kind::kGamma2},
    {"margin", Kind::kEta1, false, true},
    {"cover", Kind::kDelta1, false, true},
    {"protrusion", Kind::kMu},
    {"distance", Kind::kD1},
    {"depth", Kind::kPenetration},
    // The names of older region files.
    {"m1", Kind::kMu},
    {"m2", Kind::kMu, true},
    {"m3", Kind::kHausdorff},
    {"hBA", Kind::kH},
    {"hAB", Kind::kH, true},
    {"H", Kind::kHausdorff},
    {"diam_union", Kind::kDiameter},
}};

constexpr std::size_t kPlainCount = 7;  // of the rows above

using NameLevel = PredicateName::Level;
constexpr std::array<PredicateName, 11> kPredicates{{
    {"overlaps", Kind::kGamma1, Relation::kLess, NameLevel::kNone, false},
    {"touches", Kind::kGamma1, Relation::kEqual, NameLevel::kNone, false},
    {"disjoint", Kind::kGamma1, Relation::kGreater, NameLevel::kNone, false},
    {"clear", Kind::kGamma1, Relation::kGreaterEqual, NameLevel::kOptional, false},
    {"within", Kind::kGamma1, Relation::kLessEqual, NameLevel::kRequired, false},
    {"far", Kind::kGamma1, Relation::kGreaterEqual, NameLevel::kRequired, false},
    {"near", Kind::kGamma1, Relation::kLessEqual, NameLevel::kRequired, false},
    {"keepout", Kind::kGamma1, Relation::kGreaterEqual, NameLevel::kOptional, false},
    {"group", Kind::kDiameter, Relation::kLessEqual, NameLevel::kRequired, false},
    {"inside", Kind::kEta1, Relation::kLessEqual, NameLevel::kOptional, true},
    {"covers", Kind::kDelta1, Relation::kLessEqual, NameLevel::kOptional, true},
}};

constexpr std::array<std::string_view, kKindCount> kSymbols{
    "γ₁", "γ₂", "η₁", "η₂", "δ₁", "δ₂", "μ", "hausdorff", "d1", "d2", "h", "dstar", "diameter", "penetration"};

/// Greek letters and subscript digits spelled in ASCII; all else unchanged.
std::string spelled_out(std::string_view word) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 15> kSigns{{
      {"γ", "gamma"},
      {"η", "eta"},
      {"δ", "delta"},
      {"\u03bc", "mu"},
      {"\u00b5", "mu"},
      {"₀", "0"},
      {"₁", "1"},
      {"₂", "2"},
      {"₃", "3"},
      {"₄", "4"},
      {"₅", "5"},
      {"₆", "6"},
      {"₇", "7"},
      {"₈", "8"},
      {"₉", "9"},
  }};
  std::string result;
  while (!word.empty()) {
    const auto sign =
        std::find_if(kSigns.begin(), kSigns.end(), [&](const auto& s) { return word.starts_with(s.first); });
    const bool found = sign != kSigns.end();
    result += found ? sign->second : word.substr(0, 1);
    word.remove_prefix(found ? sign->first.size() : 1);
  }
  return result;
}

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

/// Optimal string alignment distance (Damerau-Levenshtein without repeated edits of one place), by bytes.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), previous(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before.swap(previous);
    previous.swap(row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const char x = lower(a[i - 1]), y = lower(b[j - 1]);
      row[j] = std::min({previous[j] + 1, row[j - 1] + 1, previous[j - 1] + (x == y ? 0 : 1)});
      if (i > 1 && j > 1 && x == lower(b[j - 2]) && y == lower(a[i - 2])) row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row[b.size()];
}

}  // namespace

Relation mirrored(Relation relation) {
  switch (relation) {
    case Relation::kLess:
      return Relation::kGreater;
    case Relation::kLessEqual:
      return Relation::kGreaterEqual;
    case Relation::kGreaterEqual:
      return Relation::kLessEqual;
    case Relation::kGreater:
      return Relation::kLess;
    case Relation::kEqual:
    case Relation::kNotEqual:
      break;
  }
  return relation;
}

std::span<const DistanceName> distance_names() { return kDistances; }
std::span<const PredicateName> predicate_names() { return kPredicates; }

const DistanceName* find_distance(std::string_view word) {
  const std::string spelled = spelled_out(word);
  const auto row = std::find_if(kDistances.begin(), kDistances.end(), [&](const auto& d) { return d.name == spelled; });
  return row == kDistances.end() ? nullptr : &*row;
}

const PredicateName* find_predicate(std::string_view word) {
  const auto row = std::find_if(kPredicates.begin(), kPredicates.end(), [&](const auto& p) { return p.name == word; });
  return row == kPredicates.end() ? nullptr : &*row;
}

const DistanceName& plain_name(Kind kind) {
  const auto first = kDistances.begin() + kKindCount;
  const auto row = std::find_if(first, first + kPlainCount, [&](const auto& d) { return d.kind == kind; });
  return row == first + kPlainCount ? kDistances[static_cast<std::size_t>(kind)] : *row;
}

std::string_view name(Kind kind) { return kDistances[static_cast<std::size_t>(kind)].name; }
std::string_view symbol(Kind kind) { return kSymbols[static_cast<std::size_t>(kind)]; }

bool is_symmetric(Kind kind) {
  switch (kind) {
    case Kind::kGamma1:
    case Kind::kGamma2:
    case Kind::kHausdorff:
    case Kind::kD1:
    case Kind::kD2:
    case Kind::kDiameter:
    case Kind::kPenetration:
      return true;
    default:
      return false;
  }
}

bool is_directional(Kind kind) { return kind <= Kind::kDelta2; }

std::string nearest(std::string_view word, std::span<const std::string> candidates) {
  // A third of the letters may be wrong: beyond that the question confuses more than it helps. Long words are not
  // names mistyped, and would make the search quadratic in the size of the input.
  constexpr std::size_t kLongest = 64;
  if (word.size() > kLongest) return {};
  std::size_t least = std::max<std::size_t>(1, word.size() / 3) + 1;
  std::string best;
  for (const std::string& candidate : candidates) {
    if (candidate.size() > kLongest) continue;
    const std::size_t distance = edit_distance(word, candidate);
    // A word of which every letter is wrong is not near, however short.
    if (distance < least && distance < std::max(word.size(), candidate.size())) {
      least = distance;
      best = candidate;
    }
  }
  return best;
}

}  // namespace findspace::formula
