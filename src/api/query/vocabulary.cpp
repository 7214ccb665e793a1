// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "findspace/vocabulary.h"

#include <array>

#include "formula/language/names.h"
#include "formula/language/units.h"

namespace findspace {
namespace {

std::string sign(formula::Relation relation) {
  constexpr std::array<const char*, 6> kSigns{"<", "<=", "=", "!=", ">=", ">"};
  return kSigns[std::size_t(relation)];
}

}  // namespace

std::vector<DistanceWord> distance_words() {
  std::vector<DistanceWord> out;
  for (const formula::DistanceName& row : formula::distance_names())
    out.push_back({std::string(row.name), std::string(formula::name(row.kind)), std::string(formula::symbol(row.kind)),
                   row.exchanged, row.negated, formula::is_directional(row.kind)});
  return out;
}

std::vector<PredicateWord> predicate_words() {
  using Level = PredicateWord::Level;
  static_assert(int(formula::PredicateName::Level::kRequired) == int(Level::kRequired));
  std::vector<PredicateWord> out;
  for (const formula::PredicateName& row : formula::predicate_names())
    out.push_back({std::string(row.name), std::string(formula::name(row.kind)), sign(row.relation),
                   Level(int(row.level)), row.negated});
  return out;
}

std::vector<std::string> unit_words() { return {formula::kUnitNames.begin(), formula::kUnitNames.end()}; }

std::string nearest_word(std::string_view word, const std::vector<std::string>& candidates) {
  return formula::nearest(word, candidates);
}

}  // namespace findspace
