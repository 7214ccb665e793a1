// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Results that are costly to make and depend on their operands alone, such as sums and Phi-functions: kept for other
// questions and other processes, under the exact content of the operands. A store belongs to the thread that installs
// it and to the tasks that parallel_for() makes of that thread's work. Guarantee: a result from the store is the bytes
// of the one that would be made; without a store nothing changes. Of several processes one makes a result and the
// others wait for it; if that one ends, another goes on. Cost: one call for each result without a store.
// Keywords: memoisation, content-addressed cache.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "plane/base/bytes.h"
#include "plane/base/of_thread.h"

namespace findspace::plane {

class ResultStore {
 public:
  virtual ~ResultStore() = default;
  /// What is kept under the content, checked; nothing where there is none.
  virtual std::optional<std::string> find(std::string_view content) = 0;
  virtual void keep(std::string_view content, std::string_view result) = 0;
  /// From `begin`, which may wait, to `end` no other process makes the result of this content.
  virtual void begin(std::string_view content) = 0;
  virtual void end(std::string_view content) = 0;
};

/// While it lives, the thread has this store; null: none.
using ScopedResultStore = OfThread<ResultStore>;
/// The one of this thread, or null.
inline ResultStore* result_store() { return ScopedResultStore::now(); }

/// How results of one kind are kept. `write` gives no bytes, and `read` nothing, where that cannot be.
template <class Result>
struct StoredAs {
  std::string_view kind;
  std::function<bool(ByteWriter&)> content;
  std::function<Result()> make;
  bool (*write)(const Result&, ByteWriter&);
  std::optional<Result> (*read)(ByteReader&);
};

/// The result of `make`, or the same from the store.
template <class Result>
Result stored(const StoredAs<Result>& as) {
  ResultStore* const store = result_store();
  if (store == nullptr) return as.make();
  ByteWriter key;
  key.put_text(as.kind);
  if (!as.content(key)) return as.make();
  const std::string content = std::move(key).take();
  const auto known = [&]() -> std::optional<Result> {
    const std::optional<std::string> bytes = store->find(content);
    if (!bytes) return std::nullopt;
    ByteReader reader(*bytes);
    std::optional<Result> result = as.read(reader);
    return reader.is_whole() ? std::move(result) : std::nullopt;
  };
  if (std::optional<Result> result = known()) return *std::move(result);
  struct Claim {
    Claim(ResultStore& s, std::string_view of) : store(s), content(of) { store.begin(content); }
    ~Claim() { store.end(content); }
    ResultStore& store;
    std::string_view content;
  };
  const Claim claim(*store, content);
  if (std::optional<Result> result = known()) return *std::move(result);  // another process has made it
  const ScopedResultStore within(nullptr);                                // what it is made of is not kept besides
  Result result = as.make();
  ByteWriter bytes;
  if (as.write(result, bytes)) store->keep(content, std::move(bytes).take());
  return result;
}

}  // namespace findspace::plane
