// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "api/values/limits.h"

#include <unistd.h>

#include <fstream>

#include "plane/base/parallel.h"

namespace findspace::api {
namespace {

/// Of this process, in bytes; 0 where the system does not say.
std::size_t memory_in_use() {
  std::ifstream file("/proc/self/statm");
  std::size_t whole = 0, resident = 0;
  if (!(file >> whole >> resident)) return 0;
  return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

constexpr std::int64_t kMemoryEvery = 20;  // milliseconds

}  // namespace

Watch::Watch(const Options& options) : options_(options) {
  if (!(options.seconds >= 0)) throw Error(ErrorCode::kBadValue, "options: the seconds are a number from 0 on");
  if (!(options.work >= 0)) throw Error(ErrorCode::kBadValue, "options: the work is a number from 0 on");
}

void Watch::poll() {
  if (outer_ != nullptr) outer_->poll();
  if (options_.cancel.requested()) throw Stopped(Limit::kCancelled);
  if (options_.seconds <= 0 && options_.memory == 0) return;
  const std::chrono::duration<double> gone = Clock::now() - begun_;
  if (options_.seconds > 0 && gone.count() > options_.seconds) throw Stopped(Limit::kTime);
  if (options_.memory == 0) return;
  const std::int64_t now = static_cast<std::int64_t>(gone.count() * 1000);
  std::int64_t due = memory_due_.load();
  if (now < due || !memory_due_.compare_exchange_strong(due, now + kMemoryEvery)) return;
  if (memory_in_use() > options_.memory) throw Stopped(Limit::kMemory);
}

void Progress::add() {
  if (!options_.progress) return;
  const std::lock_guard lock(guard_);
  options_.progress(static_cast<double>(++done_) / static_cast<double>(blocks_));
}

}  // namespace findspace::api

namespace findspace {

struct CancelScope::Limits {
  Options options;
  api::Watch watch{options};
  plane::ScopedStopCheck here{&watch};

  explicit Limits(const Cancel& cancel) { options.cancel = cancel; }
};

CancelScope::CancelScope(const Cancel& cancel) : limits_(std::make_unique<Limits>(cancel)) {}
CancelScope::~CancelScope() = default;

struct ThreadScope::Limits {
  plane::ThreadLimit threads;
};

ThreadScope::ThreadScope(unsigned threads) : limits_(new Limits{plane::ThreadLimit(threads)}) {}
ThreadScope::~ThreadScope() = default;

}  // namespace findspace
