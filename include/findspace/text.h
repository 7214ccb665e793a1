// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Text in and out: whole files within a limit, and numbers, strings and lists as JSON has them. For programs that read
// what is not trusted and write what the library answered. Guarantee: all bytes up to the end of a file, or an Error;
// the same value always gives the same text. Keywords: sandbox, symbolic link, escaping, round trip.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "findspace/files.h"

namespace findspace {

/// The bytes of a regular file, `most_bytes` at most. With a `root`, the file itself lies in this folder, wherever
/// links lead. Error(kFile) where it is missing, no regular file, outside, or cannot be read to its end; Error(kLimit)
/// where it is longer.
std::string read_text(const std::string& path, std::uint64_t most_bytes = kUsualInput, const std::string& root = {});
/// The same of standard input, which may be a pipe.
std::string read_standard_input(std::uint64_t most_bytes = kUsualInput);

/// "0.1", "3", "1e-07": the shortest decimal that reads back as the same double; "-inf" (quoted) for minus infinity,
/// null for what no number is.
std::string json_number(double value);
/// With quotes; control characters, quotes and backslashes escaped.
std::string json_string(std::string_view text);
/// What text(item) gives of each item, in brackets; on lines of their own if `lines`.
template <class Items, class Text>
std::string json_list(const Items& items, const Text& text, bool lines = false) {
  std::string out = "[";
  const char* separator = lines ? "\n      " : "";
  for (const auto& item : items) {
    out.append(separator).append(text(item));
    separator = lines ? ",\n      " : ", ";
  }
  return out + "]";
}

}  // namespace findspace
