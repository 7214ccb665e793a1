// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/text/read_text.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>

#include "findspace/error.h"

namespace findspace {
namespace io {
namespace {

constexpr std::size_t kReadAtOnce = std::size_t{1} << 20;

[[noreturn]] void fail_file(const std::string& message, const std::string& name) {
  throw Error(ErrorCode::kFile, message, name);
}

[[noreturn]] void fail_too_long(std::uint64_t most, const std::string& name) {
  throw Error(ErrorCode::kLimit, fmt::format("more than {} bytes of input, which --input-limit raises", most), name);
}

/// Closes what it holds.
struct Descriptor {
  int number;
  ~Descriptor() {
    if (number >= 0) close(number);
  }
};

void require_regular(const struct stat& status, const std::string& name) {
  if (S_ISDIR(status.st_mode)) fail_file("this is a folder, not a file", name);
  if (!S_ISREG(status.st_mode))
    fail_file("this is not a regular file (a scene of - is read from standard input)", name);
}

/// What is open there, not what its name may mean by now.
std::filesystem::path place_of(const Descriptor& file, const std::filesystem::path& path) {
  std::error_code none;
  const auto open_files = std::filesystem::path("/proc/self/fd");
  const auto place = std::filesystem::read_symlink(open_files / std::to_string(file.number), none);
  return none ? std::filesystem::canonical(path, none) : place;
}

void require_inside(const std::filesystem::path& place, const std::filesystem::path& root, const std::string& name) {
  std::error_code none;
  const std::filesystem::path folder = std::filesystem::canonical(root, none);
  if (none) fail_file(fmt::format("the folder '{}' of --root cannot be found", root.string()), name);
  const auto [end, rest] = std::mismatch(folder.begin(), folder.end(), place.begin(), place.end());
  if (place.empty() || end != folder.end())
    fail_file(fmt::format("the file lies outside the folder '{}', and others may not be read", root.string()), name);
}

/// Else what follows would not be seen.
std::string with_seen_nul(const std::string& name) {
  std::string shown;
  for (const char c : name) shown += c == '\0' ? std::string("\\x00") : std::string(1, c);
  return shown;
}

Descriptor open_regular(const std::filesystem::path& path, const std::filesystem::path& root) {
  const std::string name = path.string();
  if (name.find('\0') != std::string::npos) fail_file("a file name with a NUL byte", with_seen_nul(name));
  std::error_code none;
  if (!root.empty()) require_inside(std::filesystem::weakly_canonical(path, none), root, name);
  struct stat status {};
  if (stat(name.c_str(), &status) != 0) fail_file("there is no such file, or it may not be read", name);
  require_regular(status, name);
  Descriptor file{open(name.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY)};
  if (file.number < 0) fail_file("there is no such file, or it may not be read", name);
  if (fstat(file.number, &status) != 0) fail_file("there is no such file, or it may not be read", name);
  require_regular(status, name);
  if (!root.empty()) require_inside(place_of(file, path), root, name);
  const int number = file.number;
  file.number = -1;
  return {number};
}

/// `expected`: how many bytes there seem to be.
std::string read_all(int descriptor, std::uint64_t most, std::uint64_t expected, const std::string& name) {
  std::string text;
  const std::uint64_t room = std::max(most, most + 1);  // a byte too many shows; the greatest number has no next
  for (std::size_t size = 0;;) {
    if (size == text.size())
      text.resize(std::min<std::uint64_t>(std::max<std::uint64_t>(expected + 1, size * 2), room));
    const ssize_t n = read(descriptor, text.data() + size, text.size() - size);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) fail_file(fmt::format("it cannot be read to its end: {}", std::generic_category().message(errno)), name);
    size += static_cast<std::size_t>(n);
    if (size > most) fail_too_long(most, name);
    if (n > 0) continue;
    text.resize(size);
    return text;
  }
}

std::string read_file(const std::filesystem::path& path, std::uint64_t most_bytes, const std::filesystem::path& root) {
  const Descriptor file = open_regular(path, root);
  struct stat status {};
  const std::uint64_t size =
      fstat(file.number, &status) == 0 ? static_cast<std::uint64_t>(status.st_size) : kReadAtOnce;
  if (size > most_bytes) fail_too_long(most_bytes, path.string());
  return read_all(file.number, most_bytes, size, path.string());
}

std::string by_reader(const std::function<std::string()>& read) {
  const TextReader* const reader = ReadTextBy::now();
  return reader == nullptr ? read() : (*reader)(read);
}

}  // namespace
}  // namespace io

std::string read_text(const std::string& path, std::uint64_t most_bytes, const std::string& root) {
  return io::by_reader([&] { return io::read_file(path, most_bytes, root); });
}

std::string read_standard_input(std::uint64_t most_bytes) {
  return io::by_reader([&] { return io::read_all(STDIN_FILENO, most_bytes, io::kReadAtOnce, "standard input"); });
}

}  // namespace findspace
