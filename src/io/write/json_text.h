// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What the writers of JSON share: pieces of text between the numbers and strings of write_json.h.
#pragma once

#include <fmt/format.h>

#include <optional>
#include <string>
#include <string_view>

#include "findspace/text.h"
#include "io/text/put.h"
#include "io/text/spool.h"
#include "io/write/write_json.h"

namespace findspace::io {

inline const char* truth(bool value) { return value ? "true" : "false"; }
inline std::string number(const std::optional<double>& value) { return value ? json_number(*value) : "null"; }

/// The key "unit" with a comma, or nothing.
inline std::string unit_key(std::string_view unit) {
  return unit.empty() ? "" : fmt::format("\"unit\": {}, ", json_string(unit));
}

/// Appends items separated by commas, each on its own line where `lines`.
template <class Items, class Text>
void put_list(std::string& out, const Items& items, Text text, bool lines = false) {
  out += json_list(items, text, lines);
}
template <class Items, class Text>
std::string list(const Items& items, Text text, bool lines = false) {
  return json_list(items, text, lines);
}

/// Text that may be longer than memory should hold: it goes on whenever there is enough of it.
class FlowingText {
 public:
  explicit FlowingText(const Sink& sink) : sink_(sink) {}

  std::string& text() { return text_; }
  void flow() {
    constexpr std::size_t kEnough = std::size_t(1) << 16;
    if (text_.size() > kEnough) finish();
  }
  void finish() {
    sink_(text_);
    text_.clear();
  }

 private:
  const Sink& sink_;
  std::string text_;
};

/// The same list as put_list() gives, of what put_item(item) appends to the text.
template <class Items, class PutItem>
void put_items(FlowingText& out, const Items& items, PutItem put_item, bool lines = false) {
  out.text() += "[";
  const char* separator = lines ? "\n      " : "";
  for (const auto& item : items) {
    out.text() += separator;
    put_item(item);
    separator = lines ? ",\n      " : ", ";
    out.flow();
  }
  out.text() += "]";
}

/// What a summary of a set says whatever its dimension: its kind, then `measures`, its points, box and components.
template <class Summary, class Point, class Box, class Component>
void put_set(std::string& out, int dimension, const Summary& s, std::string_view unit, const std::string& measures,
             const Point& point, const Box& box, const Component& component) {
  put(out, R"(  "dimension": {}, "empty": {}, "whole": {}, "bounded": {},)", dimension, truth(s.empty), truth(s.whole),
      truth(s.bounded));
  put(out, "\n  \"open\": {}, \"closed\": {}, \"regular\": {},\n", truth(s.open), truth(s.closed), truth(s.regular));
  if (!unit.empty()) put(out, "  \"unit\": {},\n", json_string(unit));
  put(out, "{}, \"holes\": {},\n", measures, s.holes);
  put(out, "  \"isolated\": {}, \"bbox\": {},\n", list(s.isolated, point), box(s.bbox));
  put(out, "  \"components\": {},\n", list(s.components, component, true));
}

/// The members of a best value on a line of their own.
inline void put_optimum(std::string& out, const distance::OptimalValue& best) {
  put(out, "  {}\n", optimum_members(best));
}

}  // namespace findspace::io
