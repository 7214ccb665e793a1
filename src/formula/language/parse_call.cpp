// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Distances and predicates with their arguments, and the checks of shapes and of who moves.
#include <algorithm>

#include "formula/language/parse_reader.h"
#include "formula/language/text.h"

namespace findspace::formula {
namespace {

using K = Token::Kind;

/// How a word is to be written: "clear(B, A) or clear(B, A, number)".
std::string usage(const PredicateName& row) {
  const std::string plain = fmt::format("{}(B, A)", row.name), with_level = fmt::format("{}(B, A, number)", row.name);
  switch (row.level) {
    case PredicateName::Level::kNone:
      return plain;
    case PredicateName::Level::kOptional:
      return plain + " or " + with_level;
    case PredicateName::Level::kRequired:
      break;
  }
  return with_level;
}

std::string joined(const std::vector<std::string>& names) {
  std::string result;
  for (const std::string& name : names) result += (result.empty() ? "" : "+") + name;
  return printable(result);
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

bool Reader::at_distance() const {
  if (!at(K::kName)) return false;
  if ((at_word("inf") || at_word("sup")) && peek(1).kind == K::kName) return true;
  return find_distance(peek().text) != nullptr;
}

Term Reader::distance() {
  Term term;
  term.span.begin = peek().span.begin;
  Extremum prefix = Extremum::kNone;
  if ((at_word("inf") || at_word("sup")) && peek(1).kind == K::kName) {
    if (!context_.motion) {
      fail(ErrorCode::kBadValue, peek().span, "{} is over the time of a motion, and the scene has none", found());
    }
    prefix = take().text == "inf" ? Extremum::kInf : Extremum::kSup;
  }
  const DistanceName* const row = find_distance(peek().text);
  if (row == nullptr && find_predicate(peek().text) != nullptr) {
    fail_syntax("a distance is meant here, not the predicate {}", found());
  }
  if (row == nullptr) fail_unknown_word();
  const std::string word = printable(take().text);
  Call arguments = call(
      word, [&] { return word + "(B, A)"; }, false);
  if (arguments.mode != Mode::kPlain && !is_directional(row->kind)) {
    fail(ErrorCode::kBadValue, arguments.mode_span,
         "'{}' has no directional or rotational form; gap, reach, margin, cover, eta2 and delta2 have", word);
  }
  term.negated = row->negated;
  Distance& result = term.distance;
  result.kind = row->kind;
  // The least value of -f over time is minus the largest of f.
  result.prefix = row->negated ? opposite(prefix) : prefix;
  result.mode = arguments.mode;
  result.vector = std::move(arguments.vector);
  result.vector_text = std::move(arguments.vector_text);
  result.first = std::move(arguments.first);
  result.second = std::move(arguments.second);
  if (row->exchanged) std::swap(result.first, result.second);
  result.spelled = row;
  term.span.end = end();
  return term;
}

Atom Reader::predicate() {
  const PredicateName& row = *find_predicate(take().text);
  Call arguments = call(
      row.name, [&] { return usage(row); }, true);
  if (arguments.level && row.level == PredicateName::Level::kNone) {
    fail(ErrorCode::kSyntax, arguments.level->span, "'{}' takes no number: {}", row.name, usage(row));
  }
  if (!arguments.level && row.level == PredicateName::Level::kRequired) {
    fail(ErrorCode::kSyntax, {end() - 1, end()}, "'{}' needs a number: {}", row.name, usage(row));
  }
  Level bound{exact::Real(0), {}};
  if (arguments.level) {
    if (row.negated) arguments.level->negative = !arguments.level->negative;
    bound = level(*arguments.level, Quantity::kLength);
  }
  Distance distance;
  distance.kind = row.kind;
  distance.first = std::move(arguments.first);
  distance.second = std::move(arguments.second);
  distance.spelled = &plain_name(row.kind);
  Atom atom = compare(std::move(distance), row.relation, std::move(bound.value), std::move(bound.written));
  atom.predicate = &row;
  return atom;
}

void Reader::fail_unknown_word() const {
  const std::string word = peek().text;
  if (known_.contains(word)) {
    fail_syntax("'{}' is a shape; a distance or predicate is meant here, such as gap(B, A)", printable(word));
  }
  std::vector<std::string> known{"true", "false", "not", "inf", "sup", "argmin"};
  for (const DistanceName& row : distance_names()) known.emplace_back(row.name);
  for (const PredicateName& row : predicate_names()) known.emplace_back(row.name);
  fail(ErrorCode::kUnknownName, peek().span, "unknown distance or predicate '{}'{}", printable(word),
       question(word, known));
}

Call Reader::call(std::string_view word, const Usage& usage, bool is_predicate) {
  Call result;
  const auto takes = [&] { return fmt::format("'{}' takes two shapes: {}", word, usage()); };
  result.span.begin = peek().span.begin;
  const Span open = peek().span;
  if (!accept(K::kOpen)) fail_syntax("{}, found {}", takes(), found());
  if (at(K::kClose)) fail_syntax("{}", takes());
  result.first_span.begin = peek().span.begin;
  result.first = shapes(word);
  result.first_span.end = end();
  if (at(K::kClose)) fail_syntax("{}; the second is missing", takes());
  if (!accept(K::kComma)) fail_syntax("a ',' and the second shape of '{}' are meant here, found {}", word, found());
  result.second_span.begin = peek().span.begin;
  result.second = shapes(word);
  result.second_span.end = end();
  if (accept(K::kComma)) last_argument(result, word, usage, is_predicate);
  if (at(K::kComma)) fail_syntax("too many arguments; '{}' is written {}", word, usage());
  if (!accept(K::kClose)) fail_unclosed(open);
  result.span.end = end();
  check_roles(result);
  return result;
}

void Reader::last_argument(Call& call, std::string_view word, const Usage& usage, bool is_predicate) {
  if (at(K::kName) && peek(1).kind == K::kRelation && peek(1).relation == Relation::kEqual) {
    return direction(call, word, is_predicate);
  }
  if (is_predicate && at_number()) {
    call.level = number();
    return;
  }
  if (at_number()) fail_syntax("'{}' takes no number; compare it with one: {} >= 1", word, usage());
  fail_syntax("'{}' takes two shapes: {}, found {}", word, usage(), found());
}

void Reader::direction(Call& call, std::string_view word, bool is_predicate) {
  call.mode_span = peek().span;
  if (is_predicate) fail_syntax("the predicate '{}' has no directional form; write it as a distance", word);
  const std::string key = take().text;
  if (key == "along") {
    call.mode = Mode::kAlong;
  } else if (key == "toward") {
    call.mode = Mode::kToward;
  } else if (key == "turning") {
    call.mode = Mode::kRotation;
  } else {
    const std::vector<std::string> keys{"along", "toward", "turning"};
    const std::string near = question(key, keys);
    fail(ErrorCode::kUnknownName, call.mode_span, "unknown argument '{}='{}", printable(key),
         near.empty() ? "; known are along, toward and turning" : near);
  }
  if (call.mode == Mode::kRotation && context_.dimension != 2) {
    fail(ErrorCode::kUnsupported, call.mode_span, "turning is about a point of the plane; the scene has 3 dimensions");
  }
  take();  // '='
  if (!accept(K::kOpen)) fail_syntax("a vector such as (1, 0) is meant here, found {}", found());
  const std::size_t begin = end() - 1;
  const bool centre = call.mode == Mode::kRotation;
  call.vector = coordinates(centre ? Quantity::kLength : Quantity::kPure, K::kClose, call.vector_text);
  call.vector_text = "(" + call.vector_text + ")";
  const bool zero = std::all_of(call.vector.begin(), call.vector.end(), [](const auto& c) { return c.sign() == 0; });
  if (zero && !centre) fail(ErrorCode::kBadValue, {begin, end()}, "the zero vector is no direction");
}

std::vector<std::string> Reader::shapes(std::string_view word) {
  std::vector<std::string> result{shape(word)};
  while (accept(K::kPlus)) result.push_back(shape(word));
  return result;
}

std::string Reader::shape(std::string_view word) {
  if (at(K::kNumber)) {
    fail_syntax("a shape of '{}' is meant here, found the number {}; a name that begins with a digit stands in quotes",
                word, found());
  }
  if (!at(K::kName) && !at(K::kQuoted)) {
    fail_syntax("a shape of '{}' is meant here, found {}", word, found());
  }
  const Token& token = peek();
  const bool known = known_.contains(token.text);
  if (!known && peek(1).kind == K::kOpen &&
      (find_distance(token.text) != nullptr || find_predicate(token.text) != nullptr)) {
    fail_syntax("a shape is meant here, not {}", found());
  }
  if (!known && contains(context_.placed, token.text)) {
    fail(ErrorCode::kBadValue, token.span,
         "'{}' is placed itself, and here only shapes that stand still are meant; name it in \"constraints\", or as "
         "'other' in \"pairs\"",
         printable(token.text));
  }
  if (!known) fail_unknown_shape(token);
  return take().text;
}

void Reader::fail_unknown_shape(const Token& token) const {
  const std::vector<std::string> known = names();
  std::string hint = question(token.text, known);
  if (hint.empty()) hint = known.empty() ? "; the scene has no shapes" : "; the shapes are " + listed(known);
  if (token.text == "self" || token.text == "other") {
    hint = token.text == "self"
               ? "; it is the shape being placed, in a placement's \"each\", \"pairs\" and \"minimize\""
               : "; it is a shape placed before, in a placement's \"pairs\"";
  }
  if (peek(1).kind == K::kName) hint += "; a name with blanks stands in quotes";
  fail(ErrorCode::kUnknownName, token.span, "unknown shape '{}'{}", printable(token.text), hint);
}

bool Reader::moves(const std::string& name) const { return contains(context_.moving, name); }

/// Whether a union moves; one that moves in part, or whose parts move apart, has no position and so no distance.
bool Reader::moves(const std::vector<std::string>& names, Span span) const {
  const auto count = std::count_if(names.begin(), names.end(), [&](const auto& name) { return moves(name); });
  if (count == 0) return false;
  if (static_cast<std::size_t>(count) < names.size()) {
    fail(ErrorCode::kBadValue, span, "only a part of the union '{}' moves; take the parts one by one", joined(names));
  }
  if (context_.independent && names.size() > 1) {
    fail(ErrorCode::kBadValue, span, "the parts of the union '{}' move each on its own; take them one by one",
         joined(names));
  }
  return true;
}

void Reader::check_roles(const Call& call) const {
  const Span both{call.first_span.begin, call.second_span.end};
  if (call.first == call.second) fail(ErrorCode::kBadValue, both, "a distance of '{}' to itself", joined(call.first));
  const bool first_moves = moves(call.first, call.first_span), second_moves = moves(call.second, call.second_span);
  if (first_moves != second_moves) return;
  if (first_moves && context_.independent) return;
  if (first_moves) {
    fail(ErrorCode::kBadValue, both, "'{}' and '{}' move together, so their distance never changes", joined(call.first),
         joined(call.second));
  }
  const std::string mover = context_.moving.empty()       ? "a moving shape, and the scene has none"
                            : context_.moving.size() == 1 ? "the moving shape " + listed(context_.moving)
                                                          : "a moving shape: " + listed(context_.moving);
  fail(ErrorCode::kBadValue, both, "neither '{}' nor '{}' moves; one of the two has to be {}", joined(call.first),
       joined(call.second), mover);
}

}  // namespace findspace::formula
