// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "findspace/formula.h"

#include <fmt/format.h>

#include <vector>

#include "findspace/error.h"
#include "formula/language/parse.h"

namespace findspace {
namespace {

/// "a + b" as quoted names, so that any name can stand there.
std::vector<std::string> names_of(std::string_view shapes) {
  std::vector<std::string> names;
  while (true) {
    const std::size_t plus = shapes.find('+');
    std::string_view name = shapes.substr(0, plus);
    while (name.starts_with(' ')) name.remove_prefix(1);
    while (name.ends_with(' ')) name.remove_suffix(1);
    if (name.empty()) throw Error(ErrorCode::kSyntax, "the name of a shape is empty");
    names.emplace_back(name);
    if (plus == std::string_view::npos) return names;
    shapes.remove_prefix(plus + 1);
  }
}

std::string quoted(std::string_view shapes) {
  std::string out;
  for (const std::string& name : names_of(shapes)) {
    out += out.empty() ? "\"" : " + \"";
    for (const char c : name) {
      if (c == '"' || c == '\\') out += '\\';
      out += c;
    }
    out += '"';
  }
  return out;
}

/// The words and the two shapes of a predicate or a distance.
std::string call(std::string_view word, std::string_view a, std::string_view b, std::string_view rest = {}) {
  return fmt::format("{}({}, {}{})", word, quoted(a), quoted(b), rest);
}

/// Refuses an atom that no world could read: its names are all known here, and those of the first shape move.
Formula checked(std::string atom) {
  formula::Context any;
  any.motion = true;
  any.unit = formula::Unit::kMillimetre;
  bool open = false, first = true;
  for (std::size_t i = 0; i < atom.size(); ++i) {
    if (atom[i] == '"') {
      open = !open;
      if (open) any.shapes.emplace_back();
    } else if (open) {
      if (atom[i] == '\\') ++i;
      any.shapes.back() += atom[i];
    } else if (atom[i] == ',' && first) {
      any.moving = any.shapes;
      first = false;
    }
  }
  formula::parse_formula(atom, any);
  return Formula(std::move(atom));
}

std::string with_level(const Level& level) { return ", " + level.text(); }

Formula with_word(std::string_view word, std::string_view a, std::string_view b, const Level& level) {
  return checked(call(word, a, b, with_level(level)));
}

}  // namespace

Formula operator&&(const Formula& a, const Formula& b) { return fmt::format("({}) and ({})", a.text_, b.text_); }
Formula operator||(const Formula& a, const Formula& b) { return fmt::format("({}) or ({})", a.text_, b.text_); }
Formula operator!(const Formula& a) { return fmt::format("not ({})", a.text_); }

Distance::Distance(std::string_view word, std::string_view first, std::string_view second)
    : text_(call(word, first, second)) {
  checked(text_ + " >= 0");
}

Distance Distance::with(std::string_view mode, const Point& vector) const {
  std::string text = text_;
  text.insert(text.rfind(')'), fmt::format(", {}=({}, {})", mode, vector.x.text(), vector.y.text()));
  checked(text + " >= 0");
  return Distance(std::move(text));
}

Formula Distance::minimal() const { return checked(text_ + " -> min"); }
Formula Distance::compared(std::string_view relation, const Level& level) const {
  return checked(fmt::format("{} {} {}", text_, relation, level.text()));
}

namespace words {

Formula overlaps(std::string_view a, std::string_view b) { return checked(call("overlaps", a, b)); }
Formula touches(std::string_view a, std::string_view b) { return checked(call("touches", a, b)); }
Formula disjoint(std::string_view a, std::string_view b) { return checked(call("disjoint", a, b)); }
Formula clear(std::string_view a, std::string_view b, const Level& level) { return with_word("clear", a, b, level); }
Formula within(std::string_view a, std::string_view b, const Level& level) { return with_word("within", a, b, level); }
Formula near(std::string_view a, std::string_view b, const Level& level) { return with_word("near", a, b, level); }
Formula far(std::string_view a, std::string_view b, const Level& level) { return with_word("far", a, b, level); }
Formula keepout(std::string_view a, std::string_view b, const Level& level) {
  return with_word("keepout", a, b, level);
}
Formula group(std::string_view a, std::string_view b, const Level& level) { return with_word("group", a, b, level); }
Formula inside(std::string_view a, std::string_view b, const Level& level) { return with_word("inside", a, b, level); }
Formula covers(std::string_view a, std::string_view b, const Level& level) { return with_word("covers", a, b, level); }

}  // namespace words
}  // namespace findspace
