// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "batch/job_journal.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <fstream>
#include <system_error>
#include <thread>

#include "findspace/error.h"
#include "findspace/text.h"

namespace findspace::app {
namespace {

constexpr std::string_view kHead = "{\"job\": ";
constexpr mode_t kMode = 0644;
constexpr char kOpen = 0, kTaken = 1, kAnswered = 2;  // the byte of a question
constexpr int kRemovals = 20;
constexpr std::chrono::milliseconds kBetweenRemovals{50};

[[noreturn]] void fail(const std::filesystem::path& path, const char* what) {
  throw Error(ErrorCode::kFile, fmt::format("{}: {}", what, std::system_category().message(errno)), path.string());
}

/// The number of the question in a line of the journal.
std::size_t job_of(std::string_view line, std::size_t count) {
  std::size_t job = count;
  if (line.starts_with(kHead)) {
    line.remove_prefix(kHead.size());
    std::from_chars(line.data(), line.data() + line.size(), job);
  }
  return job;
}

std::string host() {
  constexpr std::size_t kMost = 256;
  std::array<char, kMost> name{};
  return gethostname(name.data(), kMost - 1) == 0 ? name.data() : "host";
}

std::string bytes_of(const std::filesystem::path& path, std::uint64_t start, std::uint64_t size) {
  std::ifstream in(path, std::ios::binary);
  std::string out(size, '\0');
  in.seekg(static_cast<std::streamoff>(start));
  in.read(out.data(), static_cast<std::streamsize>(size));
  if (static_cast<std::uint64_t>(in.gcount()) != size) fail(path, "cannot be read");
  return out;
}

}  // namespace

std::string result_head(std::size_t job) { return fmt::format("{}{}, ", kHead, job); }

std::string result_line(std::size_t job, std::string_view line) {
  line.remove_prefix(result_head(job).size());
  return "{" + std::string(line);
}

JobJournal::JobJournal(std::filesystem::path results, std::uint64_t digest, std::size_t count)
    : results_(std::move(results)), folder_(results_), where_(count) {
  folder_ += ".parts";
  std::error_code error;
  std::filesystem::create_directory(folder_, error);
  if (error) throw Error(ErrorCode::kFile, error.message(), folder_.string());
  check_owner(digest);
  const auto path = folder_ / "lock";
  lock_file_ = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, kMode);
  if (lock_file_ < 0) fail(path, "cannot be opened");
  refresh();
}

JobJournal::~JobJournal() {
  if (own_file_ >= 0) close(own_file_);
  if (lock_file_ >= 0) close(lock_file_);
}

/// A file without content says whose folder it is: its name is made at once or not at all.
void JobJournal::check_owner(std::uint64_t digest) const {
  const std::string own = fmt::format("of-{:016x}-{}", digest, where_.size());
  bool others = false;
  for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
    const std::string name = entry.path().filename().string();
    if (name == own) return;
    others = others || name.starts_with("of-");
  }
  if (others)
    throw Error(ErrorCode::kBadValue,
                "it keeps results of other questions; remove the folder, or give them a file of their own",
                folder_.string());
  const int file = open((folder_ / own).c_str(), O_CREAT | O_WRONLY | O_CLOEXEC, kMode);
  if (file < 0) fail(folder_ / own, "cannot be made");
  close(file);
}

/// Of the whole process, and gone with it: fcntl(2), "Advisory record locking".
bool JobJournal::lock(std::size_t byte, bool wait) const {
  struct flock range {};
  range.l_type = F_WRLCK;
  range.l_whence = SEEK_SET;
  range.l_start = static_cast<off_t>(byte);
  range.l_len = 1;
  while (fcntl(lock_file_, wait ? F_SETLKW : F_SETLK, &range) != 0) {
    if (errno == EINTR) continue;
    if (errno == EACCES || errno == EAGAIN) return false;
    fail(folder_ / "lock", "cannot be locked");
  }
  return true;
}

void JobJournal::unlock(std::size_t byte) const {
  struct flock range {};
  range.l_type = F_UNLCK;
  range.l_whence = SEEK_SET;
  range.l_start = static_cast<off_t>(byte);
  range.l_len = 1;
  if (fcntl(lock_file_, F_SETLK, &range) != 0) fail(folder_ / "lock", "cannot be unlocked");
}

