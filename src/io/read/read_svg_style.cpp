// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/read/read_svg_style.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "io/text/units.h"

namespace findspace::io {
namespace {

constexpr std::string_view kStyleBlanks = " \t\r\n\f";
constexpr int kMostStyleDepth = 200;

std::string_view trimmed_style(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kStyleBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kStyleBlanks) - first + 1);
}

std::string lower(std::string_view text) {
  std::string out(trimmed_style(text));
  std::transform(out.begin(), out.end(), out.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  return out;
}

struct NamedColour {
  std::string_view name, value;
};
constexpr std::array<NamedColour, 19> kColours{{{"black", "#000000"},
                                                {"white", "#ffffff"},
                                                {"red", "#ff0000"},
                                                {"lime", "#00ff00"},
                                                {"blue", "#0000ff"},
                                                {"green", "#008000"},
                                                {"yellow", "#ffff00"},
                                                {"magenta", "#ff00ff"},
                                                {"fuchsia", "#ff00ff"},
                                                {"cyan", "#00ffff"},
                                                {"aqua", "#00ffff"},
                                                {"gray", "#808080"},
                                                {"grey", "#808080"},
                                                {"silver", "#c0c0c0"},
                                                {"maroon", "#800000"},
                                                {"olive", "#808000"},
                                                {"purple", "#800080"},
                                                {"navy", "#000080"},
                                                {"orange", "#ffa500"}}};

/// rgb(255, 0, 0)
std::string rgb_colour(std::string_view text) {
  std::string out = "#";
  for (int k = 0; k < 3; ++k) {
    text = text.substr(std::min(text.find_first_of("0123456789"), text.size()));
    const std::size_t digits = std::min(text.find_first_not_of("0123456789"), text.size());
    if (digits == 0 || digits > 3) return {};
    out += fmt::format("{:02x}", std::min(255, std::stoi(std::string(text.substr(0, digits)))));
    text.remove_prefix(digits);
  }
  return out;
}

/// Where the first of `stops` is that stands in no quotes and no brackets; else the length of the text.
std::size_t find_outside(std::string_view text, std::string_view stops) {
  int depth = 0;
  char quote = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '\\') {
      ++i;
    } else if (quote != 0) {
      if (c == quote) quote = 0;
    } else if (depth == 0 && stops.find(c) != std::string_view::npos) {
      return i;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '(' || c == '[' || c == '{') {
      ++depth;
    } else if ((c == ')' || c == ']' || c == '}') && depth > 0) {
      --depth;
    }
  }
  return text.size();
}

/// Takes what stands before one of `stops`, and the stop.
std::string_view take_until(std::string_view& text, std::string_view stops) {
  const std::size_t end = find_outside(text, stops);
  const std::string_view taken = trimmed_style(text.substr(0, end));
  text.remove_prefix(std::min(end + 1, text.size()));
  return taken;
}

/// Calls `declare` for each "property: value", of those that are important or of the others.
template <class Declare>
void for_declarations(std::string_view text, bool important, Declare declare) {
  while (!text.empty()) {
    std::string_view one = take_until(text, ";");
    const std::size_t colon = one.find(':');
    if (colon == std::string_view::npos) continue;
    std::string_view value = trimmed_style(one.substr(colon + 1));
    const std::size_t mark = value.rfind('!');
    const bool marked = mark != std::string_view::npos && lower(value.substr(mark + 1)) == "important";
    if (marked) value = trimmed_style(value.substr(0, mark));
    if (marked == important) declare(lower(one.substr(0, colon)), value);
  }
}

/// Attributes that say what a style may say.
constexpr std::array<std::string_view, 9> kLookAttributes{
    "stroke", "fill", "fill-rule", "display", "visibility", "clip-path", "mask", "transform-origin", "transform-box"};
/// Properties that are attributes too, of other values.
constexpr std::array<std::string_view, 10> kSizes{"x", "y", "width", "height", "cx", "cy", "r", "rx", "ry", "d"};
constexpr std::array<std::string_view, 5> kNotFollowed{"translate", "rotate", "scale", "offset", "offset-path"};

