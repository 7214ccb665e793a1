// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "io/team/row_team.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <ctime>
#include <exception>
#include <limits>
#include <map>
#include <string_view>
#include <utility>

#include "plane/base/parallel.h"
#include "space/rays/row_bytes.h"

namespace findspace::io {

namespace {

/// Numbers as bytes of a message, and back.
template <class Numbers>
std::string bytes_of(const Numbers& numbers) {
  return {reinterpret_cast<const char*>(&numbers), sizeof numbers};
}
template <class Numbers>
Numbers numbers_of(std::string_view bytes) {
  Numbers out{};
  std::memcpy(&out, bytes.data(), std::min(sizeof out, bytes.size()));
  return out;
}

}  // namespace

/// Rows `begin` to `begin + count - 1` of the source on a grid; count 0: there are no more of the question, nor of
/// those before it.
struct RowTeam::Request {
  /// What is made of rows: themselves, or digests without or with texts.
  enum Kind : std::int64_t { kWholeRows, kDigests, kWrittenDigests };
  static constexpr std::int64_t kAll = std::numeric_limits<std::int64_t>::max();  // questions
  std::int64_t question, run, axis, parts, u, v, du, dv, nu, nv, begin, count, kind;

  static Request last_of(std::int64_t question) {
    Request out{};
    out.question = question;
    return out;
  }
  space::RayGrid grid() const {
    return {static_cast<int>(axis), parts, u, v, du, dv, static_cast<int>(nu), static_cast<int>(nv)};
  }
};

/// What stands before rows: an answer to a run that has failed is passed over.
struct RowTeam::Reply {
  std::int64_t run, begin;
};

/// A source that was made for the leader.
struct RowTeam::Made {
  space::RayGrid grid;
  formula::RegionOnLines region;
};

namespace {

enum MessageKind { kAsk = 1, kBlock, kRows, kFailed, kBye };
constexpr int kInHand = 2;  // blocks that a process has asked for: the one it makes, and the next
// Beyond what is handed on, so that a slow process does not stop the others: rows, or blocks for each process.
constexpr int kAheadRows = 512, kAheadAProcess = 8;
constexpr int kMostRows = 8, kBlocksAProcess = 32;

/// Adds to a sum the seconds that it lives, of this thread's processor time or by the clock.
class Spent {
 public:
  Spent(clockid_t clock, double& sum) : clock_(clock), sum_(sum), begun_(now()) {}
  ~Spent() { sum_ += now() - begun_; }
  Spent(const Spent&) = delete;
  Spent& operator=(const Spent&) = delete;

 private:
  double now() const {
    timespec time{};
    clock_gettime(clock_, &time);
    return std::chrono::duration<double>(std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec))
        .count();
  }
  clockid_t clock_;
  double& sum_;
  double begun_;
};

bool same_grid(const space::RayGrid& a, const space::RayGrid& b) {
  return a.axis == b.axis && a.parts == b.parts && a.u == b.u && a.v == b.v && a.du == b.du && a.dv == b.dv &&
         a.nu == b.nu && a.nv == b.nv;
}

std::vector<space::RayRow> rows_of(const Team& team, const space::RaySource& source, int begin, int count) {
  std::vector<space::RayRow> out(static_cast<std::size_t>(count));
  plane::parallel_for(out.size(), [&](std::size_t k) {
    out[k] = source.row(begin + static_cast<int>(k));
    team.progress();
  });
  return out;
}

/// That of a row, and messages move on meanwhile.
RowDigester with_progress(const Team& team, const RowDigester& digester) {
  return [&team, &digester](const space::RayGrid& grid, int j, const space::RayRow& row, bool written) {
    RowDigest digest = digester(grid, j, row, written);
    team.progress();
    return digest;
  };
}

}  // namespace

/// The leader's end of what all processes make of the rows of a source.
template <class Item>
class SharedBlocks {
 public:
  using Items = std::vector<Item>;
  using Request = RowTeam::Request;
  struct Way {
    typename Request::Kind kind;
    std::function<Items(int begin, int count)> make;
    std::function<Items(int begin, int count, std::string_view bytes)> read;
    std::function<void(int, Item&&)> take;
  };

  SharedBlocks(RowTeam& rows, const space::RayGrid& grid, Way way)
      : team_(rows), peers_(rows.team_), run_(++rows.runs_), grid_(grid), way_(std::move(way)) {
    rows_ = std::clamp(grid.nv / (processes() * kBlocksAProcess), 1, kMostRows);
    blocks_ = (grid.nv + rows_ - 1) / rows_;
  }
  void run();

 private:
  int processes() const { return static_cast<int>(peers_.count()); }
  int begin_of(int block) const { return block * rows_; }
  int count_of(int block) const { return std::min(rows_, grid_.nv - begin_of(block)); }
  bool may_begin() const {
    return next_ < blocks_ && next_ - taken_ < std::max(kAheadRows / rows_, kAheadAProcess * processes());
  }
  Items own_items(int block);
  void hear(bool wait);
  void give();
  void understand(const Team::Message& message);
  void hand_on(Items items);

