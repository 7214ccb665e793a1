// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Text in and out: whole files within a limit, files written whole, and numbers, strings and lists as JSON has them.
// For programs that read what is not trusted and write what the library answered. Guarantee: all bytes up to the end of
// a file, or an Error; no reader sees half a file that is written here; the same value always gives the same text.
// Keywords: sandbox, symbolic link, atomic write, rename, escaping, round trip.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "findspace/files.h"

namespace findspace {

/// The bytes of a regular file, `most_bytes` at most. With a `root`, the file itself lies in this folder, wherever
/// links lead. Error(kFile) where it is missing, no regular file, outside, or cannot be read to its end; Error(kLimit)
/// where it is longer.
std::string read_text(const std::string& path, std::uint64_t most_bytes = kUsualInput, const std::string& root = {});
/// The same of standard input, which may be a pipe.
std::string read_standard_input(std::uint64_t most_bytes = kUsualInput);

/// Where text goes, piece by piece.
using TextSink = std::function<void(std::string_view)>;

/// A file that is to be written.
struct FileText {
  /// Of a file, a device or a pipe.
  std::string path;
  /// All of it, or
  std::string text{};
  /// what gives it piece by piece, where it is too long for memory.
  std::function<void(const TextSink&)> make{};
};

/// Writes all of them or none. Each text goes to a temporary file beside its target; when all are there, devices and
/// pipes get theirs, and the temporary files are renamed over their targets. A failure leaves what was there before,
/// but for one of renaming, of which only a change of the folders meanwhile is left as a cause. A file that is replaced
/// keeps its mode. Error(kFile) with the system's reason; for a read-only one too.
void write_files(const std::vector<FileText>& files);
/// What write_files() has done: nothing yet, a part of what goes to a device, or some of the files, each whole.
enum class Written { kNothing, kPart, kFiles };
/// For a process that ends within write_files(), from a signal handler too: removes its temporary files.
Written remove_unfinished_files() noexcept;

/// As messages show it on a terminal: with "?" for control characters and bytes that are not UTF-8.
std::string printable(std::string_view text);

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
