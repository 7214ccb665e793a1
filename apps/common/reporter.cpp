// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "common/reporter.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <string>

namespace findspace::app {
namespace {

bool wants_colour() {
  // Nothing here sets the environment.
  const char* no = std::getenv("NO_COLOR");  // NOLINT(concurrency-mt-unsafe)
  const char* term = std::getenv("TERM");    // NOLINT(concurrency-mt-unsafe)
  return (no == nullptr || *no == '\0') && !(term != nullptr && std::string_view(term) == "dumb");
}

/// With control characters as \xNN, but for ends of lines: a file may hold any.
std::string visible(std::string_view text) {
  std::string out;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte < ' ' && c != '\n') || byte == 0x7f)
      out += fmt::format("\\x{:02x}", byte);
    else
      out += c;
  }
  return out;
}

/// Without the end of what nobody would read: a name may be as long as a file.
std::string cut(std::string text) {
  constexpr std::size_t kLongest = 6000;
  if (text.size() <= kLongest) return text;
  std::size_t end = kLongest;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) --end;
  const std::size_t left = text.size() - end;
  text.resize(end);
  return text + fmt::format("... ({} more bytes)", left);
}

void say(std::string_view text) { std::fwrite(text.data(), 1, text.size(), stderr); }

}  // namespace

Reporter::Reporter(bool quiet)
    : quiet_(quiet), terminal_(isatty(STDERR_FILENO) == 1), colour_(terminal_ && wants_colour()) {}

Reporter::Reporter(std::vector<std::string>& notes) : quiet_(true), terminal_(false), colour_(false), notes_(&notes) {}

Reporter::~Reporter() { stage(""); }

void Reporter::note(std::string_view text) {
  stage("");
  if (notes_ != nullptr) notes_->emplace_back(text);
  if (!quiet_) say(fmt::format("{}note:{} {}\n", colour_ ? "\033[36m" : "", colour_ ? "\033[0m" : "", text));
}

void Reporter::error(std::string_view text) {
  stage("");
  say(fmt::format("{}findspace:{} {}\n", colour_ ? "\033[1;31m" : "", colour_ ? "\033[0m" : "", text));
}

void Reporter::error(const Error& e) {
  error(cut(visible(e.place().empty() ? e.message() : e.place() + ": " + e.message())));
  for (const auto& p : e.geometry()) say(fmt::format("  at ({}, {})\n", p[0], p[1]));
}

void Reporter::stage(std::string_view text) {
  if (!terminal_ || quiet_ || (text.empty() && !staged_)) return;
  say(fmt::format("\r\033[K{}", text));
  staged_ = !text.empty();
  std::fflush(stderr);
}

}  // namespace findspace::app
