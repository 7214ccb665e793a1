// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "io/store/result_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sqlite3.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>

#include "findspace/error.h"

namespace findspace::io {
namespace {

constexpr int kFormat = 2;
constexpr int kBusyMilliseconds = 2000;
constexpr std::uint64_t kPage = 4096, kLeastPages = 64;
constexpr std::uint64_t kLargestShare = 8;  // of the limit, one over that: an entry at most
constexpr int kMostAnew = 3;
constexpr mode_t kStoreMode = 0644;
constexpr std::uint64_t kNewFileByte = std::uint64_t{1} << 62;  // of the lock on the whole store

constexpr const char* kSchema =
    "CREATE TABLE IF NOT EXISTS entry(id INTEGER PRIMARY KEY AUTOINCREMENT, hash INTEGER NOT NULL, version TEXT NOT "
    "NULL, content BLOB NOT NULL, result BLOB NOT NULL, sum INTEGER NOT NULL);"
    "CREATE INDEX IF NOT EXISTS by_hash ON entry(hash);";
constexpr const char* kFind = "SELECT id, content, result, sum FROM entry WHERE hash = ?1 AND version = ?2";
constexpr const char* kInsert = "INSERT INTO entry(hash, version, content, result, sum) VALUES(?1, ?2, ?3, ?4, ?5)";
constexpr const char* kDrop = "DELETE FROM entry WHERE id = ?1";
constexpr const char* kThinOut = "DELETE FROM entry WHERE id <= (SELECT min(id) + (max(id) - min(id)) / 4 FROM entry)";

const std::string& version() {
  static const std::string text = fmt::format("{} {}", FINDSPACE_VERSION, kFormat);
  return text;
}

/// FNV-1a. Every step is one to one, so a single byte that differs is always seen.
std::uint64_t hash_on(std::uint64_t hash, std::string_view text) {
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return hash;
}
std::uint64_t hash_of(std::string_view text) { return hash_on(0xcbf29ce484222325, text); }
std::int64_t sum_of(std::string_view content, std::string_view result) {
  return static_cast<std::int64_t>(hash_on(hash_on(~hash_of(version()), content), result));
}

std::string_view blob(sqlite3_stmt* row, int column) {
  const auto* const data = static_cast<const char*>(sqlite3_column_blob(row, column));
  return {data, data == nullptr ? 0 : static_cast<std::size_t>(sqlite3_column_bytes(row, column))};
}

void bind_blob(sqlite3_stmt* statement, int place, std::string_view bytes) {
  sqlite3_bind_blob64(statement, place, bytes.data(), bytes.size(), SQLITE_STATIC);
}

std::string machine() {
  constexpr std::size_t kMost = 256;
  std::array<char, kMost> name{};
  return gethostname(name.data(), kMost - 1) == 0 ? name.data() : "host";
}

bool is_broken(int code) {
  const int primary = code & 0xff;
  return primary == SQLITE_CORRUPT || primary == SQLITE_NOTADB || primary == SQLITE_FORMAT;
}

}  // namespace

ResultFile::ResultFile(const std::filesystem::path& folder, std::uint64_t limit)
    : path_(folder / (machine() + ".sqlite")), limit_(limit) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw Error(ErrorCode::kFile, fmt::format("the store: {}", error.message()), folder.string());
  const auto claims = folder / (machine() + ".claims");
  claims_ = ::open(claims.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, kStoreMode);
  if (claims_ < 0)
    throw Error(ErrorCode::kFile, fmt::format("the store: {}", std::system_category().message(errno)), claims.string());
  set_lock(kNewFileByte, F_WRLCK, true);  // SQLite does not wait while another process makes the file
  open();
  set_lock(kNewFileByte, F_UNLCK, false);
  if (data_ != nullptr || begun_anew_ > 0) return;
  ::close(claims_);
  throw Error(ErrorCode::kFile, "the store can be neither opened nor made", path_.string());
}

ResultFile::~ResultFile() {
  close();
  if (claims_ >= 0) ::close(claims_);
}

void ResultFile::Closer::operator()(sqlite3* data) const { sqlite3_close(data); }
void ResultFile::Closer::operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }

void ResultFile::close() {
  for (Statement* statement : {&find_, &insert_, &drop_, &thin_out_}) statement->reset();
  data_.reset();
}

bool ResultFile::do_all(const char* commands) {
  const int code = sqlite3_exec(data_.get(), commands, nullptr, nullptr, nullptr);
  note(code);
  return code == SQLITE_OK;
}

bool ResultFile::prepare(const char* command, Statement& statement) {
  sqlite3_stmt* made = nullptr;
  const int code = sqlite3_prepare_v3(data_.get(), command, -1, SQLITE_PREPARE_PERSISTENT, &made, nullptr);
  statement.reset(made);
  if (code != SQLITE_OK) note(code);
  return code == SQLITE_OK;
}

bool ResultFile::open() {
  const int anew = begun_anew_;
  sqlite3* made = nullptr;
  const int code = sqlite3_open_v2(path_.c_str(), &made, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, nullptr);
  data_.reset(made);
  if (code == SQLITE_OK && set_up()) return true;
  if (anew == begun_anew_) close();  // else it has been begun anew
  return false;
}