template <std::size_t N>
bool is_among(const std::array<std::string_view, N>& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

bool is_read(std::string_view property) {
  return property == "transform" || is_among(kLookAttributes, property) || is_among(kSizes, property) ||
         is_among(kNotFollowed, property);
}

void declare(SvgLook& look, const SvgLook& outer, const std::string& property, std::string_view stated) {
  const std::string value = lower(stated);
  const bool inherits = value == "inherit" || value == "unset";
  if (property == "stroke") look.stroke = inherits ? outer.stroke : svg_colour(value);
  if (property == "fill") look.fill = inherits ? outer.fill : svg_colour(value);
  if (property == "visibility") look.invisible = inherits ? outer.invisible : value == "hidden" || value == "collapse";
  if (property == "fill-rule") look.even_odd = inherits ? outer.even_odd : value == "evenodd";
  if (property == "display") look.hidden = value == "none";
  if (property == "clip-path") look.clipped = value != "none";
  if (property == "mask") look.masked = value != "none";
  if (property == "transform") look.transform = value == "none" ? "" : value;
  if (property == "transform-origin") look.origin = value;
  if (property == "transform-box") look.box = value;
  if (is_among(kNotFollowed, property) && (value != "none" || look.not_followed == property))
    look.not_followed = value == "none" ? "" : property;
  if (is_among(kSizes, property)) look.size[property] = stated;
}

bool has_word(std::string_view text, std::string_view word) {
  while (!(text = trimmed_style(text)).empty()) {
    const std::size_t end = std::min(text.find_first_of(kStyleBlanks), text.size());
    if (text.substr(0, end) == word) return true;
    text.remove_prefix(end);
  }
  return false;
}

}  // namespace

std::string svg_colour(std::string_view text) {
  std::string c = lower(text);
  for (const NamedColour& named : kColours)
    if (c == named.name) return std::string(named.value);
  if (c.starts_with("rgb(")) {
    const std::string value = rgb_colour(c);
    return value.empty() ? c : value;
  }
  if (c.size() == 4 && c[0] == '#') return {'#', c[1], c[1], c[2], c[2], c[3], c[3]};
  return c;
}

std::string_view svg_path_of_style(std::string_view value) {
  const std::size_t open = value.find_first_of("'\""), close = value.find_last_of("'\"");
  return open == std::string_view::npos ? std::string_view() : value.substr(open + 1, close - open - 1);
}

std::string_view svg_local_name(std::string_view name) {
  return name.substr(name.find(':') + 1);  // npos + 1 is 0
}

bool SvgStyles::Compound::of(const pugi::xml_node& node) const {
  if (node.type() != pugi::node_element) return false;
  if (!element.empty() && element != svg_local_name(node.name())) return false;
  if (!id.empty() && id != node.attribute("id").value()) return false;
  const std::string_view own = node.attribute("class").value();
  return std::all_of(classes.begin(), classes.end(), [&](const std::string& c) { return has_word(own, c); });
}

/// The element that stands for `begin` where `node` stands for the last of a run of children; none where one is not.
pugi::xml_node SvgStyles::Rule::top_of(std::size_t begin, std::size_t end, pugi::xml_node node) const {
  while (end-- > begin) {
    if (!path[end].of(node)) return {};
    if (end > begin) node = node.parent();
  }
  return node;
}

/// Runs of children, from the last: the nearest place for each leaves most room for those before it.
bool SvgStyles::Rule::of(const pugi::xml_node& node) const {
  pugi::xml_node at = node;
  for (std::size_t end = path.size(); end > 0;) {
    std::size_t begin = end - 1;
    while (path[begin].child) --begin;
    pugi::xml_node top = top_of(begin, end, at);
    while (!top && end < path.size() && (at = at.parent())) top = top_of(begin, end, at);
    if (!top) return false;
    at = top.parent();
    end = begin;
  }
  return true;
}

SvgStyles::SvgStyles(const pugi::xml_node& root) {
  collect(root, 0);
  std::stable_sort(rules_.begin(), rules_.end(),
                   [](const Rule& a, const Rule& b) { return a.specificity < b.specificity; });
}

namespace {

std::string without_comments(std::string_view text) {
  std::string out;
  while (true) {
    const std::size_t open = text.find("/*");
    out += text.substr(0, open);
    if (open == std::string_view::npos) return out;
    const std::size_t close = text.find("*/", open + 2);
    if (close == std::string_view::npos) return out;
    text.remove_prefix(close + 2);
  }
}

/// Of a screen, or of any medium.
bool is_usual_medium(std::string_view media) {
  const std::string words = lower(media);
  return words.empty() || words == "all" || words == "screen";
}

}  // namespace

void SvgStyles::collect(const pugi::xml_node& node, int depth) {
  if (depth > kMostStyleDepth) return;  // the reader refuses it
  for (const pugi::xml_node& child : node.children()) {
    if (svg_local_name(child.name()) != "style") {
      collect(child, depth + 1);
      continue;
    }
    const std::string type = lower(child.attribute("type").value());
    if (!type.empty() && type != "text/css") continue;
    if (lower(child.attribute("media").value()) == "print") continue;
    std::string text;
    for (const pugi::xml_node& part : child.children()) text += part.value();
    parse(without_comments(text), is_usual_medium(child.attribute("media").value()), 0);
  }
}

