// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The verb `serve`: requests on standard input, a line each, answers on standard output. It ends with its input.
#include <fmt/format.h>

#include <cstdio>
#include <iostream>
#include <string>

#include "common/commands.h"
#include "serve/json_rpc.h"

namespace findspace::app {
namespace {

constexpr std::size_t kMostBytes = std::size_t{64} << 20;  // of a request

/// False at the end of the input. A longer line is read to its end and `whole` is false.
bool read_line(std::string& line, bool& whole) {
  line.clear();
  whole = true;
  std::streambuf& in = *std::cin.rdbuf();
  for (int c = in.sbumpc(); c != std::char_traits<char>::eof(); c = in.sbumpc()) {
    if (c == '\n') return true;
    whole = line.size() < kMostBytes;
    if (whole) line.push_back(char(c));
  }
  return !line.empty();
}

bool print_line(const std::string& line) {
  return line.empty() || (std::fwrite(line.data(), 1, line.size(), stdout) == line.size() &&
                          std::fputc('\n', stdout) != EOF && std::fflush(stdout) == 0);
}

}  // namespace

Outcome run_serve(const Options& options, Reporter&) {
  if (!options.stdio) throw Error(ErrorCode::kUsage, "serve wants --stdio: requests on standard input");
  SceneStore store(options);
  JsonRpc rpc(store, options.time_limit, JsonRpc::Late::kSaid);
  std::string line;
  bool whole = true;
  while (read_line(line, whole)) {
    if (line.find_first_not_of(" \t\r") == line.npos) continue;
    const std::string answer = whole ? rpc.answer(line) : limit_error("null", "the request is longer than 64 MiB");
    if (!print_line(answer)) throw Error(ErrorCode::kFile, "standard output cannot be written");
  }
  return {};
}

}  // namespace findspace::app
