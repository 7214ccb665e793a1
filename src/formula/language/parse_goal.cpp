// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "formula/language/parse_goal.h"

#include <utility>

#include "formula/language/parse_reader.h"

namespace findspace::formula {
namespace {

using K = Token::Kind;

bool at_sign(const Reader& reader) { return reader.at(K::kMinus) || reader.at(K::kPlus); }

/// Which coordinate the token `ahead` names, or -1.
int coordinate_at(const Reader& reader, std::size_t ahead) {
  for (int k = 0; k < 3; ++k)
    if (reader.at_word(std::string_view("xyz").substr(std::size_t(k), 1), ahead)) return k;
  return -1;
}

bool at_linear(const Reader& reader) {
  std::size_t ahead = at_sign(reader) ? 1 : 0;
  if (reader.peek(ahead).kind == K::kNumber) ++ahead;
  return coordinate_at(reader, ahead) >= 0;
}

void add_term(Reader& reader, std::array<exact::Real, 3>& form) {
  exact::Real factor(1);
  if (at_sign(reader) && reader.take().kind == K::kMinus) factor = -factor;
  if (reader.at(K::kNumber)) {
    const Token digits = reader.take();
    Number number;
    number.digits = digits.text;
    number.span = digits.span;
    factor = factor * reader.level(number, Quantity::kPure).value;
  }
  const int k = coordinate_at(reader, 0);
  const bool plane = reader.context().dimension == 2;
  if (k < 0) reader.fail_syntax("{} is meant here, found {}", plane ? "x or y" : "x, y or z", reader.found());
  if (k == 2 && plane) reader.fail_syntax("'z' is an objective in 3 dimensions; the scene has 2");
  reader.take();
  form[std::size_t(k)] = form[std::size_t(k)] + factor;
}

Goal linear(std::string_view text, const Context& context) {
  Reader reader(text, context);
  Goal goal;
  goal.form.emplace();
  do {
    add_term(reader, *goal.form);
  } while (at_sign(reader));
  const auto& f = *goal.form;
  if (f[0].sign() == 0 && f[1].sign() == 0 && f[2].sign() == 0)
    reader.fail(ErrorCode::kBadValue, Span{0, reader.end()}, "this form is 0 everywhere");
  if (reader.at(K::kRelation)) {
    if (reader.peek().relation != Relation::kEqual)
      reader.fail_syntax("a condition on coordinates is written with '=', found {}", reader.found());
    reader.take();
    goal.equals = reader.level(reader.number(), Quantity::kLength).value;
  }
  if (!reader.at(K::kEnd)) reader.fail_syntax("the end, '+', '-' or '=' is meant here, found {}", reader.found());
  return goal;
}

}  // namespace

Goal parse_goal(std::string_view text, const Context& context) {
  Reader reader(text, context);
  if (at_linear(reader)) return linear(text, context);
  Goal goal;
  if (reader.at_word("grid") && reader.peek(1).kind == K::kEnd) {
    goal.grid = true;
    return goal;
  }
  std::string rest(text);
  if (at_sign(reader)) {
    const Token sign = reader.take();
    goal.negated = sign.kind == K::kMinus;
    // Blanks keep every column where it was.
    for (std::size_t i = sign.span.begin; i < sign.span.end; ++i) rest[i] = ' ';
  }
  goal.objective = parse_objective(rest, context);
  return goal;
}

}  // namespace findspace::formula
