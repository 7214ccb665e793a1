// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Which questions of a batch are done, and their results, in a folder beside the result file. Any number of processes,
// on one machine or on several that share the folder, take questions from it. Guarantee: a question has one result,
// whatever process is killed when; what is done is not done again. Each process appends whole lines to a file of its
// own. It holds a lock on byte k of one file while it answers question k, and the system drops the lock when the
// process ends. The byte itself says whether the question was ever taken, so that a question costs no look at the
// others' files. The last one makes the result file, in the order of the questions. Cost: three calls of the system a
// question; a look at all files for each `refresh`. Keywords: write-ahead log, byte-range lock.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace findspace::app {

class JobJournal {
 public:
  /// Opens or makes the folder RESULTS.parts. Throws Error(kFile), and Error(kBadValue) where it belongs to others.
  JobJournal(std::filesystem::path results, std::uint64_t digest, std::size_t count);
  ~JobJournal();
  JobJournal(const JobJournal&) = delete;
  JobJournal& operator=(const JobJournal&) = delete;

  /// True: the question is open, and this process's own until `record`. False: it is done, or another's.
  bool claim(std::size_t job);
  /// A line without its end. Throws Error(kFile) where the disk does not take it; nothing of it is kept then.
  void record(std::size_t job, std::string_view line);

  /// Reads what others have done since.
  void refresh();
  bool done(std::size_t job) const { return where_[job].part >= 0; }
  std::size_t done() const { return done_; }
  /// What is removed with it at the end.
  const std::filesystem::path& folder() const { return folder_; }
  /// Another process has made the result file of all of them.
  bool over() const;
  /// All are done: makes the result file, unless another process has, and removes the folder.
  void finish();

 private:
  struct Place {
    int part = -1;
    std::uint64_t start = 0, size = 0;
  };
  struct Part {
    std::filesystem::path path;
    std::uint64_t read = 0;
  };

  std::string result(std::size_t job) const;
  void check_owner(std::uint64_t digest) const;
  void open_own();
  bool lock(std::size_t byte, bool wait) const;
  void unlock(std::size_t byte) const;
  char state(std::size_t job) const;
  void set_state(std::size_t job, char state) const;
  void read_part(std::size_t part);
  void note(std::size_t job, Place place);

  std::filesystem::path results_, folder_;
  int lock_file_ = -1, own_file_ = -1;
  std::size_t own_part_ = 0;
  std::uint64_t own_size_ = 0;
  std::vector<Part> parts_;
  std::unordered_map<std::string, std::size_t> part_of_;  // by the name of its file
  std::vector<Place> where_;
  std::size_t done_ = 0;
};

/// How a line of the journal begins, by which it is found again.
std::string result_head(std::size_t job);
/// The line without that.
std::string result_line(std::size_t job, std::string_view line);

}  // namespace findspace::app
