// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A store of results in a folder, for programs that ask much of the same shapes: sums, Phi-functions and what else is
// costly and depends on its operands alone is kept between runs and shared by processes. Guarantee: a result from the
// store is the bytes of the one that would be made: the operands themselves are compared, and each entry has a sum over
// all its bytes. The store stays below its limit, and the oldest entries go first. A disk that is full, or a store that
// is busy for long, costs time and no answer. Cost: some 20 microseconds an entry that is found. Source:
// docs/decisions/0022-results-kept-by-content.md. Keywords: cache, memoisation, SQLite.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

namespace findspace {

/// Copies are one store. Threads may share it.
class ResultStore {
 public:
  /// A file for each machine, so that the folder may be shared; the folder is made where there is none. `limit` in
  /// bytes. Error(kFile) where it cannot be made or opened.
  explicit ResultStore(const std::string& folder, std::uint64_t limit = std::uint64_t{1} << 30);
  /// As it was made.
  const std::string& folder() const;
  std::uint64_t limit() const;

  struct Data;
  const Data& data() const { return *data_; }

 private:
  std::shared_ptr<const Data> data_;
};

/// While it lives, what this thread is asked is looked for there, and kept there.
class StoreScope {
 public:
  /// From now on.
  explicit StoreScope(const ResultStore& store);
  ~StoreScope();
  StoreScope(const StoreScope&) = delete;
  StoreScope& operator=(const StoreScope&) = delete;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace findspace
