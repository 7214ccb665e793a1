// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "io/write_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>

#include "findspace/error.h"

namespace findspace::io {
namespace {

/// A new file beside the target, removed again unless it is kept.
class Temporary {
 public:
  explicit Temporary(const std::filesystem::path& target) : name_(target.string() + ".XXXXXX") {
    descriptor_ = mkstemp(name_.data());
  }
  ~Temporary() {
    if (descriptor_ >= 0) close(descriptor_);
    if (!kept_ && descriptor_ != kNever) unlink(name_.c_str());
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;

  int descriptor() const { return descriptor_; }

  /// Takes the target's place, with the permissions a plain new file would have.
  bool keep(const std::filesystem::path& target) {
    const mode_t mask = umask(0);
    umask(mask);
    if (fchmod(descriptor_, 0666 & ~mask) != 0) return false;
    const bool closed = close(descriptor_) == 0;
    descriptor_ = kClosed;
    kept_ = closed && rename(name_.c_str(), target.c_str()) == 0;
    return kept_;
  }

 private:
  static constexpr int kNever = -1, kClosed = -2;
  std::string name_;
  int descriptor_ = kNever;
  bool kept_ = false;
};

[[noreturn]] void fail(const std::filesystem::path& path) {
  throw Error(ErrorCode::kFile, std::string("cannot be written: ") + std::strerror(errno), path.string());
}

/// A device or a pipe (/dev/stdout) is written to, not replaced.
bool is_special(const std::filesystem::path& path) {
  std::error_code none;
  const auto status = std::filesystem::status(path, none);
  return std::filesystem::exists(status) && !std::filesystem::is_regular_file(status) &&
         !std::filesystem::is_directory(status);
}

void write_all(int descriptor, const std::filesystem::path& path, std::string_view text) {
  while (!text.empty()) {
    const ssize_t n = ::write(descriptor, text.data(), text.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) fail(path);
    text.remove_prefix(std::size_t(n));
  }
}

class Special {
 public:
  explicit Special(const std::filesystem::path& path) : descriptor_(open(path.c_str(), O_WRONLY | O_CLOEXEC)) {
    if (descriptor_ < 0) fail(path);
  }
  ~Special() { close(descriptor_); }
  Special(const Special&) = delete;
  Special& operator=(const Special&) = delete;
  int descriptor() const { return descriptor_; }

 private:
  int descriptor_;
};

}  // namespace

void write_file(const std::filesystem::path& path, std::string_view text) {
  write_file(path, [&](const Sink& sink) { sink(text); });
}

void write_file(const std::filesystem::path& path, const std::function<void(const Sink&)>& make) {
  if (is_special(path)) {
    const Special file(path);
    return make([&](std::string_view text) { write_all(file.descriptor(), path, text); });
  }
  if (std::filesystem::is_directory(path)) {
    errno = EISDIR;
    fail(path);
  }
  std::error_code none;
  // A link stays a link: what it points to is replaced.
  const std::filesystem::path target =
      std::filesystem::is_symlink(path, none) ? std::filesystem::weakly_canonical(path, none) : path;
  Temporary file(target);
  if (file.descriptor() < 0) fail(path);
  make([&](std::string_view text) { write_all(file.descriptor(), path, text); });
  if (!file.keep(target)) fail(path);
}

}  // namespace findspace::io
