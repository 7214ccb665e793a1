// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Laws of the formula language under random sentences:
//   reading what was written gives the same formula, in either script;
//   a sentence is true for given values of the distances exactly if its formula is true for their signs;
//   and, or, not are those of Boolean algebra;
//   a damaged sentence is either a sentence or an Error with place and caret.
// The sentences come from a seeded generator that says, apart from the parser, what each one means.
#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <random>
#include <regex>

#include "formula/language/evaluate.h"
#include "formula/language/parse.h"
#include "formula/language/text.h"

namespace findspace::formula {
namespace formula_formula {

Context scene() {
  return {.shapes = {"A", "A1", "A2", "B", "my part"},
          .moving = {"B"},
          .extra = {},
          .independent = false,
          .motion = true,
          .unit = Unit::kMillimetre,
          .dimension = 2};
}

/// Values of the distances in hundredths of a millimetre, by canonical text.
using Values = std::map<std::string, int>;

struct Sentence {
  std::string text;
  std::function<bool(const Values&)> truth;
};

bool compare_integers(int a, Relation relation, int b) {
  switch (relation) {
    case Relation::kLess:
      return a < b;
    case Relation::kLessEqual:
      return a <= b;
    case Relation::kEqual:
      return a == b;
    case Relation::kNotEqual:
      return a != b;
    case Relation::kGreaterEqual:
      return a >= b;
    case Relation::kGreater:
      return a > b;
  }
  return false;
}

class Generator {
 public:
  explicit Generator(std::uint64_t seed) : random_(seed) {}

  std::size_t below(std::size_t count) { return static_cast<std::size_t>(random_() % count); }
  bool chance(std::size_t one_in) { return below(one_in) == 0; }

  Sentence formula(int depth) {
    if (depth == 0 || chance(4)) return atom();
    switch (below(4)) {
      case 0: {
        const Sentence inner = formula(depth - 1);
        return {(chance(2) ? "not (" : "¬(") + inner.text + ")", [inner](const Values& v) { return !inner.truth(v); }};
      }
      case 1: {
        const Sentence inner = formula(depth - 1);
        return {"(" + inner.text + ")", inner.truth};
      }
      default:
        return chain_of(depth);
    }
  }

  /// a and b or c ...: `and` binds more tightly.
  Sentence chain_of(int depth) {
    std::vector<std::vector<Sentence>> groups(1);
    std::string text;
    for (std::size_t i = 0, count = 2 + below(3); i < count; ++i) {
      const bool either = i > 0 && chance(2);
      if (i > 0) text += either ? (chance(2) ? " or " : "∨") : (chance(2) ? " and " : "∧");
      if (either) groups.emplace_back();
      Sentence part = formula(depth - 1);
      part.text = "(" + part.text + ")";
      if (chance(2)) part = atom();
      text += part.text;
      groups.back().push_back(part);
    }
    return {text, [groups](const Values& v) {
              return std::any_of(groups.begin(), groups.end(), [&](const auto& group) {
                return std::all_of(group.begin(), group.end(), [&](const Sentence& s) { return s.truth(v); });
              });
            }};
  }

  Sentence atom() {
    switch (below(8)) {
      case 0:
        return {"true", [](const Values&) { return true; }};
      case 1:
        return minimum();
      case 2:
      case 3:
        return predicate();
      case 4:
        return chained();
      default:
        return comparison();
    }
  }

 private:
  struct Word {
    std::string written, key;  // as the sentence has it, as the values have it
    int factor;                // -1 for margin
  };

