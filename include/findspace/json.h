// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// JSON as a tree that forgets nothing, for programs that take questions as JSON: every number keeps its text, so that a
// decimal can be read exactly, and every value its place, so that a mistake is reported where it stands. Comments of
// C++ are allowed. Refused: duplicate keys, more than 200 levels, NaN and infinity, text after the end.
// Cost: linear in the text. Keywords: parser, number as string, line and column.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "findspace/files.h"

namespace findspace {

/// A value, with all that it holds.
struct JsonValue {
  /// What JSON has.
  enum class Kind { kNull, kBoolean, kNumber, kString, kArray, kObject };
  /// Which of these it is.
  Kind kind = Kind::kNull;
  bool boolean = false;             // of kBoolean
  int line = 0;                     // where it begins, from 1
  int column = 0;                   // the same in the line, in bytes
  std::string text{};               // of kString the value, of kNumber as written
  std::vector<std::string> keys{};  // of kObject, in the order of the file
  std::vector<JsonValue> items{};   // of kArray; of kObject the values, one for each key

  /// Whether it is of that kind.
  bool is(Kind k) const { return kind == k; }
  /// Of its items.
  std::size_t size() const { return items.size(); }
  /// The value under the key, or null where there is none.
  const JsonValue* find(std::string_view key) const;
  /// "a list", "a number", ... for messages.
  const char* kind_name() const;
};

/// Error(kSyntax) at "name:line:column", and kLimit where there are too many values: one costs two units of work.
JsonValue read_json(std::string_view text, const std::string& name = "json", std::uint64_t work_limit = kUsualWork);

}  // namespace findspace
