// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "formula/language/parse.h"

#include <algorithm>
#include <utility>

#include "formula/language/parse_reader.h"
#include "formula/language/text.h"

namespace findspace::formula {
namespace {

using K = Token::Kind;
using Op = Node::Op;

Quantity quantity(const Distance& distance) {
  return distance.mode == Mode::kRotation ? Quantity::kAngle : Quantity::kLength;
}

/// Recursive descent over `formula`; one member function for each rule.
class Grammar {
 public:
  Grammar(std::string_view text, const Context& context) : reader_(text, context) {
    // Every atom has a '(' and at least so many letters: "h(B,A)<0".
    constexpr std::size_t kShortest = 8;
    atoms_.reserve(
        std::min<std::size_t>(std::size_t(std::count(text.begin(), text.end(), '(')), text.size() / kShortest));
  }

  Formula formula() {
    if (reader_.at(K::kEnd)) reader_.fail_syntax("the formula is empty; a condition is meant, or true");
    Node root = disjunction();
    if (!reader_.at(K::kEnd)) fail_after_condition(nullptr);
    return Formula(std::move(root), std::move(atoms_));
  }

 private:
  Node disjunction() {
    Node node{Op::kOr, 0, {}};
    do node.operands.push_back(conjunction());
    while (reader_.accept(K::kOr) || reader_.accept_word("or"));
    return node;
  }

  Node conjunction() {
    Node node{Op::kAnd, 0, {}};
    do node.operands.push_back(negation());
    while (reader_.accept(K::kAnd) || reader_.accept_word("and"));
    return node;
  }

  Node negation() {
    const Span start = reader_.peek().span;
    check_depth(++depth_);
    Node node;
    if (reader_.accept(K::kNot) || reader_.accept_word("not")) {
      node = Node{Op::kNot, 0, {}};
      node.operands.push_back(negation());
    } else if (reader_.accept(K::kOpen)) {
      node = disjunction();
      if (!reader_.at(K::kClose)) fail_after_condition(&start);
      reader_.take();
    } else {
      node = atom();
    }
    --depth_;
    return node;
  }

  Node atom() {
    if (reader_.at_number()) return number_first();
    if (!reader_.at(K::kName)) reader_.fail_syntax("a condition is meant here, found {}", reader_.found());
    for (const char* word : {"and", "or"}) {
      if (reader_.at_word(word)) reader_.fail_syntax("a condition is meant here, found '{}'", word);
    }
    if (reader_.accept_word("true")) return Node{Op::kTrue, 0, {}};
    if (reader_.accept_word("false")) return Node{Op::kFalse, 0, {}};
    if (reader_.at_word("argmin")) return argmin();
    if (find_predicate(reader_.peek().text) != nullptr) return predicate();
    return distance_first();
  }

  void check_depth(int depth) const {
    if (depth > kDeepest) reader_.fail_syntax("parentheses and negations nested too deeply");
  }

  Node add(Atom atom) {
    atoms_.push_back(std::move(atom));
    return Node{Op::kAtom, atoms_.size() - 1, {}};
  }

  /// -f R l is f mirrored(R) -l.
  Atom comparison(Term term, Relation relation, Number number) {
    if (term.negated) {
      relation = mirrored(relation);
      number.negative = !number.negative;
    }
    Level level = reader_.level(number, quantity(term.distance));
    return compare(std::move(term.distance), relation, std::move(level.value), std::move(level.written));
  }

  Node number_first() {
    const Number number = reader_.number();
    if (!reader_.at(K::kRelation)) {
      reader_.fail_syntax("a relation (< <= = != >= >) is meant after the number, found {}", reader_.found());
    }
    const Relation relation = reader_.take().relation;
    if (reader_.at_number())
      reader_.fail_syntax("a distance is meant here, found a number; two numbers are not compared");
    if (!reader_.at(K::kName)) reader_.fail_syntax("a distance is meant here, found {}", reader_.found());
    const Term term = reader_.distance();
    Node first = add(comparison(term, mirrored(relation), number));
    if (!reader_.at(K::kRelation)) return first;
    // Written out, a chain under `not` needs parentheses, and that has to be readable too.
    check_depth(depth_ + 1);
    const Relation upper = reader_.take().relation;
    Node node{Op::kAnd, 0, {}};
    node.operands.push_back(std::move(first));
    node.operands.push_back(add(comparison(term, upper, level_number())));
    if (reader_.at(K::kRelation)) reader_.fail_syntax("a chain has two relations at most: 0.5 <= gap(B, A) <= 2");
    return node;
  }

