// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "formula/language/parse_goal.h"

#include <utility>

#include "formula/language/parse_number.h"

namespace findspace::formula {
namespace {

using K = Token::Kind;

bool at_sign(const Cursor& cursor) { return cursor.at(K::kMinus) || cursor.at(K::kPlus); }

/// Which coordinate the token `ahead` names, or -1.
int coordinate_at(const Cursor& cursor, std::size_t ahead) {
  for (int k = 0; k < 3; ++k)
    if (cursor.at_word(std::string_view("xyz").substr(std::size_t(k), 1), ahead)) return k;
  return -1;
}

bool at_linear(const Cursor& cursor) {
  std::size_t ahead = at_sign(cursor) ? 1 : 0;
  if (cursor.peek(ahead).kind == K::kNumber) ++ahead;
  return coordinate_at(cursor, ahead) >= 0;
}

void add_term(Cursor& cursor, const Context& context, std::array<exact::Real, 3>& form) {
  exact::Real factor(1);
  if (at_sign(cursor) && cursor.take().kind == K::kMinus) factor = -factor;
  if (cursor.at(K::kNumber)) {
    factor = factor * read_decimal(cursor);
  }
  const int k = coordinate_at(cursor, 0);
  const bool plane = context.dimension == 2;
  if (k < 0) cursor.fail_syntax("{} is meant here, found {}", plane ? "x or y" : "x, y or z", cursor.found());
  if (k == 2 && plane) cursor.fail_syntax("'z' is an objective in 3 dimensions; the scene has 2");
  cursor.take();
  form[std::size_t(k)] = form[std::size_t(k)] + factor;
}

Goal linear(std::string_view text, const Context& context) {
  Cursor cursor(text);
  Goal goal;
  goal.form.emplace();
  do {
    add_term(cursor, context, *goal.form);
  } while (at_sign(cursor));
  const auto& f = *goal.form;
  if (f[0].sign() == 0 && f[1].sign() == 0 && f[2].sign() == 0)
    cursor.fail(ErrorCode::kBadValue, Span{0, cursor.end()}, "this form is 0 everywhere");
  if (cursor.at(K::kRelation)) {
    if (cursor.peek().relation != Relation::kEqual)
      cursor.fail_syntax("a condition on coordinates is written with '=', found {}", cursor.found());
    cursor.take();
    goal.equals = level_of(cursor, context, read_total(cursor), Quantity::kLength).value;
  }
  if (!cursor.at(K::kEnd)) cursor.fail_syntax("the end, '+', '-' or '=' is meant here, found {}", cursor.found());
  return goal;
}

}  // namespace

Goal parse_goal(std::string_view text, const Context& context) {
  Cursor cursor(text);
  if (at_linear(cursor)) return linear(text, context);
  Goal goal;
  if (cursor.at_word("grid") && cursor.peek(1).kind == K::kEnd) {
    goal.grid = true;
    return goal;
  }
  std::string rest(text);
  const bool minus = cursor.at(K::kMinus);
  if (at_sign(cursor) && cursor.at_word("distance", 1) && cursor.at_word("to", 2)) {
    const Token sign = cursor.take();
    goal.negated = sign.kind == K::kMinus;
    // Blanks keep every column where it was.
    for (std::size_t i = sign.span.begin; i < sign.span.end; ++i) rest[i] = ' ';
  }
  goal.objective = parse_objective(rest, context);
  if (minus && goal.objective->kind == Objective::Kind::kDistance) {
    goal.negated = true;  // not the distance itself: its own word may be minus another
    goal.objective->negated = !goal.objective->negated;
  }
  return goal;
}

}  // namespace findspace::formula
