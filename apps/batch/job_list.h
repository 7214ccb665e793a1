// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The questions of `findspace batch`: a JSON object a line, with a verb, its scene and its options in the words of the
// command line. A line that is not a question is a job as well: its result says what is wrong with it.
// Cost: linear in the text; one line at a time is held as a tree. Keywords: JSON Lines, NDJSON, job array.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "findspace/files.h"

namespace findspace::app {

/// One question. Where `fault` is not empty, the line is none, and that is why.
struct Job {
  std::string id;        // as JSON; "": it has none
  std::size_t line = 0;  // in the file, from 1, empty lines included
  std::string verb;
  std::vector<std::string> arguments;  // of the command line, after the verb
  std::optional<std::string> scene;    // the scene itself, where the line holds it
  std::string fault;
};

class JobList {
 public:
  /// Throws Error(kFile), and Error(kBadValue) where there is no line or two have one id.
  JobList(const std::filesystem::path& path, std::uint64_t input_limit);

  std::size_t size() const { return lines_.size(); }
  Job job(std::size_t k) const;
  /// Says which questions these are: of two files it differs unless they hold the same bytes (64 bits, FNV-1a).
  std::uint64_t digest() const { return digest_; }
  /// The folder that paths of questions start from.
  const std::filesystem::path& folder() const { return folder_; }

 private:
  struct Line {
    std::size_t number, start, size;
  };
  std::string text_;
  std::vector<Line> lines_;
  std::filesystem::path folder_;
  std::uint64_t digest_ = 0;
};

}  // namespace findspace::app
