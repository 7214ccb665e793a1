// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

// Files that are written whole (findspace/text.h).

#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <climits>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>

#include "findspace/error.h"
#include "findspace/text.h"

namespace findspace {
namespace {

// What a signal handler may read. Entries are used again and never freed.

struct Unfinished {
  char name[PATH_MAX];
  std::atomic<bool> stands{false};
  Unfinished* next = nullptr;
};
std::atomic<Unfinished*> unfinished{nullptr};
std::atomic<Written> written_so_far{Written::kNothing};

Unfinished& free_entry() {
  for (Unfinished* e = unfinished.load(); e != nullptr; e = e->next) {
    bool free = false;
    if (e->stands.compare_exchange_strong(free, true)) return *e;
  }
  auto* fresh = new Unfinished;
  fresh->stands = true;
  fresh->next = unfinished.load();
  while (!unfinished.compare_exchange_weak(fresh->next, fresh)) continue;
  return *fresh;
}

/// A file is replaced only where it could be written to itself, and keeps its mode.
struct Target {
  std::filesystem::path path;
  mode_t mode = 0;
};

/// A new file beside the target, removed again unless it is kept.
class Temporary {
 public:
  explicit Temporary(Target target) : target_(std::move(target)), entry_(free_entry()) {
    const std::string name = target_.path.string() + ".XXXXXX";
    if (name.size() >= sizeof(entry_.name)) {
      errno = ENAMETOOLONG;
      return;
    }
    // Signals wait until the name of what stands there is known.
    sigset_t all, before;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    std::memcpy(entry_.name, name.c_str(), name.size() + 1);
    descriptor_ = mkostemp(entry_.name, O_CLOEXEC);
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
  }
  ~Temporary() {
    if (descriptor_ >= 0) close(descriptor_);
    if (!kept_ && descriptor_ != kNever) unlink(entry_.name);
    entry_.stands = false;
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;

  int descriptor() const { return descriptor_; }

  /// All is on the disk, with its permissions.
  bool finish() {
    if (fchmod(descriptor_, target_.mode) != 0) return false;
    const bool closed = close(descriptor_) == 0;
    descriptor_ = kClosed;
    return closed;
  }

  /// Takes the target's place.
  bool keep() {
    written_so_far = Written::kFiles;
    return kept_ = rename(entry_.name, target_.path.c_str()) == 0;
  }

 private:
  static constexpr int kNever = -1, kClosed = -2;
  Target target_;
  Unfinished& entry_;
  int descriptor_ = kNever;
  bool kept_ = false;
};

[[noreturn]] void fail(const std::filesystem::path& path) {
  throw Error(ErrorCode::kFile, std::string("cannot be written: ") + std::generic_category().message(errno),
              path.string());
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
  const TextSink sink = [&](std::string_view text) { write_text(descriptor, file.path, text); };
  file.make ? file.make(sink) : sink(file.text);
}

void write_special(const FileText& file) {
  struct Open {
    int descriptor;
    ~Open() { close(descriptor); }
  };
  const Open out{open(file.path.c_str(), O_WRONLY | O_CLOEXEC)};
  if (out.descriptor < 0) fail(file.path);
  written_so_far = Written::kPart;
  write_all(out.descriptor, file);
}

/// Throws where the file is a folder or may not be written to.
Target target_of(const std::filesystem::path& path) {
  std::error_code none;
  // A link stays a link: what it points to is replaced.
  const bool link = std::filesystem::is_symlink(path, none);
  Target target{link ? std::filesystem::weakly_canonical(path, none) : path, 0};
  struct stat status {};
  if (stat(target.path.c_str(), &status) != 0) {
    const mode_t mask = umask(0);
    umask(mask);
    target.mode = 0666 & ~mask;
    return target;
  }
  constexpr mode_t kWritable = S_IWUSR | S_IWGRP | S_IWOTH, kPermissions = 07777;
  if (S_ISDIR(status.st_mode))
    errno = EISDIR;
  else if ((status.st_mode & kWritable) == 0)  // which root could write to nevertheless
    errno = EACCES;
  else if (access(target.path.c_str(), W_OK) == 0)
    errno = 0;
  if (errno != 0) fail(path);
  target.mode = status.st_mode & kPermissions;
  return target;
}

std::unique_ptr<Temporary> temporary(const FileText& file) {
  auto out = std::make_unique<Temporary>(target_of(file.path));
  if (out->descriptor() < 0) fail(file.path);
  write_all(out->descriptor(), file);
  if (!out->finish()) fail(file.path);
  return out;
}

}  // namespace

Written remove_unfinished_files() noexcept {
  for (const Unfinished* e = unfinished.load(); e != nullptr; e = e->next) {
    if (e->stands) unlink(e->name);
  }
  return written_so_far;
}

void write_files(const std::vector<FileText>& files) {
  std::vector<std::unique_ptr<Temporary>> written;
  for (const FileText& f : files) written.push_back(is_special(f.path) ? nullptr : temporary(f));
  for (const FileText& f : files) {
    if (is_special(f.path)) write_special(f);
  }
  written_so_far = Written::kNothing;  // what went to devices went there whole
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (written[i] && !written[i]->keep()) fail(files[i].path);
  }
}

}  // namespace findspace
