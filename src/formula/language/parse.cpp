// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "formula/language/parse.h"

#include <algorithm>
#include <utility>

#include "formula/language/condition_work.h"
#include "formula/language/evaluate.h"
#include "formula/language/parse_call.h"
#include "formula/language/parse_number.h"
#include "formula/language/parse_sum.h"
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
  Grammar(std::string_view text, const Context& context) : context_(context), cursor_(text), calls_(cursor_, context) {
    // Every atom has a '(' and at least so many letters: "h(B,A)<0".
    constexpr std::size_t kShortest = 8;
    atoms_.reserve(
        std::min<std::size_t>(std::size_t(std::count(text.begin(), text.end(), '(')), text.size() / kShortest));
  }

  Formula formula() {
    if (cursor_.at(K::kEnd)) cursor_.fail_syntax("the formula is empty; a condition is meant, or true");
    Node root = disjunction();
    if (!cursor_.at(K::kEnd)) fail_after_condition(nullptr);
    return Formula(std::move(root), std::move(atoms_));
  }

 private:
  Node disjunction() {
    Node node{Op::kOr, 0, {}};
    do node.operands.push_back(conjunction());
    while (cursor_.accept(K::kOr) || cursor_.accept_word("or"));
    return node;
  }

  Node conjunction() {
    Node node{Op::kAnd, 0, {}};
    do node.operands.push_back(negation());
    while (cursor_.accept(K::kAnd) || cursor_.accept_word("and"));
    return node;
  }

  Node negation() {
    const Span start = cursor_.peek().span;
    check_depth(++depth_);
    Node node;
    if (cursor_.accept(K::kNot) || cursor_.accept_word("not")) {
      node = Node{Op::kNot, 0, {}};
      node.operands.push_back(negation());
    } else if (cursor_.at(K::kOpen) && !at_number_in_parentheses(cursor_)) {
      cursor_.take();
      node = disjunction();
      if (!cursor_.at(K::kClose)) fail_after_condition(&start);
      cursor_.take();
    } else {
      node = atom();
    }
    --depth_;
    return node;
  }

  Node atom() {
    if (at_arithmetic(cursor_)) return at_negated_distance() ? distance_first() : number_first();
    if (!cursor_.at(K::kName)) cursor_.fail_syntax("a condition is meant here, found {}", cursor_.found());
    for (const char* word : {"and", "or"}) {
      if (cursor_.at_word(word)) cursor_.fail_syntax("a condition is meant here, found '{}'", word);
    }
    if (cursor_.accept_word("true")) return Node{Op::kTrue, 0, {}};
    if (cursor_.accept_word("false")) return Node{Op::kFalse, 0, {}};
    if (cursor_.at_word("argmin")) return argmin();
    if (find_predicate(cursor_.peek().text) != nullptr) return predicate();
    if (calls_.at_between()) return between();
    return distance_first();
  }

  /// -gap(B, A)
  bool at_negated_distance() const {
    return (cursor_.at(K::kMinus) || cursor_.at(K::kPlus)) && cursor_.peek(1).kind == K::kName;
  }

  /// between(G, H) >= number: true where neither list has a shape that moves. Of several gaps the least is meant.
  Node between() {
    std::vector<Term> terms = calls_.between();
    if (!cursor_.at(K::kRelation))
      cursor_.fail_syntax("a relation is meant after 'between': between(G, H) >= 0.2, found {}", cursor_.found());
    const Relation relation = cursor_.take().relation;
    const Number number = level_number();
    if (terms.empty()) return Node{Op::kTrue, 0, {}};
    const bool all = relation == Relation::kGreater || relation == Relation::kGreaterEqual;
    if (terms.size() > 1 && !all && relation != Relation::kLess && relation != Relation::kLessEqual)
      cursor_.fail(ErrorCode::kUnsupported, terms.front().span,
                   "'between' takes < <= >= > where it stands for several gaps");
    Node out{all ? Op::kAnd : Op::kOr, 0, {}};
    for (Term& term : terms) out.operands.push_back(add(comparison(std::move(term), relation, number)));
    return terms.size() == 1 ? Node(out.operands.front()) : out;
  }

  /// A distance to the empty set: +infinity.
  Node of_nothing(const Atom& atom) {
    const Kind kind = atom.distance.kind;
    if (atom.minimum || (kind != Kind::kGamma1 && kind != Kind::kD1 && kind != Kind::kEta1) ||
        (kind == Kind::kEta1 && !atom.distance.second.empty()))
      cursor_.fail_syntax("this distance to an empty list is not defined; those of gap, distance and margin are");
    return Node{holds(atom, 1) ? Op::kTrue : Op::kFalse, 0, {}};
  }

  void check_depth(int depth) const {
    if (depth > kDeepest) cursor_.fail_syntax("parentheses and negations nested too deeply");
  }

  Node add(Atom atom) {
    if (atom.distance.first.empty() || atom.distance.second.empty()) return of_nothing(atom);
    atoms_.push_back(std::move(atom));
    return Node{Op::kAtom, atoms_.size() - 1, {}};
  }

  /// -f R l is f mirrored(R) -l.
  Atom comparison(Term term, Relation relation, Number number) {
    if (term.negated) {
      relation = mirrored(relation);
      number = negated(std::move(number));
    }
    Level level = level_of(cursor_, context_, number, quantity(term.distance));
    return compare(std::move(term.distance), relation, std::move(level.value), std::move(level.written));
  }

  Node number_first() {
    const Number number = read_number(cursor_);
    if (cursor_.at(K::kTimes) || cursor_.at(K::kPlus) || cursor_.at(K::kMinus))
      return sum_first(read_sum(cursor_, context_, calls_, number));
    if (!cursor_.at(K::kRelation)) {
      cursor_.fail_syntax("a relation (< <= = != >= >) is meant after the number, found {}", cursor_.found());
    }
    const Relation relation = cursor_.take().relation;
    const Sum middle = read_sum(cursor_, context_, calls_);
    if (middle.terms.empty())
      cursor_.fail(ErrorCode::kSyntax, middle.span,
                   "a distance is meant here, found a number; two numbers are not compared");
    Node first = relate(middle, mirrored(relation), of_number(number));
    if (!cursor_.at(K::kRelation)) return first;
    // Written out, a chain under `not` needs parentheses, and that has to be readable too.
    check_depth(depth_ + 1);
    const Relation upper = cursor_.take().relation;
    Node node{Op::kAnd, 0, {}};
    node.operands.push_back(std::move(first));
    node.operands.push_back(relate(middle, upper, of_number(level_number())));
    if (cursor_.at(K::kRelation)) cursor_.fail_syntax("a chain has two relations at most: 0.5 <= gap(B, A) <= 2");
    return node;
  }

  Node distance_first() { return sum_first(read_sum(cursor_, context_, calls_)); }

  /// sum -> min, or sum REL sum.
  Node sum_first(const Sum& left) {
    if (cursor_.at(K::kArrow)) {
      cursor_.take();
      if (!cursor_.accept_word("min")) cursor_.fail_syntax("only 'min' may follow '->', found {}", cursor_.found());
      return left.term ? minimum(*left.term) : minimum(left);
    }
    if (cursor_.at(K::kTimes) || cursor_.at(K::kOver))
      cursor_.fail_syntax(
          "numbers stand before the distance that they multiply, such as 1/2 * gap(B, A); distances are not multiplied "
          "with each other");
    if (!cursor_.at(K::kRelation)) {
      const std::string example = left.term ? written(left.term->distance) : "gap(B, A) + gap(B, C)";
      cursor_.fail(ErrorCode::kSyntax, left.span, "a distance is a number, not a condition; compare it, e.g. {} >= 0",
                   example);
    }
    const Relation relation = cursor_.take().relation;
    if (!at_arithmetic(cursor_) && !calls_.at_distance())
      cursor_.fail_syntax("a number is meant here, found {}", cursor_.found());
    Node node = relate(left, relation, read_sum(cursor_, context_, calls_));
    if (cursor_.at(K::kRelation)) {
      cursor_.fail_syntax("a chain has its distance in the middle: 0.5 <= gap(B, A) <= 2");
    }
    return node;
  }

  Node relate(const Sum& left, Relation relation, const Sum& right) {
    if (left.term && right.is_number()) return add(comparison(*left.term, relation, right.numbers.front()));
    SumCondition found = condition(cursor_, context_, difference(left, right), relation);
    if (!found.atom) return Node{found.holds ? Op::kTrue : Op::kFalse, 0, {}};
    return add(*std::move(found.atom));
  }

  /// As the right side of a relation.
  static Sum of_number(const Number& number) { return {{}, {number}, std::nullopt, number.span}; }

  /// The number on the right side of a relation.
  Number level_number() {
    if (calls_.at_distance()) cursor_.fail_syntax("a number is meant at the end of a chain, found a distance");
    return read_total(cursor_);
  }

  Node minimum(const Term& term) {
    if (term.negated) {
      cursor_.fail(ErrorCode::kBadValue, term.span,
                   "'{}' has no least value; the positions of its greatest value are {} -> min",
                   term.distance.spelled->name, text(term.distance));
    }
    return add(minimisers(term.distance));
  }

  /// Of a distance times a factor.
  Node minimum(const Sum& sum) {
    if (sum.terms.size() != 1 || !sum.numbers.empty())
      cursor_.fail(ErrorCode::kUnsupported, sum.span, "'-> min' is of one distance; \"minimize\" takes a sum");
    const SumTerm& only = sum.terms.front();
    if (only.weight.sign() < 0)
      cursor_.fail(ErrorCode::kUnsupported, sum.span,
                   "'-> min' is of a distance, not of minus one; \"maximize\" takes {}", written(only.distance));
    return add(minimisers(only.distance));
  }

  Node argmin() {
    cursor_.take();
    const Span open = cursor_.peek().span;
    if (!cursor_.accept(K::kOpen) || !cursor_.at(K::kName)) {
      cursor_.fail_syntax("'argmin' takes a distance: argmin(gap(B, A)), found {}", cursor_.found());
    }
    const Term term = calls_.distance();
    if (!cursor_.accept(K::kClose)) cursor_.fail_unclosed(open);
    return minimum(term);
  }

  Node predicate() {
    const std::string_view word = find_predicate(cursor_.peek().text)->name;
    Node node = add(calls_.predicate());
    if (cursor_.at(K::kRelation) || cursor_.at(K::kArrow)) {
      cursor_.fail_syntax("'{}' is true or false; it is not compared with anything", word);
    }
    return node;
  }

  /// Fails at a token that cannot follow a condition; `open` is the '(' to be closed, if there is one.
  [[noreturn]] void fail_after_condition(const Span* open) {
    if (cursor_.at(K::kEnd)) cursor_.fail_unclosed(*open);
    if (cursor_.at(K::kClose)) cursor_.fail_syntax("this ')' closes nothing");
    if (cursor_.at(K::kComma) && cursor_.peek(1).kind == K::kNumber) {
      cursor_.fail_syntax("unexpected ','; decimals are written with a point");
    }
    std::string question;
    if (cursor_.at(K::kName)) {
      const std::vector<std::string> connectives{"and", "or"};
      question = formula::question(cursor_.peek().text, connectives);
    }
    const char* const meant = open == nullptr ? "'and' or 'or'" : "'and', 'or' or ')'";
    cursor_.fail_syntax("{} is meant here, found {}{}", meant, cursor_.found(), question);
  }

  const Context& context_;
  Cursor cursor_;
  CallReader calls_;
  std::vector<Atom> atoms_;
  int depth_ = 0;
};

