// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "io/api/edited_scene.h"

#include <algorithm>

#include "findspace/text.h"
#include "io/text/json_tree.h"

namespace findspace::io {
namespace {

std::size_t offset_of(const std::string& text, int line, int column) {
  std::size_t at = 0;
  for (int k = 1; k < line; ++k) at = text.find('\n', at) + 1;
  return at + std::size_t(column) - 1;
}

/// Behind the string that begins at `at`.
std::size_t end_of_string(const std::string& text, std::size_t at) {
  for (++at; at < text.size() && text[at] != '"'; ++at)
    if (text[at] == '\\') ++at;
  return at + 1;
}

/// Behind the string or comment that begins at `at`, or the next letter.
std::size_t after(const std::string& text, std::size_t at) {
  if (text[at] == '"') return end_of_string(text, at);
  if (text.compare(at, 2, "//") == 0) return std::min(text.find('\n', at), text.size());
  if (text.compare(at, 2, "/*") == 0) return std::min(text.find("*/", at), text.size() - 2) + 2;
  return at + 1;
}

/// Behind the value that begins at `at`: a string, or a list of strings.
std::size_t end_of_value(const std::string& text, std::size_t at) {
  if (text[at] == '"') return end_of_string(text, at);
  for (++at; at < text.size() && text[at] != ']';) at = after(text, at);
  return at + 1;
}

/// The text with `value` under a key of the scene, which may not have been there.
std::string with_key(const std::string& text, const std::string& key, const std::string& value) {
  plane::WorkBudget work;
  const JsonTree tree = parse_json(text, "scene", work);
  const JsonValue& scene = tree.root();
  const JsonValue* old = scene.find(key);
  if (old == nullptr) {
    const std::size_t brace = offset_of(text, scene.line, scene.column) + 1;
    return text.substr(0, brace) + "\n  \"" + key + "\": " + value + "," + text.substr(brace);
  }
  const std::size_t from = offset_of(text, old->line, old->column);
  return text.substr(0, from) + value + text.substr(end_of_value(text, from));
}

/// The text without a key of the scene, and without the comma before it, or behind it where it is the first.
std::string without_key(const std::string& text, const std::string& key) {
  plane::WorkBudget work;
  const JsonTree tree = parse_json(text, "scene", work);
  const JsonValue& scene = tree.root();
  const JsonValue* old = scene.find(key);
  if (old == nullptr) return text;
  const std::size_t value = offset_of(text, old->line, old->column), end = end_of_value(text, value);
  std::size_t begin = 0, comma = text.npos, next = end;
  for (std::size_t at = 0; at < value; at = after(text, at)) {
    if (text[at] == '"') begin = at;
    if (text[at] == ',') comma = at;
  }
  if (comma != text.npos) return text.substr(0, comma) + text.substr(comma + 1, begin - comma - 1) + text.substr(end);
  while (text[next] != ',' && text[next] != '}') next = after(text, next);
  return text.substr(0, begin) + text.substr(end, next - end) + text.substr(text[next] == ',' ? next + 1 : next);
}

}  // namespace

std::string edited_scene(const std::string& text, const std::string& key, const std::vector<std::string>& values) {
  if (values.empty()) return without_key(text, key);
  return with_key(text, key, values.size() == 1 ? json_string(values[0]) : json_list(values, json_string));
}

}  // namespace findspace::io
