// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "formula/language/parse_sum.h"

#include <algorithm>
#include <utility>

#include "formula/language/evaluate.h"

namespace findspace::formula {

using exact::Real;

namespace {

using K = Token::Kind;

void add(std::vector<SumTerm>& terms, SumTerm term) {
  const auto known =
      std::find_if(terms.begin(), terms.end(), [&](const SumTerm& t) { return t.distance == term.distance; });
  if (known == terms.end()) {
    terms.push_back(std::move(term));
    return;
  }
  known->weight = known->weight + term.weight;
  if (known->weight.sign() == 0) terms.erase(known);
}

class SumReader {
 public:
  SumReader(Cursor& cursor, const Context& context, CallReader& calls)
      : cursor_(cursor), context_(context), calls_(calls) {}

  Sum read(std::optional<Number> first) {
    sum_.span.begin = first ? first->span.begin : cursor_.peek().span.begin;
    if (first)
      number(*std::move(first));
    else
      summand();
    while (cursor_.at(K::kPlus) || cursor_.at(K::kMinus)) summand();
    sum_.span.end = cursor_.end();
    if (count_ > 1) sum_.term.reset();
    return std::move(sum_);
  }

 private:
  void summand() {
    const bool after_sign = cursor_.at(K::kPlus) || cursor_.at(K::kMinus);
    const K next = cursor_.peek(after_sign ? 1 : 0).kind;
    if (next == K::kNumber || next == K::kOpen) return number(read_number(cursor_));
    Real weight(1);
    if (after_sign && cursor_.take().kind == K::kMinus) weight = -weight;
    distance(weight, !after_sign);
  }

  void number(Number digits) {
    if (!cursor_.accept(K::kTimes)) {
      sum_.numbers.push_back(std::move(digits));
      ++count_;
      return;
    }
    if (!digits.unit.empty() && (cursor_.at(K::kNumber) || cursor_.at(K::kOpen)))
      cursor_.fail(ErrorCode::kBadValue, digits.unit_span, "a unit stands behind the whole product: 2 * 3mm");
    if (!digits.unit.empty())
      cursor_.fail(ErrorCode::kBadValue, digits.unit_span, "the factor of a distance carries no unit");
    distance(level_of(cursor_, context_, digits, Quantity::kPure).value, false);
  }

  void distance(const Real& weight, bool plain) {
    if (!cursor_.at(K::kName)) cursor_.fail_syntax("a distance is meant here, found {}", cursor_.found());
    Term term = calls_.distance();
    if (weight.sign() == 0) cursor_.fail(ErrorCode::kBadValue, term.span, "a distance times 0 says nothing");
    sum_.angle = sum_.angle || term.distance.mode == Mode::kRotation;
    add(sum_.terms, {term.negated ? -weight : weight, term.distance});
    ++count_;
    if (plain) sum_.term = std::move(term);
  }

  Cursor& cursor_;
  const Context& context_;
  CallReader& calls_;
  Sum sum_;
  int count_ = 0;
};

bool is_empty(const Distance& d) { return d.first.empty() || d.second.empty(); }

/// +1 or -1 where a distance to an empty list makes the sum infinite, else 0.
int infinity(const Cursor& cursor, const Sum& sum) {
  int sign = 0;
  for (const SumTerm& t : sum.terms) {
    if (!is_empty(t.distance)) continue;
    if (t.distance.kind != Kind::kGamma1 && t.distance.kind != Kind::kD1)
      cursor.fail(ErrorCode::kSyntax, sum.span, "in a sum only gap and distance of an empty list are defined");
    if (sign != 0 && sign != t.weight.sign())
      cursor.fail(ErrorCode::kBadValue, sum.span, "two distances to empty lists are both infinite: not to be compared");
    sign = t.weight.sign();
  }
  return sign;
}

}  // namespace

Sum read_sum(Cursor& cursor, const Context& context, CallReader& calls) {
  return SumReader(cursor, context, calls).read(std::nullopt);
}

Sum read_sum(Cursor& cursor, const Context& context, CallReader& calls, Number first) {
  return SumReader(cursor, context, calls).read(std::move(first));
}

Sum difference(const Sum& left, const Sum& right) {
  Sum out = left;
  out.term.reset();
  out.angle = left.angle || right.angle;
  for (const SumTerm& t : right.terms) add(out.terms, {-t.weight, t.distance});
  for (Number number : right.numbers) {
    out.numbers.push_back(negated(std::move(number)));
  }
  out.span = {std::min(left.span.begin, right.span.begin), std::max(left.span.end, right.span.end)};
  return out;
}

void check_sum(const Cursor& cursor, const Context& context, const Sum& sum) {
  const auto refuse = [&](std::string_view why) {
    cursor.fail(ErrorCode::kUnsupported, sum.span, "sums and comparisons of distances are not computed {}", why);
  };
  if (context.dimension != 2) refuse("in 3 dimensions");
  if (context.motion) refuse("over a motion");
  if (context.independent || !context.placed.empty()) refuse("of shapes that are placed; \"minimize\" takes sums");
  for (const SumTerm& t : sum.terms)
    if (t.distance.mode != Mode::kPlain) refuse("along a direction or in rotation");
}

SumCondition condition(const Cursor& cursor, const Context& context, Sum sum, Relation relation) {
  const auto known = [&](int sign) {
    return SumCondition{std::nullopt, (accepted_signs(relation) >> (sign + 1) & 1U) != 0};
  };
  Real constant;
  for (const Number& number : sum.numbers)
    constant = constant + level_of(cursor, context, number, sum.angle ? Quantity::kAngle : Quantity::kLength).value;
  if (sum.terms.empty()) return known(constant.sign());
  if (const int sign = infinity(cursor, sum); sign != 0) return known(sign);
  if (sum.terms.size() > 1) check_sum(cursor, context, sum);
  const Real first = sum.terms.front().weight;
  SumCondition out;
  out.atom = compare(std::move(sum.terms.front().distance), first.sign() > 0 ? relation : mirrored(relation),
                     -constant / first);
  check_computed(cursor, sum.span, out.atom->level);
  for (std::size_t k = 1; k < sum.terms.size(); ++k) {
    out.atom->more.push_back({sum.terms[k].weight / first, std::move(sum.terms[k].distance)});
    check_computed(cursor, sum.span, out.atom->more.back().weight);
  }
  return out;
}

}  // namespace findspace::formula
