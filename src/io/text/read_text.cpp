// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/text/read_text.h"

#include <fstream>
#include <sstream>

#include "findspace/error.h"

namespace findspace::io {

std::string read_text(const std::filesystem::path& path) {
  std::error_code code;
  if (std::filesystem::is_directory(path, code))
    throw Error(ErrorCode::kFile, "this is a folder, not a file", path.string());
  std::ifstream in(path, std::ios::binary);
  if (!in) throw Error(ErrorCode::kFile, "there is no such file, or it may not be read", path.string());
  std::ostringstream text;
  text << in.rdbuf();
  if (in.bad()) throw Error(ErrorCode::kFile, "reading failed", path.string());
  return std::move(text).str();
}

}  // namespace findspace::io