  Node distance_first() {
    Term term = reader_.distance();
    if (reader_.at(K::kArrow)) {
      reader_.take();
      if (!reader_.accept_word("min")) reader_.fail_syntax("only 'min' may follow '->', found {}", reader_.found());
      return minimum(term);
    }
    if (!reader_.at(K::kRelation)) {
      reader_.fail(ErrorCode::kSyntax, term.span, "a distance is a number, not a condition; compare it, e.g. {} >= 0",
                   written(term.distance));
    }
    const Relation relation = reader_.take().relation;
    Node node = add(comparison(std::move(term), relation, level_number()));
    if (reader_.at(K::kRelation)) {
      reader_.fail_syntax("a chain has its distance in the middle: 0.5 <= gap(B, A) <= 2");
    }
    return node;
  }

  /// The number on the right side of a relation.
  Number level_number() {
    if (reader_.at_distance()) {
      reader_.fail_syntax(
          "a distance is compared with a number, not with another distance; compare each with a number");
    }
    return reader_.number();
  }

  Node minimum(const Term& term) {
    if (term.negated) {
      reader_.fail(ErrorCode::kBadValue, term.span,
                   "'{}' has no least value; the positions of its greatest value are {} -> min",
                   term.distance.spelled->name, text(term.distance));
    }
    return add(minimisers(term.distance));
  }

  Node argmin() {
    reader_.take();
    const Span open = reader_.peek().span;
    if (!reader_.accept(K::kOpen) || !reader_.at(K::kName)) {
      reader_.fail_syntax("'argmin' takes a distance: argmin(gap(B, A)), found {}", reader_.found());
    }
    const Term term = reader_.distance();
    if (!reader_.accept(K::kClose)) reader_.fail_unclosed(open);
    return minimum(term);
  }

  Node predicate() {
    const std::string_view word = find_predicate(reader_.peek().text)->name;
    Node node = add(reader_.predicate());
    if (reader_.at(K::kRelation) || reader_.at(K::kArrow)) {
      reader_.fail_syntax("'{}' is true or false; it is not compared with anything", word);
    }
    return node;
  }

  /// Fails at a token that cannot follow a condition; `open` is the '(' to be closed, if there is one.
  [[noreturn]] void fail_after_condition(const Span* open) {
    if (reader_.at(K::kEnd)) reader_.fail_unclosed(*open);
    if (reader_.at(K::kClose)) reader_.fail_syntax("this ')' closes nothing");
    if (reader_.at(K::kComma) && reader_.peek(1).kind == K::kNumber) {
      reader_.fail_syntax("unexpected ','; decimals are written with a point");
    }
    std::string question;
    if (reader_.at(K::kName)) {
      const std::vector<std::string> connectives{"and", "or"};
      question = Reader::question(reader_.peek().text, connectives);
    }
    const char* const meant = open == nullptr ? "'and' or 'or'" : "'and', 'or' or ')'";
    reader_.fail_syntax("{} is meant here, found {}{}", meant, reader_.found(), question);
  }

  Reader reader_;
  std::vector<Atom> atoms_;
  int depth_ = 0;
};

/// x, y or z alone.
bool read_coordinate(Reader& reader, Objective& objective) {
  if (reader.peek(1).kind != K::kEnd) return false;
  if (reader.at_word("x")) {
    objective.kind = Objective::Kind::kX;
  } else if (reader.at_word("y")) {
    objective.kind = Objective::Kind::kY;
  } else if (reader.at_word("z")) {
    if (reader.context().dimension < 3) {
      reader.fail(ErrorCode::kBadValue, reader.peek().span, "'z' is an objective in 3 dimensions; the scene has 2");
    }
    objective.kind = Objective::Kind::kZ;
  } else {
    return false;
  }
  reader.take();
  return true;
}

/// distance to [x, y].
bool read_point(Reader& reader, Objective& objective) {
  if (!reader.at_word("distance") || !reader.at_word("to", 1)) return false;
  reader.take();
  reader.take();
  if (!reader.accept(K::kOpenBracket)) {
    reader.fail_syntax("a point such as [1, 2] is meant after 'distance to', found {}", reader.found());
  }
  objective.kind = Objective::Kind::kDistanceToPoint;
  objective.point = reader.coordinates(Quantity::kLength, K::kCloseBracket, objective.point_text);
  objective.point_text = "[" + objective.point_text + "]";
  return true;
}

}  // namespace

Formula parse_formula(std::string_view text, const Context& context) { return Grammar(text, context).formula(); }

Objective parse_objective(std::string_view text, const Context& context) {
  static constexpr char kForms[] =
      "an objective is a distance such as gap(B, A), x, y, z or distance to [x, y]; found {}";
  Reader reader(text, context);
  Objective objective;
  if (!read_coordinate(reader, objective) && !read_point(reader, objective)) {
    if (!reader.at(K::kName)) reader.fail_syntax(kForms, reader.found());
    Term term = reader.distance();
    objective.distance = std::move(term.distance);
    objective.negated = term.negated;
  }
  if (!reader.at(K::kEnd)) reader.fail_syntax(kForms, reader.found());
  return objective;
}

}  // namespace findspace::formula