/// No `fsync`: what a power cut leaves is checked when it is read.
bool ResultFile::set_up() {
  sqlite3_busy_timeout(data_.get(), kBusyMilliseconds);
  const std::uint64_t pages = std::max(limit_ / kPage, kLeastPages);
  const std::string settings = fmt::format(
      "PRAGMA cell_size_check = ON; PRAGMA page_size = {}; PRAGMA journal_mode = WAL; PRAGMA synchronous = OFF; PRAGMA "
      "max_page_count = {};",
      kPage, pages);
  return do_all(settings.c_str()) && do_all(kSchema) && prepare(kFind, find_) && prepare(kInsert, insert_) &&
         prepare(kDrop, drop_) && prepare(kThinOut, thin_out_);
}

/// What SQLite said. Of a file that it cannot read nothing is left; whoever has it open still has the old one.
void ResultFile::note(int code) {
  if (!is_broken(code)) return;
  close();
  if (++begun_anew_ > kMostAnew || !set_lock(kNewFileByte, F_WRLCK, true)) return;
  std::error_code none;
  for (const char* end : {"", "-wal", "-shm", "-journal"}) std::filesystem::remove(path_.string() + end, none);
  open();
  set_lock(kNewFileByte, F_UNLCK, false);
}

std::optional<std::string> ResultFile::find(std::string_view content) {
  const std::lock_guard lock(guard_);
  return data_ == nullptr ? std::nullopt : read(content);
}

std::optional<std::string> ResultFile::read(std::string_view content) {
  sqlite3_bind_int64(find_.get(), 1, static_cast<sqlite3_int64>(hash_of(content)));
  sqlite3_bind_text(find_.get(), 2, version().data(), static_cast<int>(version().size()), SQLITE_STATIC);
  std::optional<std::string> found;
  std::int64_t spoiled = 0;
  int code = sqlite3_step(find_.get());
  for (; code == SQLITE_ROW && !found; code = sqlite3_step(find_.get())) {
    const std::string_view of = blob(find_.get(), 1), result = blob(find_.get(), 2);
    const bool whole = sqlite3_column_int64(find_.get(), 3) == sum_of(of, result);
    if (!whole)
      spoiled = sqlite3_column_int64(find_.get(), 0);
    else if (of == content)
      found = std::string(result);
  }
  sqlite3_reset(find_.get());
  if (code != SQLITE_ROW && code != SQLITE_DONE) note(code);
  if (spoiled != 0 && data_ != nullptr) drop(spoiled);
  return found;
}

bool ResultFile::drop(std::int64_t entry) {
  sqlite3_bind_int64(drop_.get(), 1, entry);
  const int code = sqlite3_step(drop_.get());
  sqlite3_reset(drop_.get());
  return code == SQLITE_DONE;
}

int ResultFile::insert(std::string_view content, std::string_view result) {
  sqlite3_bind_int64(insert_.get(), 1, static_cast<sqlite3_int64>(hash_of(content)));
  sqlite3_bind_text(insert_.get(), 2, version().data(), static_cast<int>(version().size()), SQLITE_STATIC);
  bind_blob(insert_.get(), 3, content);
  bind_blob(insert_.get(), 4, result);
  sqlite3_bind_int64(insert_.get(), 5, sum_of(content, result));
  const int code = sqlite3_step(insert_.get());
  sqlite3_reset(insert_.get());
  sqlite3_clear_bindings(insert_.get());
  return code & 0xff;
}

void ResultFile::keep(std::string_view content, std::string_view result) {
  if ((content.size() + result.size()) > limit_ / kLargestShare) return;
  const std::lock_guard lock(guard_);
  if (data_ == nullptr || read(content) || data_ == nullptr) return;  // another thread has made it too
  for (int tries = 0; tries < int(kLargestShare); ++tries) {
    const int code = insert(content, result);
    note(code);
    if (code != SQLITE_FULL || data_ == nullptr) return;
    const int thinned = sqlite3_step(thin_out_.get());
    sqlite3_reset(thin_out_.get());
    if (thinned != SQLITE_DONE || sqlite3_changes(data_.get()) == 0) return;
  }
}

/// Of the whole process, and gone with it. The system finds processes that would wait for one another in a circle.
bool ResultFile::set_lock(std::uint64_t byte, short type, bool wait) const {
  struct flock range {};
  range.l_type = type;
  range.l_whence = SEEK_SET;
  range.l_start = static_cast<off_t>(byte);
  range.l_len = 1;
  while (fcntl(claims_, wait ? F_SETLKW : F_SETLK, &range) != 0)
    if (errno != EINTR) return false;
  return true;
}

void ResultFile::begin(std::string_view content) { set_lock(hash_of(content) % kNewFileByte, F_WRLCK, true); }
void ResultFile::end(std::string_view content) { set_lock(hash_of(content) % kNewFileByte, F_UNLCK, false); }

}  // namespace findspace::io
