// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "common/board_groups.h"

#include <findspace/error.h>
#include <fmt/format.h>

#include <algorithm>

namespace findspace::app {
namespace {

/// "power=U3,C7,C8".
BoardGroup group_of(const std::string& text) {
  const std::size_t is = text.find('=');
  BoardGroup out{text.substr(0, is), {}};
  for (std::size_t at = is; at != text.npos;) {
    const std::size_t end = text.find(',', at + 1);
    out.parts.push_back(text.substr(at + 1, end == text.npos ? end : end - at - 1));
    at = end;
  }
  const bool has_empty = std::find(out.parts.begin(), out.parts.end(), "") != out.parts.end();
  if (out.name.empty() || out.parts.empty() || has_empty)
    throw Error(ErrorCode::kUsage, fmt::format("--group {}: NAME=PART,PART is meant, such as power=U3,C7", text));
  return out;
}

}  // namespace

std::vector<BoardGroup> asked_groups(const Options& options) {
  std::vector<BoardGroup> out;
  for (const std::string& text : options.groups) out.push_back(group_of(text));
  return out;
}

}  // namespace findspace::app
