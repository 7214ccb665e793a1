// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "formula/language/parse_call.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <optional>

#include "formula/language/parse_number.h"
#include "formula/language/text.h"

namespace findspace::formula {

/// What stands in the parentheses of a distance or predicate.
struct Call {
  std::vector<std::string> first, second;
  Span first_span, second_span, span;
  std::optional<Number> level;
  Mode mode = Mode::kPlain;
  Span mode_span;
  std::vector<exact::Real> vector;
  std::string vector_text;
  bool turning = false;
};

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

/// All known shapes, in the order given.
std::vector<std::string> known_names(const Context& context) {
  std::vector<std::string> out = context.shapes;
  for (const auto* more : {&context.moving, &context.extra, &context.empty}) {
    for (const std::string& name : *more) {
      if (std::find(out.begin(), out.end(), name) == out.end()) out.push_back(name);
    }
  }
  return out;
}

bool moves(const Context& context, const std::string& name) { return contains(context.moving, name); }

/// Whether a union moves; one that moves in part, or whose parts move apart, has no position and so no distance.
bool moves(const Cursor& cursor, const Context& context, const std::vector<std::string>& names, Span span) {
  const auto count = std::count_if(names.begin(), names.end(), [&](const auto& name) { return moves(context, name); });
  if (count == 0) return false;
  if (static_cast<std::size_t>(count) < names.size()) {
    cursor.fail(ErrorCode::kBadValue, span, "only a part of the union '{}' moves; take the parts one by one",
                joined(names));
  }
  if (context.independent && names.size() > 1) {
    cursor.fail(ErrorCode::kBadValue, span, "the parts of the union '{}' move each on its own; take them one by one",
                joined(names));
  }
  return true;
}

/// One argument moves and the other stands still; or both move, each on its own.
void check_roles(const Cursor& cursor, const Context& context, const Call& call) {
  const Span both{call.first_span.begin, call.second_span.end};
  if (call.first.empty() || call.second.empty()) return;  // to the empty set the distance is known
  if (call.first == call.second)
    cursor.fail(ErrorCode::kBadValue, both, "a distance of '{}' to itself", joined(call.first));
  const bool first_moves = moves(cursor, context, call.first, call.first_span),
             second_moves = moves(cursor, context, call.second, call.second_span);
  if (first_moves != second_moves) return;
  if (first_moves && context.independent) return;
  if (first_moves) {
    cursor.fail(ErrorCode::kBadValue, both, "'{}' and '{}' move together, so their distance never changes",
                joined(call.first), joined(call.second));
  }
  const std::string mover = context.moving.empty()       ? "a moving shape, and the scene has none"
                            : context.moving.size() == 1 ? "the moving shape " + listed(context.moving)
                                                         : "a moving shape: " + listed(context.moving);
  cursor.fail(ErrorCode::kBadValue, both, "neither '{}' nor '{}' moves; one of the two has to be {}",
              joined(call.first), joined(call.second), mover);
}

}  // namespace

NameSet::NameSet(std::size_t most) : slots_(std::bit_ceil(2 * most + 1)) {}

void NameSet::add(std::string_view name) {
  slots_[slot(name)] = name;
  has_empty_ = has_empty_ || name.empty();
}

std::size_t NameSet::slot(std::string_view name) const {
  std::size_t at = std::hash<std::string_view>()(name) & (slots_.size() - 1);
  while (!slots_[at].empty() && slots_[at] != name) at = (at + 1) & (slots_.size() - 1);
  return at;
}

/// Units of work for a further shape of a union: its maps and regions are kept.
constexpr std::uint64_t kSummand = 10'000;

CallReader::CallReader(Cursor& cursor, const Context& context)
    : cursor_(cursor),
      context_(context),
      work_(context.work_limit),
      known_(context.shapes.size() + context.moving.size() + context.extra.size() + context.empty.size()) {
  for (const auto* names : {&context.shapes, &context.moving, &context.extra, &context.empty})
    for (const std::string& name : *names) known_.add(name);
}

bool CallReader::at_distance() const {
  if (!cursor_.at(K::kName)) return false;
  if ((cursor_.at_word("inf") || cursor_.at_word("sup")) && cursor_.peek(1).kind == K::kName) return true;
  return find_distance(cursor_.peek().text) != nullptr;
}