  RowTeam& team_;
  Team& peers_;
  std::int64_t run_;
  const space::RayGrid& grid_;
  Way way_;
  int rows_ = 1, blocks_ = 0, next_ = 0, taken_ = 0;
  std::map<int, Items> made_;
};

template <class Item>
typename SharedBlocks<Item>::Items SharedBlocks<Item>::own_items(int block) {
  double seconds = 0;
  Items items;
  {
    const Spent spent(CLOCK_THREAD_CPUTIME_ID, seconds);
    items = way_.make(begin_of(block), count_of(block));
  }
  RowTeam::Account& account = team_.account_;
  account.rows_made += int(items.size());
  account.making += seconds;
  account.slowest_row = std::max(account.slowest_row, seconds / double(items.size()));
  return items;
}

template <class Item>
void SharedBlocks<Item>::give() {
  std::vector<std::size_t>& waiting = team_.waiting_[team_.question_];
  while (!waiting.empty() && may_begin()) {
    const space::RayGrid& g = grid_;
    const Request request{team_.question_, run_,     g.axis, g.parts, g.u, g.v, g.du, g.dv, g.nu, g.nv, begin_of(next_),
                          count_of(next_), way_.kind};
    peers_.send(waiting.back(), kBlock, bytes_of(request));
    waiting.pop_back();
    ++next_;
  }
}

template <class Item>
void SharedBlocks<Item>::understand(const Team::Message& message) {
  const std::string_view bytes = message.bytes;
  if (message.kind == kAsk) {
    const auto question = numbers_of<std::int64_t>(bytes);
    if (question >= team_.question_) team_.waiting_[question].push_back(message.from);
    return;
  }
  if (message.kind == kBye) return void(++team_.ended_);
  const auto [run, begin] = numbers_of<RowTeam::Reply>(bytes);
  if (run != run_) return;
  const int block = static_cast<int>(begin) / rows_;
  if (message.kind == kFailed) {  // here it fails as well, with its message
    made_.emplace(block, own_items(block));
    return;
  }
  const Spent spent(CLOCK_THREAD_CPUTIME_ID, team_.account_.taking);
  made_.emplace(block, way_.read(static_cast<int>(begin), count_of(block), bytes.substr(sizeof(RowTeam::Reply))));
}

template <class Item>
void SharedBlocks<Item>::hear(bool wait) {
  for (auto message = peers_.receive(wait); message; message = peers_.receive(false)) understand(*message);
  give();
}

template <class Item>
void SharedBlocks<Item>::hand_on(Items items) {
  const Spent spent(CLOCK_THREAD_CPUTIME_ID, team_.account_.taking);
  for (int k = 0; k < int(items.size()); ++k) way_.take(begin_of(taken_) + k, std::move(items[std::size_t(k)]));
  team_.account_.rows_taken += int(items.size());
  ++taken_;
}

template <class Item>
void SharedBlocks<Item>::run() {
  while (taken_ < blocks_) {
    give();
    hear(false);
    if (const auto ready = made_.find(taken_); ready != made_.end()) {
      Items items = std::move(ready->second);
      made_.erase(ready);
      hand_on(std::move(items));
    } else if (may_begin()) {
      const int block = next_++;
      made_.emplace(block, own_items(block));
    } else {
      const Spent spent(CLOCK_MONOTONIC, team_.account_.waiting);
      hear(true);
    }
  }
}

namespace {

/// Rows of a source that all processes make, and of a question that has ended the leader alone.
class SharedRows : public space::RaySource {
 public:
  SharedRows(RowTeam& team, const Team& peers, std::function<bool()> is_open, space::RaySourcePointer own)
      : team_(team), peers_(peers), is_open_(std::move(is_open)), own_(std::move(own)), reader_(*own_) {}
  const space::RayGrid& grid() const override { return own_->grid(); }
  exact::Tried<space::RayRow> try_row(int j) const override { return own_->try_row(j); }
  bool searched() const override { return own_->searched(); }
  void each_row(const std::function<void(int, space::RayRow&&)>& take) const override {
    if (!is_open_()) return own_->each_row(take);
    using Blocks = SharedBlocks<space::RayRow>;
    const auto make = [&](int begin, int count) { return rows_of(peers_, *own_, begin, count); };
    const auto read = [&](int begin, int count, std::string_view bytes) {
      std::vector<space::RayRow> rows;
      for (int k = 0; k < count; ++k) rows.push_back(reader_.read(begin + k, bytes));
      return rows;
    };
    Blocks(team_, grid(), {Blocks::Request::kWholeRows, make, read, take}).run();
  }