/// x, y or z alone.
bool read_coordinate(Cursor& cursor, const Context& context, Objective& objective) {
  if (cursor.peek(1).kind != K::kEnd) return false;
  if (cursor.at_word("x")) {
    objective.kind = Objective::Kind::kX;
  } else if (cursor.at_word("y")) {
    objective.kind = Objective::Kind::kY;
  } else if (cursor.at_word("z")) {
    if (context.dimension < 3) {
      cursor.fail(ErrorCode::kBadValue, cursor.peek().span, "'z' is an objective in 3 dimensions; the scene has 2");
    }
    objective.kind = Objective::Kind::kZ;
  } else {
    return false;
  }
  cursor.take();
  return true;
}

/// distance to [x, y].
bool read_point(Cursor& cursor, const Context& context, Objective& objective) {
  if (!cursor.at_word("distance") || !cursor.at_word("to", 1)) return false;
  cursor.take();
  cursor.take();
  if (!cursor.accept(K::kOpenBracket)) {
    cursor.fail_syntax("a point such as [1, 2] is meant after 'distance to', found {}", cursor.found());
  }
  objective.kind = Objective::Kind::kDistanceToPoint;
  objective.point = read_coordinates(cursor, context, Quantity::kLength, K::kCloseBracket, objective.point_text);
  objective.point_text = "[" + objective.point_text + "]";
  return true;
}

