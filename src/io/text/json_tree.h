// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// JSON as a tree that forgets nothing: every number keeps its text (a decimal is read exactly, never through a
// double) and every value its line and column, so that a mistake is reported where it stands.
// `//` and `/* */` comments are allowed. Refused: duplicate keys, more than 200 levels, NaN and infinity, text after
// the end. Cost: linear in the text.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "plane/base/work_budget.h"

namespace findspace::io {

struct JsonValue {
  enum class Kind { kNull, kBoolean, kNumber, kString, kArray, kObject };
  Kind kind = Kind::kNull;
  bool boolean = false;
  int line = 0, column = 0;       // from 1, in bytes
  std::string text;               // kString: the value; kNumber: as written
  std::vector<std::string> keys;  // kObject: in the order of the file
  std::vector<JsonValue> items;   // kArray: the items; kObject: the values, one for each key

  bool is(Kind k) const { return kind == k; }
  std::size_t size() const { return items.size(); }
  /// The value under `key`, or null when there is none.
  const JsonValue* find(std::string_view key) const;
  /// "a list", "a number", ... for messages.
  const char* kind_name() const;
};

/// Throws Error(kSyntax) at "name:line:column", and kLimit where there are too many values: one costs kJsonValue units.
JsonValue parse_json(std::string_view text, const std::string& name, plane::WorkBudget& work);
inline constexpr std::uint64_t kJsonValue = 2;

}  // namespace findspace::io
