// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/text/spool.h"

#include <cerrno>
#include <cstring>
#include <string>
#include <vector>

#include "findspace/error.h"

namespace findspace::io {
namespace {

constexpr std::size_t kAtOnce = std::size_t{1} << 16;

[[noreturn]] void fail() {
  throw Error(ErrorCode::kFile, std::string("a temporary file cannot be written: ") + std::strerror(errno));
}

}  // namespace

void Spool::append(std::string_view text) {
  if (!file_) file_.reset(std::tmpfile());
  if (!file_ || std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size()) fail();
  size_ += text.size();
}

void Spool::copy_to(const Sink& sink) const {
  if (!file_) return;
  if (std::fflush(file_.get()) != 0 || std::fseek(file_.get(), 0, SEEK_SET) != 0) fail();
  std::vector<char> part(kAtOnce);
  while (const std::size_t n = std::fread(part.data(), 1, part.size(), file_.get())) sink({part.data(), n});
  if (std::ferror(file_.get()) != 0 || std::fseek(file_.get(), 0, SEEK_END) != 0) fail();
}

}  // namespace findspace::io
