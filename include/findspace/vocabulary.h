// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The words of the formula language (docs/formula.md), for completions, help and messages. Guarantee: every word that a
// formula may use for a distance, a predicate or a unit is here. Cost: that of copying them. Source: Pustylnik,
// arXiv:0808.2931, for the distances and their letters. Keywords: keyword, synonym, did you mean, edit distance.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace findspace {

/// One word for a distance.
struct DistanceWord {
  /// "gap", "gamma1".
  std::string word;
  /// The word of the literature for what it is: "gamma1".
  std::string distance;
  /// Its letter there, "γ₁", or the word where it has none.
  std::string symbol;
  /// Its value is that of the distance with the shapes exchanged.
  bool exchanged = false;
  /// Its value is minus that of the distance.
  bool negated = false;
  /// Whether along=, toward= and rotating= are defined for it.
  bool directional = false;
};

/// One word for a predicate: a distance of its two shapes compared with a level.
struct PredicateWord {
  /// "clear".
  std::string word;
  /// The word of the literature: "gamma1".
  std::string distance;
  /// How it is compared: "<" "<=" "=" "!=" ">=" ">".
  std::string relation;
  /// Whether a level is the third argument; 0 where there is none, or it is left out.
  enum class Level { kNone, kOptional, kRequired };
  /// Of it.
  Level level = Level::kNone;
  /// Whether it is compared with minus the level.
  bool negated = false;
};

/// All words for distances; those of the literature come first, one a distance.
std::vector<DistanceWord> distance_words();
/// Those that most people ask for: `measure` prints them first.
std::vector<std::string> usual_distance_words();
/// All words for predicates.
std::vector<PredicateWord> predicate_words();
/// Of lengths: "um", "mm", and so on.
std::vector<std::string> unit_words();
/// The candidate that was probably meant, by edit distance; empty where none is near enough to be worth a question.
std::string nearest_word(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace findspace
