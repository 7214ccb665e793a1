// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The words of formulas through the public headers: each can be used.

#include <gtest/gtest.h>

#include <limits>

#include "findspace/vocabulary.h"
#include "findspace/world.h"

namespace io_public_vocabulary {

using namespace findspace;

constexpr double kInfinity = std::numeric_limits<double>::infinity();  // of what is undefined

World two_boxes() {
  return World({{"A", Shape::box({0, 0}, {4, 4})}, {"B", Shape::box({0, 0}, {1, 1})}}, "B", {.unit = "mm"});
}

TEST(PublicVocabulary, EveryDistanceHasItsValue) {
  const World world = two_boxes();
  const std::vector<DistanceWord> words = distance_words();
  EXPECT_EQ(words[0].word, "gamma1");
  EXPECT_EQ(words[0].symbol, "γ₁");
  for (const DistanceWord& word : words) {
    const Point at{9, 1};
    const std::string pair = word.exchanged ? "(A, B)" : "(B, A)";
    const DistanceValue said = world.distance(word.word + "(B, A)", at),
                        meant = world.distance(word.distance + pair, at);
    const double sign = word.negated ? -1 : 1;
    EXPECT_EQ(said.value.value_or(kInfinity), sign * meant.value.value_or(kInfinity)) << word.word;
    if (!word.directional) continue;
    EXPECT_NO_THROW(world.distance(word.word + "(B, A, along=(1, 0))", at)) << word.word;
  }
}

TEST(PublicVocabulary, EveryPredicateIsAComparison) {
  const World world = two_boxes();
  for (const PredicateWord& word : predicate_words()) {
    const bool level = word.level != PredicateWord::Level::kNone;
    const Formula said = word.word + (level ? "(B, A, 2)" : "(B, A)");
    const Formula meant = word.distance + "(B, A) " + word.relation + (!level ? " 0" : word.negated ? " -2" : " 2");
    for (const Point& at : {Point{1, 1}, Point{3, 1}, Point{4, 1}, Point{6, 1}, Point{9, 1}})
      EXPECT_EQ(world.holds(said, at), world.holds(meant, at)) << said.text() << " and " << meant.text();
  }
}

TEST(PublicVocabulary, UnitsAndWhatWasMeant) {
  for (const std::string& unit : unit_words())
    EXPECT_NO_THROW(two_boxes().holds("gap(B, A) >= 1 " + unit, Point{9, 1}));
  EXPECT_EQ(nearest_word("gapp", {"reach", "gap"}), "gap");
  EXPECT_EQ(nearest_word("something", {"reach", "gap"}), "");
}

}  // namespace io_public_vocabulary
