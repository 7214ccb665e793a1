// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/text/spool.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <string>
#include <system_error>
#include <vector>

#include "findspace/error.h"

namespace findspace::io {
namespace {

constexpr std::size_t kAtOnce = std::size_t{1} << 16;

std::string folder() {
  const char* given = std::getenv("TMPDIR");  // NOLINT(concurrency-mt-unsafe): nothing here sets the environment
  return given == nullptr || *given == '\0' ? "/tmp" : given;
}

[[noreturn]] void fail() {
  throw Error(ErrorCode::kFile, fmt::format("a temporary file in the folder '{}' (TMPDIR) cannot be written: {}",
                                            folder(), std::generic_category().message(errno)));
}

/// A file without a name in that folder, so that it ends with the process.
std::FILE* open_nameless() {
  std::string name = folder() + "/findspace.XXXXXX";
  const int descriptor = mkostemp(name.data(), O_CLOEXEC);
  if (descriptor < 0) return nullptr;
  unlink(name.c_str());
  return fdopen(descriptor, "w+b");
}

}  // namespace

void Spool::append(std::string_view text) {
  if (!file_) file_.reset(open_nameless());
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