/// One distance, or a sum of several.
void read_distances(Cursor& cursor, const Context& context, Objective& objective) {
  CallReader calls(cursor, context);
  Sum sum = read_sum(cursor, context, calls);
  if (!sum.numbers.empty())
    cursor.fail(ErrorCode::kBadValue, sum.numbers.front().span,
                "a number by itself does not change which position is best: leave it out");
  if (sum.terms.empty())
    cursor.fail(ErrorCode::kBadValue, sum.span, "these distances cancel: nothing is left of the sum");
  for (const SumTerm& t : sum.terms)
    if (t.distance.first.empty() || t.distance.second.empty())
      cursor.fail(ErrorCode::kBadValue, sum.span, "a distance to an empty list is not an objective");
  const exact::Real& first = sum.terms.front().weight;
  if (sum.terms.size() == 1 && exact::abs(first) == exact::Real(1)) {
    objective.distance = std::move(sum.terms.front().distance);
    objective.negated = first.sign() < 0;
    return;
  }
  Context alone = context;  // of the shapes that are placed one is placed at a time
  alone.independent = false;
  check_sum(cursor, alone, sum);
  for (const SumTerm& t : sum.terms) check_computed(cursor, sum.span, t.weight);
  objective.kind = Objective::Kind::kSum;
  objective.terms = std::move(sum.terms);
}

}  // namespace

Formula parse_formula(std::string_view text, const Context& context) {
  Formula formula = Grammar(text, context).formula();
  charge_conditions(formula, context.work_limit);
  return formula;
}

Objective parse_objective(std::string_view text, const Context& context) {
  static constexpr char kForms[] =
      "an objective is a distance such as gap(B, A), a sum of distances, x, y, z or distance to [x, y]; found {}";
  Cursor cursor(text);
  Objective objective;
  if (!read_coordinate(cursor, context, objective) && !read_point(cursor, context, objective)) {
    if (!cursor.at(K::kName) && !at_number(cursor) && !at_number_in_parentheses(cursor))
      cursor.fail_syntax(kForms, cursor.found());
    read_distances(cursor, context, objective);
  }
  if (!cursor.at(K::kEnd)) cursor.fail_syntax(kForms, cursor.found());
  return objective;
}

}  // namespace findspace::formula