/// `known`: that what stands there applies.
void SvgStyles::parse(std::string_view text, bool known, int depth) {
  constexpr int kMostNested = 8;
  while (!text.empty()) {
    const std::size_t end = find_outside(text, "{;}");
    const bool block = end < text.size() && text[end] == '{';
    std::string_view head = trimmed_style(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (!block) continue;  // @import, @charset and the like
    const std::string_view inside = take_until(text, "}");
    if (head.empty() || head[0] != '@') {
      while (!head.empty()) add(take_until(head, ","), inside, known);
      continue;
    }
    const std::string word = lower(head.substr(0, head.find_first_of(" \t\r\n\f(")));
    const std::string_view of = trimmed_style(head.substr(word.size()));
    const bool grouping = word == "@media" || word == "@supports" || word == "@layer";
    if (!grouping || depth == kMostNested || (word == "@media" && lower(of) == "print")) continue;
    parse(inside, known && word == "@media" && is_usual_medium(of), depth + 1);
  }
}

/// The elements that a selector speaks of, from the outermost. Of a picture that stands still some hold for none.
SvgStyles::Reach SvgStyles::read_selector(std::string_view text, std::vector<Compound>& path) {
  static constexpr std::array<std::string_view, 7> kOfAPointer{"hover",        "active",  "focus", "focus-visible",
                                                               "focus-within", "visited", "target"};
  const auto word = [&] {
    std::size_t n = 0;
    while (n < text.size() && (std::isalnum(static_cast<unsigned char>(text[n])) != 0 || text[n] == '-' ||
                               text[n] == '_' || static_cast<unsigned char>(text[n]) > 0x7f))
      ++n;
    std::string found(text.substr(0, n));
    text.remove_prefix(n);
    return found;
  };
  bool child = false;
  for (text = trimmed_style(text); !text.empty(); text = trimmed_style(text)) {
    if (text[0] == '>') {
      if (path.empty() || child) return Reach::kUnknown;
      child = true;
      text.remove_prefix(1);
      continue;
    }
    Compound one;
    one.child = std::exchange(child, false);
    while (!text.empty() && text[0] != '>' && kStyleBlanks.find(text[0]) == std::string_view::npos) {
      const char kind = text[0];
      if (kind == '.' || kind == '#' || kind == ':' || kind == '*') text.remove_prefix(1);
      if (kind == '*') continue;
      if (kind == ':' && text.starts_with(':')) return Reach::kNone;  // what stands before or behind a text
      std::string name = word();
      if (kind == ':' && is_among(kOfAPointer, name)) return Reach::kNone;
      if (kind == ':' || name.empty()) return Reach::kUnknown;
      if (kind == '.')
        one.classes.push_back(std::move(name));
      else
        (kind == '#' ? one.id : one.element) = std::move(name);
    }
    path.push_back(std::move(one));
  }
  return path.empty() || child ? Reach::kUnknown : Reach::kKnown;
}

void SvgStyles::add(std::string_view selector, std::string_view declarations, bool known) {
  Rule rule;
  for (const bool important : {false, true})
    for_declarations(declarations, important, [&](const std::string& property, std::string_view value) {
      if (is_read(property)) (important ? rule.important : rule.usual)[property] = value;
    });
  if (rule.usual.empty() && rule.important.empty()) return;
  const Reach reach = read_selector(selector, rule.path);
  if (reach == Reach::kNone) return;
  if (reach == Reach::kUnknown || !known) {
    if (unread_++ == 0) first_unread_ = selector;
    return;
  }
  for (const Compound& one : rule.path) {
    rule.specificity[0] += one.id.empty() ? 0 : 1;
    rule.specificity[1] += one.classes.size();
    rule.specificity[2] += one.element.empty() ? 0 : 1;
  }
  important_ = important_ || !rule.important.empty();
  (rule.path.size() == 1 ? single_ : nested_) += rule.path.size();
  rules_.push_back(std::move(rule));
}

SvgLook SvgStyles::look(const pugi::xml_node& node, const SvgLook& outer) const {
  SvgLook own;
  own.stroke = outer.stroke;
  own.fill = outer.fill;
  own.invisible = outer.invisible;
  own.even_odd = outer.even_odd;
  for (const pugi::xml_attribute& given : node.attributes())
    if (is_among(kLookAttributes, given.name())) declare(own, outer, given.name(), given.value());
  const std::string_view style = node.attribute("style").value();
  const bool marked = important_ || style.find('!') != std::string_view::npos;
  const auto take = [&](const std::string& p, std::string_view v) { declare(own, outer, p, v); };
  for (const bool important : {false, true}) {
    if (important && !marked) break;
    for (const Rule& rule : rules_) {
      const auto& declared = important ? rule.important : rule.usual;
      if (declared.empty() || !rule.of(node)) continue;
      for (const auto& [property, value] : declared) take(property, value);
    }
    for_declarations(style, important, take);
  }
  return own;
}

}  // namespace findspace::io
