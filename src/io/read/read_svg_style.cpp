// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/read/read_svg_style.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

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

/// Calls `declare` for each "property: value".
template <class Declare>
void for_declarations(std::string_view text, Declare declare) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(';'), text.size());
    const std::string_view one = text.substr(0, end);
    if (const std::size_t colon = one.find(':'); colon != std::string_view::npos)
      declare(lower(one.substr(0, colon)), lower(one.substr(colon + 1)));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

void declare(SvgLook& look, const std::string& property, const std::string& value) {
  if (property == "stroke") look.stroke = svg_colour(value);
  if (property == "fill") look.fill = svg_colour(value);
  if (property == "display") look.hidden = value.starts_with("none");
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

bool SvgStyles::Rule::of(const pugi::xml_node& node) const {
  std::string_view name = node.name();
  name.remove_prefix(name.find(':') + 1);  // npos + 1 is 0
  if (!element.empty() && element != name) return false;
  if (!id.empty() && id != node.attribute("id").value()) return false;
  const std::string_view own = node.attribute("class").value();
  return std::all_of(classes.begin(), classes.end(), [&](const std::string& c) { return has_word(own, c); });
}

SvgStyles::SvgStyles(const pugi::xml_node& root) { collect(root, 0); }

void SvgStyles::collect(const pugi::xml_node& node, int depth) {
  if (depth > kMostStyleDepth) return;  // the reader refuses it
  for (const pugi::xml_node& child : node.children()) {
    const std::string_view name = child.name();
    if (name == "style" || name == "svg:style") {
      std::string text;
      for (const pugi::xml_node& part : child.children()) text += part.value();
      parse(std::move(text));
    } else {
      collect(child, depth + 1);
    }
  }
}

void SvgStyles::parse(std::string text) {
  for (std::size_t open; (open = text.find("/*")) != std::string::npos;) {
    const std::size_t close = text.find("*/", open + 2);
    text.erase(open, close == std::string::npos ? std::string::npos : close + 2 - open);
  }
  std::string_view rest = text;
  while (true) {
    const std::size_t open = rest.find('{'), close = rest.find('}', open == std::string_view::npos ? 0 : open);
    if (open == std::string_view::npos || close == std::string_view::npos) return;
    std::string_view selectors = rest.substr(0, open);
    const std::string declarations(rest.substr(open + 1, close - open - 1));
    while (!selectors.empty()) {
      const std::size_t comma = std::min(selectors.find(','), selectors.size());
      add(trimmed_style(selectors.substr(0, comma)), declarations);
      selectors.remove_prefix(std::min(comma + 1, selectors.size()));
    }
    rest.remove_prefix(close + 1);
  }
}

void SvgStyles::add(std::string_view selector, const std::string& declarations) {
  if (selector.empty() || selector.find_first_of(" \t\r\n>+~[:@") != std::string_view::npos) return;
  Rule rule;
  rule.declarations = declarations;
  while (!selector.empty()) {
    const char kind = selector[0] == '.' || selector[0] == '#' ? selector[0] : ' ';
    if (kind != ' ') selector.remove_prefix(1);
    const std::size_t end = std::min(selector.find_first_of(".#"), selector.size());
    const std::string word(selector.substr(0, end));
    if (kind == '.') rule.classes.push_back(word);
    if (kind == '#') rule.id = word;
    if (kind == ' ' && word != "*") rule.element = word;
    selector.remove_prefix(end);
  }
  rules_.push_back(std::move(rule));
}

SvgLook SvgStyles::look(const pugi::xml_node& node, const SvgLook& outer) const {
  SvgLook own{outer.stroke, outer.fill, false};
  for (const char* property : {"stroke", "fill", "display"})
    if (const pugi::xml_attribute given = node.attribute(property)) declare(own, property, lower(given.value()));
  for (const Rule& rule : rules_)
    if (rule.of(node))
      for_declarations(rule.declarations, [&](const std::string& p, const std::string& v) { declare(own, p, v); });
  for_declarations(node.attribute("style").value(),
                   [&](const std::string& p, const std::string& v) { declare(own, p, v); });
  return own;
}

}  // namespace findspace::io
