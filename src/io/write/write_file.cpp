// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "io/write/write_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <memory>
#include <system_error>

#include "findspace/error.h"

namespace findspace::io {
namespace {

/// A new file beside the target, removed again unless it is kept.
class Temporary {
 public:
  explicit Temporary(std::filesystem::path target) : target_(std::move(target)), name_(target_.string() + ".XXXXXX") {
    descriptor_ = mkstemp(name_.data());
  }
  ~Temporary() {
    if (descriptor_ >= 0) close(descriptor_);
    if (!kept_ && descriptor_ != kNever) unlink(name_.c_str());
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;

  int descriptor() const { return descriptor_; }

  /// All is on the disk, with the permissions a plain new file would have.
  bool finish() {
    const mode_t mask = umask(0);
    umask(mask);
    if (fchmod(descriptor_, 0666 & ~mask) != 0) return false;
    const bool closed = close(descriptor_) == 0;
    descriptor_ = kClosed;
    return closed;
  }

  /// Takes the target's place.
  bool keep() { return kept_ = rename(name_.c_str(), target_.c_str()) == 0; }

 private:
  static constexpr int kNever = -1, kClosed = -2;
  std::filesystem::path target_;
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

void write_text(int descriptor, const std::filesystem::path& path, std::string_view text) {
  while (!text.empty()) {
    const ssize_t n = ::write(descriptor, text.data(), text.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) fail(path);
    text.remove_prefix(std::size_t(n));
  }
}

void write_all(int descriptor, const FileText& file) {
  const Sink sink = [&](std::string_view text) { write_text(descriptor, file.path, text); };
  file.make ? file.make(sink) : sink(file.text);
}

void write_special(const FileText& file) {
  struct Open {
    int descriptor;
    ~Open() { close(descriptor); }
  };
  const Open out{open(file.path.c_str(), O_WRONLY | O_CLOEXEC)};
  if (out.descriptor < 0) fail(file.path);
  write_all(out.descriptor, file);
}

std::unique_ptr<Temporary> temporary(const FileText& file) {
  if (std::filesystem::is_directory(file.path)) {
    errno = EISDIR;
    fail(file.path);
  }
  std::error_code none;
  // A link stays a link: what it points to is replaced.
  const bool link = std::filesystem::is_symlink(file.path, none);
  auto out = std::make_unique<Temporary>(link ? std::filesystem::weakly_canonical(file.path, none) : file.path);
  if (out->descriptor() < 0) fail(file.path);
  write_all(out->descriptor(), file);
  if (!out->finish()) fail(file.path);
  return out;
}

}  // namespace

void write_files(const std::vector<FileText>& files) {
  std::vector<std::unique_ptr<Temporary>> written;
  for (const FileText& f : files) written.push_back(is_special(f.path) ? nullptr : temporary(f));
  for (const FileText& f : files) {
    if (is_special(f.path)) write_special(f);
  }
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (written[i] && !written[i]->keep()) fail(files[i].path);
  }
}

}  // namespace findspace::io