  Word distance() {
    static const std::vector<std::tuple<std::string, std::string, bool, int>> kWords{
        {"gamma1", "gamma1", false, 1}, {"gap", "gamma1", false, 1},   {"γ₁", "gamma1", false, 1},
        {"eta1", "eta1", false, 1},     {"margin", "eta1", false, -1}, {"δ2", "delta2", false, 1},
        {"mu", "mu", false, 1},         {"m2", "mu", true, 1},         {"reach", "gamma2", false, 1},
        {"H", "hausdorff", false, 1},   {"dstar", "dstar", false, 1}};
    static const std::vector<std::pair<std::string, std::string>> kFixed{{"A", "A"},
                                                                         {"\"A\"", "A"},
                                                                         {"A1+A2", "A1+A2"},
                                                                         {"A1 + 'my part'", "A1+\"my part\""},
                                                                         {"'my part'", "\"my part\""}};
    const auto& [word, name, exchanged, factor] = kWords[below(kWords.size())];
    std::pair<std::string, std::string> first{"B", "B"}, second = kFixed[below(kFixed.size())];
    if (chance(4)) std::swap(first, second);
    std::string mode;
    const bool directional = name == "gamma1" || name == "eta1" || name == "delta2" || name == "gamma2";
    if (directional && chance(5)) mode = chance(2) ? ", along=(1, 0)" : ", toward=(-0.5, 2)";
    std::string prefix, opposite;
    if (chance(6)) {
      prefix = chance(2) ? "inf " : "sup ";
      opposite = factor > 0 ? prefix : prefix == "inf " ? "sup " : "inf ";
    }
    const std::string key = opposite + name + "(" +
                            (exchanged ? second.second + ", " + first.second : first.second + ", " + second.second) +
                            mode + ")";
    return {prefix + word + (chance(2) ? "(" : " ( ") + first.first + "," + second.first + mode + ")", key, factor};
  }

  struct Level {
    std::string written;
    int hundredths;
  };

  Level level() {
    const int value = static_cast<int>(below(9)) - 4;
    switch (below(5)) {
      case 0:
        return {std::to_string(value) + (chance(2) ? "" : "mm"), 100 * value};
      case 1:
        return {std::to_string(value) + "cm", 1000 * value};
      case 2:
        return {std::to_string(value) + "0um", value};
      case 3:
        return {(value < 0 ? "−.0" : "+0.0") + std::to_string(std::abs(value)), value};
      default:
        return {std::to_string(value) + "e-1", 10 * value};
    }
  }

  Relation relation() { return static_cast<Relation>(below(6)); }
  std::string written(Relation r) { return text(r, chance(2) ? Script::kAscii : Script::kSymbols); }

  Sentence comparison() {
    const Word d = distance();
    const Level l = level();
    const Relation r = relation();
    const bool number_first = chance(3);
    const auto truth = [d, l, r, number_first](const Values& v) {
      const int value = d.factor * v.at(d.key);
      return number_first ? compare_integers(l.hundredths, r, value) : compare_integers(value, r, l.hundredths);
    };
    const std::string sign = written(r);
    return {number_first ? l.written + " " + sign + d.written : d.written + sign + l.written, truth};
  }

  Sentence chained() {
    const Word d = distance();
    const Level low = level(), high = level();
    const Relation r = relation(), s = relation();
    return {low.written + written(r) + d.written + written(s) + high.written, [=](const Values& v) {
              const int value = d.factor * v.at(d.key);
              return compare_integers(low.hundredths, r, value) && compare_integers(value, s, high.hundredths);
            }};
  }

  Sentence predicate() {
    const Level l = level();
    switch (below(6)) {
      case 0:
        return {"overlaps(B, A)", [](const Values& v) { return v.at("gamma1(B, A)") < 0; }};
      case 1:
        return {"touches(A, B)", [](const Values& v) { return v.at("gamma1(A, B)") == 0; }};
      case 2:
        return {"inside(B, A)", [](const Values& v) { return v.at("eta1(B, A)") <= 0; }};
      case 3:
        return {"inside(B, A, " + l.written + ")",
                [l](const Values& v) { return v.at("eta1(B, A)") <= -l.hundredths; }};
      case 4:
        return {"clear(B, A, " + l.written + ")",
                [l](const Values& v) { return v.at("gamma1(B, A)") >= l.hundredths; }};
      default:
        return {"covers(B, A, " + l.written + ")",
                [l](const Values& v) { return v.at("delta1(B, A)") <= -l.hundredths; }};
    }
  }

  /// The global minimum of every distance is taken to be -1000.
  Sentence minimum() {
    Word d = distance();
    while (d.factor < 0) d = distance();
    return {chance(2) ? "argmin(" + d.written + ")" : d.written + "→min",
            [d](const Values& v) { return v.at(d.key) == -1000; }};
  }