char JobJournal::state(std::size_t job) const {
  char state = kOpen;
  return pread(lock_file_, &state, 1, static_cast<off_t>(job)) == 1 ? state : kOpen;
}

/// Where the disk does not take it, the question looks as if its process had ended.
void JobJournal::set_state(std::size_t job, char state) const {
  if (pwrite(lock_file_, &state, 1, static_cast<off_t>(job)) != 1 && state == kTaken)
    fail(folder_ / "lock", "cannot be written");
}

bool JobJournal::claim(std::size_t job) {
  if (done(job) || !lock(job, false)) return false;
  const char before = state(job);
  if (before == kTaken) refresh();  // its process ended, perhaps with an answer
  if (before != kAnswered && !done(job) && !over()) {
    if (before == kOpen) set_state(job, kTaken);
    return true;
  }
  unlock(job);
  return false;
}

void JobJournal::open_own() {
  for (int k = 0; own_file_ < 0; ++k) {
    const auto path = folder_ / fmt::format("part-{}-{}-{}.jsonl", host(), getpid(), k);
    own_file_ = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, kMode);
    if (own_file_ < 0 && errno != EEXIST) fail(path, "cannot be made");
    if (own_file_ < 0) continue;
    own_part_ = parts_.size();
    part_of_[path.filename().string()] = own_part_;
    parts_.push_back({path, 0});
  }
}

void JobJournal::record(std::size_t job, std::string_view line) {
  if (own_file_ < 0) open_own();
  std::string text(line);
  text += '\n';
  for (std::size_t written = 0; written < text.size();) {
    const ssize_t n = write(own_file_, text.data() + written, text.size() - written);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) {
      const int reason = n == 0 ? ENOSPC : errno;
      if (ftruncate(own_file_, static_cast<off_t>(own_size_)) != 0) own_file_ = -1;  // the rest is not a whole line
      errno = reason;
      fail(parts_[own_part_].path, "cannot be written");
    }
    written += static_cast<std::size_t>(n);
  }
  note(job, {static_cast<int>(own_part_), own_size_, line.size()});
  own_size_ += text.size();
  parts_[own_part_].read = own_size_;
  set_state(job, kAnswered);
  unlock(job);
}

void JobJournal::note(std::size_t job, Place place) {
  if (job >= where_.size() || done(job)) return;
  where_[job] = place;
  ++done_;
}

/// Whole lines only: what follows the last end of a line was being written.
void JobJournal::read_part(std::size_t k) {
  std::error_code error;
  const std::uint64_t size = std::filesystem::file_size(parts_[k].path, error);
  if (error || size <= parts_[k].read) return;
  const std::uint64_t start = parts_[k].read;
  const std::string text = bytes_of(parts_[k].path, start, size - start);
  std::size_t from = 0;
  for (std::size_t end = text.find('\n'); end != text.npos; end = text.find('\n', from)) {
    note(job_of(std::string_view(text).substr(from, end - from), where_.size()),
         {static_cast<int>(k), start + from, end - from});
    from = end + 1;
  }
  parts_[k].read = start + from;
}

void JobJournal::refresh() {
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder_, error)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with("part-")) continue;
    const auto [found, fresh] = part_of_.emplace(name, parts_.size());
    if (fresh) parts_.push_back({entry.path(), 0});
    const std::size_t k = found->second;
    if (own_file_ < 0 || k != own_part_) read_part(k);
  }
}

std::string JobJournal::result(std::size_t job) const {
  const Place& place = where_[job];
  return result_line(job, bytes_of(parts_[static_cast<std::size_t>(place.part)].path, place.start, place.size));
}

bool JobJournal::over() const {
  struct stat state {};
  return fstat(lock_file_, &state) != 0 || state.st_nlink == 0;
}

void JobJournal::finish() {
  lock(where_.size(), true);
  if (over()) return;
  write_files({{results_, {}, [this](const TextSink& sink) {
                  for (std::size_t k = 0; k < where_.size(); ++k) sink(result(k) + "\n");
                }}});
  std::error_code error;
  std::filesystem::remove(folder_ / "lock", error);  // first: from now on it is over for the others
  for (int k = 0; k < kRemovals; ++k) {              // a worker of another process may just have made its store there
    std::filesystem::remove_all(folder_, error);
    if (!error) return;
    std::this_thread::sleep_for(kBetweenRemovals);
  }
  throw Error(ErrorCode::kFile, error.message(), folder_.string());
}

}  // namespace findspace::app