Term CallReader::distance() {
  Term term;
  term.span.begin = cursor_.peek().span.begin;
  Extremum prefix = Extremum::kNone;
  if ((cursor_.at_word("inf") || cursor_.at_word("sup")) && cursor_.peek(1).kind == K::kName) {
    if (!context_.motion) {
      cursor_.fail(ErrorCode::kBadValue, cursor_.peek().span, "{} is over the time of a motion, and the scene has none",
                   cursor_.found());
    }
    prefix = cursor_.take().text == "inf" ? Extremum::kInf : Extremum::kSup;
  }
  const DistanceName* const row = find_distance(cursor_.peek().text);
  if (row == nullptr && find_predicate(cursor_.peek().text) != nullptr) {
    cursor_.fail_syntax("a distance is meant here, not the predicate {}", cursor_.found());
  }
  if (row == nullptr) fail_unknown_word();
  const std::string word = printable(cursor_.take().text);
  Call arguments = call(
      word, [&] { return word + "(B, A)"; }, false);
  if (arguments.mode != Mode::kPlain && !is_directional(row->kind)) {
    cursor_.fail(ErrorCode::kBadValue, arguments.mode_span,
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
  result.turning = arguments.turning;
  result.first = std::move(arguments.first);
  result.second = std::move(arguments.second);
  if (row->exchanged) std::swap(result.first, result.second);
  result.spelled = row;
  term.span.end = cursor_.end();
  return term;
}

Atom CallReader::predicate() {
  const PredicateName& row = *find_predicate(cursor_.take().text);
  Call arguments = call(
      row.name, [&] { return usage(row); }, true);
  if (arguments.level && row.level == PredicateName::Level::kNone) {
    cursor_.fail(ErrorCode::kSyntax, arguments.level->span, "'{}' takes no number: {}", row.name, usage(row));
  }
  if (!arguments.level && row.level == PredicateName::Level::kRequired) {
    cursor_.fail(ErrorCode::kSyntax, {cursor_.end() - 1, cursor_.end()}, "'{}' needs a number: {}", row.name,
                 usage(row));
  }
  Level bound{exact::Real(0), {}};
  if (arguments.level) {
    if (row.negated) *arguments.level = negated(*std::move(arguments.level));
    bound = level_of(cursor_, context_, *arguments.level, Quantity::kLength);
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

namespace {

/// Words of other programs for distances and predicates.
constexpr std::array<std::pair<std::string_view, std::string_view>, 16> kOtherWords{{{"apart", "disjoint"},
                                                                                     {"separate", "disjoint"},
                                                                                     {"separated", "disjoint"},
                                                                                     {"outside", "disjoint"},
                                                                                     {"touch", "touches"},
                                                                                     {"touching", "touches"},
                                                                                     {"intersects", "overlaps"},
                                                                                     {"intersect", "overlaps"},
                                                                                     {"collides", "overlaps"},
                                                                                     {"collision", "overlaps"},
                                                                                     {"contains", "covers"},
                                                                                     {"contained", "inside"},
                                                                                     {"in", "inside"},
                                                                                     {"clearance", "gap"},
                                                                                     {"separation", "gap"},
                                                                                     {"dist", "distance"}}};

/// "; did you mean 'covers'?", or else which predicates there are.
std::string words_meant(std::string_view word) {
  const auto other =
      std::find_if(kOtherWords.begin(), kOtherWords.end(), [&](const auto& w) { return w.first == word; });
  if (other != kOtherWords.end()) return fmt::format("; did you mean '{}'?", other->second);
  std::vector<std::string> known{"true", "false", "not", "inf", "sup", "argmin"}, predicates;
  for (const DistanceName& row : distance_names()) known.emplace_back(row.name);
  for (const PredicateName& row : predicate_names()) predicates.emplace_back(row.name);
  known.insert(known.end(), predicates.begin(), predicates.end());
  const std::string near = question(word, known);
  if (!near.empty()) return near;
  return fmt::format("; the predicates are {}, and 'findspace help formula' lists the distances",
                     fmt::join(predicates, ", "));
}

}  // namespace

void CallReader::fail_unknown_word() const {
  const std::string word = cursor_.peek().text;
  if (known_.contains(word)) {
    cursor_.fail_syntax("'{}' is a shape; a distance or predicate is meant here, such as gap(B, A)", printable(word));
  }
  cursor_.fail(ErrorCode::kUnknownName, cursor_.peek().span, "unknown distance or predicate '{}'{}", printable(word),
               words_meant(word));
}

Call CallReader::call(std::string_view word, const Usage& usage, bool is_predicate) {
  Call result;
  const auto takes = [&] { return fmt::format("'{}' takes two shapes: {}", word, usage()); };
  result.span.begin = cursor_.peek().span.begin;
  const Span open = cursor_.peek().span;
  if (!cursor_.accept(K::kOpen)) cursor_.fail_syntax("{}, found {}", takes(), cursor_.found());
  if (cursor_.at(K::kClose)) cursor_.fail_syntax("{}", takes());
  result.first_span.begin = cursor_.peek().span.begin;
  result.first = shapes(word);
  result.first_span.end = cursor_.end();
  if (cursor_.at(K::kClose)) cursor_.fail_syntax("{}; the second is missing", takes());
  if (!cursor_.accept(K::kComma))
    cursor_.fail_syntax("a ',' and the second shape of '{}' are meant here, found {}", word, cursor_.found());
  result.second_span.begin = cursor_.peek().span.begin;
  result.second = shapes(word);
  result.second_span.end = cursor_.end();
  if (cursor_.accept(K::kComma)) last_argument(result, word, usage, is_predicate);
  const bool another =
      cursor_.at(K::kComma) && cursor_.peek(1).kind == K::kName && cursor_.peek(2).kind == K::kRelation;
  if (another && result.mode_span.end > result.mode_span.begin)
    cursor_.fail_syntax("'{}' takes one direction or rotation, not two; join two conditions by 'and'", word);
  if (cursor_.at(K::kComma)) cursor_.fail_syntax("too many arguments; '{}' is written {}", word, usage());
  if (!cursor_.accept(K::kClose)) cursor_.fail_unclosed(open);
  result.span.end = cursor_.end();
  check_roles(cursor_, context_, result);
  return result;
}

void CallReader::last_argument(Call& call, std::string_view word, const Usage& usage, bool is_predicate) {
  if (cursor_.at(K::kName) && cursor_.peek(1).kind == K::kRelation && cursor_.peek(1).relation == Relation::kEqual) {
    return direction(call, word, is_predicate);
  }
  if (is_predicate && at_arithmetic(cursor_)) {
    call.level = read_total(cursor_);
    return;
  }
  if (at_number(cursor_)) cursor_.fail_syntax("'{}' takes no number; compare it with one: {} >= 1", word, usage());
  cursor_.fail_syntax("'{}' takes two shapes: {}, found {}", word, usage(), cursor_.found());
}

void CallReader::direction(Call& call, std::string_view word, bool is_predicate) {
  call.mode_span = cursor_.peek().span;
  if (is_predicate) cursor_.fail_syntax("the predicate '{}' has no directional form; write it as a distance", word);
  const std::string key = cursor_.take().text;
  if (key == "along") {
    call.mode = Mode::kAlong;
  } else if (key == "toward") {
    call.mode = Mode::kToward;
  } else if (key == "rotating" || key == "turning") {  // the second is the older word
    call.mode = Mode::kRotation;
    call.turning = key == "turning";
  } else {
    const std::vector<std::string> keys{"along", "toward", "rotating"};
    const std::string near = question(key, keys);
    cursor_.fail(ErrorCode::kUnknownName, call.mode_span, "unknown argument '{}='{}", printable(key),
                 near.empty() ? "; known are along, toward and rotating" : near);
  }
  if (call.mode == Mode::kRotation && context_.dimension != 2) {
    cursor_.fail(ErrorCode::kUnsupported, call.mode_span,
                 "a rotation is about a point of the plane; the scene has 3 dimensions");
  }
  cursor_.take();  // '='
  if (!cursor_.accept(K::kOpen))
    cursor_.fail_syntax("a vector such as (1, 0) is meant here, found {}", cursor_.found());
  const std::size_t begin = cursor_.end() - 1;
  const bool centre = call.mode == Mode::kRotation;
  call.vector =
      read_coordinates(cursor_, context_, centre ? Quantity::kLength : Quantity::kPure, K::kClose, call.vector_text);
  call.vector_text = "(" + call.vector_text + ")";
  const bool zero = std::all_of(call.vector.begin(), call.vector.end(), [](const auto& c) { return c.sign() == 0; });
  if (zero && !centre) cursor_.fail(ErrorCode::kBadValue, {begin, cursor_.end()}, "the zero vector is not a direction");
}

std::vector<std::string> CallReader::shapes(std::string_view word) {
  const auto is_word = [&](const char* text) { return cursor_.at_word(text) && !known_.contains(text); };
  if (is_word("others")) {
    cursor_.take();
    return standing({});
  }
  if (!is_word("all")) return listed_shapes(word);
  cursor_.take();
  if (!cursor_.accept_word("except"))
    cursor_.fail_syntax("'all' takes the shapes to leave out: all except A, found {}", cursor_.found());
  return standing(listed_shapes(word));
}

/// The shapes that stand still, lists aside, but those that are left out, alone or in a list.
std::vector<std::string> CallReader::standing(const std::vector<std::string>& without) const {
  std::vector<std::string> out;
  const auto left_out = [&](const std::string& name) {
    return std::any_of(without.begin(), without.end(), [&](const std::string& w) {
      const auto list = context_.groups.find(w);
      return w == name || (list != context_.groups.end() && contains(list->second, name));
    });
  };
  for (const std::string& name : context_.all ? *context_.all : context_.shapes)
    if (!moves(context_, name) && context_.groups.count(name) == 0 && !left_out(name)) out.push_back(name);
  return out;
}

/// Names joined by '+'; of lists without a shape nothing is left.
std::vector<std::string> CallReader::listed_shapes(std::string_view word) {
  std::vector<std::string> result{shape(word)};
  while (cursor_.accept(K::kPlus)) {
    work_.charge(kSummand, "a formula with so many shapes in one place");
    result.push_back(shape(word));
  }
  std::erase_if(result, [&](const std::string& name) { return contains(context_.empty, name); });
  return result;
}

std::string CallReader::shape(std::string_view word) {
  if (cursor_.at(K::kNumber)) {
    cursor_.fail_syntax(
        "a shape of '{}' is meant here, found the number {}; a name that begins with a digit stands in quotes", word,
        cursor_.found());
  }
  if (!cursor_.at(K::kName) && !cursor_.at(K::kQuoted)) {
    cursor_.fail_syntax("a shape of '{}' is meant here, found {}", word, cursor_.found());
  }
  const Token& token = cursor_.peek();
  const bool known = known_.contains(token.text);
  if (!known && cursor_.peek(1).kind == K::kOpen &&
      (find_distance(token.text) != nullptr || find_predicate(token.text) != nullptr)) {
    cursor_.fail_syntax("a shape is meant here, not {}", cursor_.found());
  }
  if (!known && contains(context_.placed, token.text)) {
    cursor_.fail(
        ErrorCode::kBadValue, token.span,
        "'{}' is placed itself, and here only shapes that stand still are meant; name it in \"constraints\", or as "
        "'other' in \"pairs\"",
        printable(token.text));
  }
  if (!known) fail_unknown_shape(token);
  return cursor_.take().text;
}

void CallReader::fail_unknown_shape(const Token& token) const {
  const std::vector<std::string> known = known_names(context_);
  std::string hint = question(token.text, known);
  if (hint.empty()) hint = known.empty() ? "; the scene has no shapes" : "; the shapes are " + listed(known);
  if (token.text == "self" || token.text == "other") {
    hint =
        token.text == "self"
            ? "; it is the shape being placed, in a placement's \"each\", \"pairs\", \"constraints\" and \"minimize\""
            : "; it is a shape placed before, in a placement's \"pairs\"";
  }
  if (cursor_.peek(1).kind == K::kName) hint += "; a name with blanks stands in quotes";
  cursor_.fail(ErrorCode::kUnknownName, token.span, "unknown shape '{}'{}", printable(token.text), hint);
}

}  // namespace findspace::formula