  std::mt19937_64 random_;
};

/// Random values for all distances of a formula, near the levels that occur.
Values values_for(const Formula& formula, Generator& generator) {
  static const int kValues[] = {-4000, -1000, -400, -300, -40, -4, -1, 0, 1, 3, 20, 100, 400, 3000};
  Values values;
  for (const SignMap& map : formula.sign_maps()) {
    values.emplace(text(map.distance), kValues[generator.below(std::size(kValues))]);
  }
  return values;
}

std::vector<std::int8_t> signs_of(const Formula& formula, const Values& values) {
  std::vector<std::int8_t> signs;
  for (const SignMap& map : formula.sign_maps()) {
    const int value = values.at(text(map.distance));
    const int sign = map.minimum ? (value != -1000) : (exact::Real::ratio(value, 100) - map.level).sign();
    signs.push_back(static_cast<std::int8_t>(sign));
  }
  return signs;
}

TEST(FormulaLaw, WrittenAndReadAgainIsTheSame) {
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    const std::string sentence = Generator(seed).formula(4).text;
    const Formula formula = parse_formula(sentence, scene());
    const std::string canonical = text(formula), symbols = text(formula, Script::kSymbols);
    EXPECT_EQ(parse_formula(canonical, scene()), formula) << seed << ": " << sentence;
    EXPECT_EQ(parse_formula(symbols, scene()), formula) << seed << ": " << symbols;
    EXPECT_EQ(text(parse_formula(symbols, scene())), canonical) << seed;
  }
}

TEST(FormulaLaw, WrittenAndReadAgainInInches) {
  Context inches = scene();
  inches.unit = Unit::kInch;  // most metric levels have no finite decimal then
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    const Formula formula = parse_formula(Generator(seed).formula(3).text, inches);
    EXPECT_EQ(parse_formula(text(formula), inches), formula) << text(formula);
    EXPECT_EQ(text(parse_formula(text(formula), inches)), text(formula));
  }
}

TEST(FormulaLaw, TruthIsThatOfTheSentence) {
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    Generator generator(seed);
    const Sentence sentence = generator.formula(4);
    const Formula formula = parse_formula(sentence.text, scene());
    for (int round = 0; round < 8; ++round) {
      const Values values = values_for(formula, generator);
      ASSERT_EQ(evaluate(formula, signs_of(formula, values)), sentence.truth(values)) << seed << ": " << sentence.text;
    }
  }
}

TEST(FormulaLaw, BooleanAlgebra) {
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    Generator generator(seed);
    const Formula f = parse_formula(generator.formula(3).text, scene());
    const Formula g = parse_formula(generator.formula(3).text, scene());
    const Formula pair[] = {f, g}, negated[] = {negation(f), negation(g)};
    const Formula both = conjunction(pair), either = disjunction(pair), de_morgan = negation(disjunction(negated));
    for (int round = 0; round < 8; ++round) {
      Values values = values_for(both, generator);
      const bool a = evaluate(f, signs_of(f, values)), b = evaluate(g, signs_of(g, values));
      EXPECT_EQ(evaluate(both, signs_of(both, values)), a && b);
      EXPECT_EQ(evaluate(either, signs_of(either, values)), a || b);
      EXPECT_EQ(evaluate(de_morgan, signs_of(de_morgan, values)), a && b);
      EXPECT_EQ(evaluate(negated[0], signs_of(negated[0], values)), !a);
    }
  }
}

TEST(FormulaLaw, DamagedSentencesAreSentencesOrErrors) {
  static const std::string kBytes = "()<>=!-+,.\"'019aBγ∧≤ \n\t\xff\x01[]e";
  const std::regex place("[0-9]+:[0-9]+");
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    Generator generator(seed);
    std::string sentence = generator.formula(2).text;
    for (std::size_t edits = 1 + generator.below(3); edits > 0 && !sentence.empty(); --edits) {
      const std::size_t at = generator.below(sentence.size());
      if (generator.chance(2)) {
        sentence.erase(at, 1 + generator.below(4));
      } else {
        sentence.insert(at, 1, kBytes[generator.below(kBytes.size())]);
      }
    }
    try {
      const Formula formula = parse_formula(sentence, scene());
      EXPECT_EQ(parse_formula(text(formula), scene()), formula);
    } catch (const Error& error) {
      EXPECT_TRUE(std::regex_match(error.place(), place)) << error.what();
      EXPECT_NE(error.message().find("^"), std::string::npos) << error.what();
    }
  }
}

}  // namespace formula_formula
}  // namespace findspace::formula
