// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A whole file as bytes: the only place that opens files to read them. Guarantee: all bytes up to the end of the file,
// or an Error. Only regular files are opened, so that nothing waits and nothing is endless. Keywords: fstat, FIFO,
// symbolic link, directory traversal.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "findspace/files.h"

namespace findspace::io {

/// The bytes of a regular file, `most_bytes` at most. With a `root`, the file itself lies in this folder, wherever
/// links lead. Throws Error: kFile where it is missing, no regular file, outside, or cannot be read to its end; kLimit
/// where it is longer.
std::string read_text(const std::filesystem::path& path, std::uint64_t most_bytes = kUsualInput,
                      const std::filesystem::path& root = {});

/// The same of standard input, which may be a pipe.
std::string read_standard_input(std::uint64_t most_bytes = kUsualInput);

/// Gives the text that the function reads, or another process's: one that reads files for several.
using TextReader = std::function<std::string(const std::function<std::string()>& read)>;

/// While it lives, this thread gets all texts of files by way of the reader. Null: it reads them itself.
class ReadTextBy {
 public:
  explicit ReadTextBy(const TextReader* reader);
  ~ReadTextBy();
  ReadTextBy(const ReadTextBy&) = delete;
  ReadTextBy& operator=(const ReadTextBy&) = delete;

 private:
  const TextReader* before_;
};

}  // namespace findspace::io
