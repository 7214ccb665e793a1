// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A store of results in a folder: one file of SQLite for each machine, shared by its processes. Guarantee: what is
// found was kept under exactly this content. The content itself is compared, and each entry has a sum over all its
// bytes; an entry that fails is dropped, and a file that SQLite cannot read is begun anew. A process that is killed
// leaves whole entries. The file stays below its limit: the oldest entries go first. A disk that is full, or a store
// that is busy for long, costs time and no answer. Cost: some 20 microseconds an entry that is found. Keywords: cache,
// WAL, checksum.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>

#include "plane/base/result_store.h"

struct sqlite3;
struct sqlite3_stmt;

namespace findspace::io {

class ResultFile : public plane::ResultStore {
 public:
  /// Makes the folder where there is none. Throws Error(kFile) where it cannot be made or opened.
  ResultFile(const std::filesystem::path& folder, std::uint64_t limit);
  ~ResultFile() override;
  ResultFile(const ResultFile&) = delete;
  ResultFile& operator=(const ResultFile&) = delete;

  std::optional<std::string> find(std::string_view content) override;
  void keep(std::string_view content, std::string_view result) override;
  void begin(std::string_view content) override;
  void end(std::string_view content) override;

 private:
  struct Closer {
    void operator()(sqlite3* data) const;
    void operator()(sqlite3_stmt* statement) const;
  };
  using Statement = std::unique_ptr<sqlite3_stmt, Closer>;

  bool open();
  bool set_up();
  void close();
  bool do_all(const char* commands);
  bool prepare(const char* command, Statement& statement);
  std::optional<std::string> read(std::string_view content);
  int insert(std::string_view content, std::string_view result);
  bool drop(std::int64_t entry);
  void note(int code);
  bool set_lock(std::uint64_t byte, short type, bool wait) const;

  std::filesystem::path path_;
  std::uint64_t limit_;
  int claims_ = -1;  // the file with a byte for each content, which is locked
  std::mutex guard_;
  std::unique_ptr<sqlite3, Closer> data_;  // null: nothing is found or kept
  Statement find_, insert_, drop_, thin_out_;
  int begun_anew_ = 0;
};

}  // namespace findspace::io