 private:
  RowTeam& team_;
  const Team& peers_;
  std::function<bool()> is_open_;
  space::RaySourcePointer own_;
  mutable space::RowReader reader_;
};

}  // namespace

RowTeam::RowTeam(Team& team) : team_(team) {}
RowTeam::~RowTeam() = default;

void RowTeam::begin() {
  end();
  ++question_;
  account_ = {};
}

void RowTeam::end() {
  if (!leads() || ended_question_ == question_) return;
  ended_question_ = question_;
  waiting_.erase(question_);
  for (std::size_t other = 1; other < team_.count(); ++other)
    team_.send(other, kBlock, bytes_of(Request::last_of(question_)));
}

space::RaySourcePointer RowTeam::shared(space::RaySourcePointer rows, std::int64_t question) {
  if (team_.count() == 1 || rows->grid().oblique) return rows;
  return std::make_unique<SharedRows>(
      *this, team_, [this, question] { return is_open(question); }, std::move(rows));
}

std::string RowTeam::account() const {
  if (account_.rows_taken == 0) return "";
  return fmt::format(
      "{} ranks: rank 0 made {} rows in {:.3f} s (slowest {:.4f} s a row), took {} rows in {:.3f} s, waited {:.3f} s",
      team_.count(), account_.rows_made, account_.making, account_.slowest_row, account_.rows_taken, account_.taking,
      account_.waiting);
}

void RowTeam::each_digest(const space::RaySource& own, const RowDigester& digester, bool written,
                          const std::function<void(int, RowDigest&&)>& take) {
  if (team_.count() == 1 || own.grid().oblique || !is_open(question_))
    return io::each_digest(own, digester, written, take);
  const RowDigester moving_on = with_progress(team_, digester);
  const auto make = [&](int begin, int count) { return digests_of(own, moving_on, written, begin, count); };
  const auto read = [](int, int count, std::string_view bytes) {
    std::vector<RowDigest> digests;
    plane::ByteReader in(bytes);
    for (int k = 0; k < count; ++k) digests.push_back(take_digest(in));
    return digests;
  };
  SharedBlocks<RowDigest>(*this, own.grid(), {written ? Request::kWrittenDigests : Request::kDigests, make, read, take})
      .run();
}

void RowTeam::make_source(const Source& source, const space::RayGrid& grid) {
  if (made_->region.rays && same_grid(made_->grid, grid)) return;
  made_->region = source(grid);
  made_->grid = grid;
}

std::string RowTeam::answer(const Request& request, const RowDigester& digester) const {
  const space::RaySource& rays = *made_->region.rays;
  const int begin = static_cast<int>(request.begin), count = static_cast<int>(request.count);
  std::string bytes;
  if (request.kind == Request::kWholeRows) {
    for (const space::RayRow& row : rows_of(team_, rays, begin, count)) space::append_bytes(row, bytes);
    return bytes;
  }
  plane::ByteWriter out;
  const RowDigester moving_on = with_progress(team_, digester);
  const bool written = request.kind == Request::kWrittenDigests;
  for (const RowDigest& digest : digests_of(rays, moving_on, written, begin, count)) put_digest(digest, out);
  return std::move(out).take();
}

void RowTeam::serve_block(const Source& source, const RowDigester& digester, const Request& request) {
  std::string bytes = bytes_of(Reply{request.run, request.begin});
  MessageKind kind = kRows;
  try {
    make_source(source, request.grid());
    bytes += answer(request, digester);
  } catch (const std::exception&) {
    bytes.resize(sizeof(Reply));
    kind = kFailed;
  }
  team_.send(0, kind, std::move(bytes));
}

void RowTeam::ask() { team_.send(0, kAsk, bytes_of(question_)); }

void RowTeam::serve(const Source& source, const space::RayGrid& first, const RowDigester& digester) {
  if (released_) return;
  made_ = std::make_unique<Made>();
  for (int k = 0; k < kInHand; ++k) ask();
  try {
    make_source(source, first);
  } catch (const std::exception&) {  // the leader says so
  }
  while (true) {
    const auto request = numbers_of<Request>(team_.receive(true)->bytes);
    if (request.count > 0) {
      serve_block(source, digester, request);
      ask();
    } else if (request.question >= question_) {
      released_ = request.question == Request::kAll;
      break;
    }
  }
  made_.reset();
}

void RowTeam::finish() {
  if (!leads()) {
    while (!released_) released_ = numbers_of<Request>(team_.receive(true)->bytes).question == Request::kAll;
    return team_.send(0, kBye, {});
  }
  for (std::size_t other = 1; other < team_.count(); ++other)
    team_.send(other, kBlock, bytes_of(Request::last_of(Request::kAll)));
  ended_question_ = question_;  // what is asked now the leader answers alone
  while (ended_ + 1 < team_.count())
    if (team_.receive(true)->kind == kBye) ++ended_;  // some ask for blocks, too
}

}  // namespace findspace::io
