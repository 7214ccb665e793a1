// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "mpi/mpi_team.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <ctime>
#include <list>
#include <map>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "findspace/error.h"
#include "plane/base/parallel.h"
#include "space/rays/row_bytes.h"

namespace findspace::app {

/// What is made of rows: themselves, or digests without or with texts.
enum RequestKind : std::int64_t { kWholeRows, kDigests, kWrittenDigests };

/// Rows `begin` to `begin + count - 1` of the source on a grid; count 0: there are no more.
struct BlockRequest {
  std::int64_t axis, parts, u, v, du, dv, nu, nv, begin, count, kind;

  space::RayGrid grid() const {
    return {static_cast<int>(axis), parts, u, v, du, dv, static_cast<int>(nu), static_cast<int>(nv)};
  }
};

struct MpiTeam::Made {
  space::RayGrid grid;
  formula::RegionOnLines region;
  /// Blocks on their way to rank 0, which takes them between two of its own.
  struct Sending {
    std::string bytes;
    MPI_Request request = MPI_REQUEST_NULL;
  };
  std::list<Sending> sending;

  void wait_for(std::size_t most) {
    for (; sending.size() > most; sending.pop_front()) MPI_Wait(&sending.front().request, MPI_STATUS_IGNORE);
  }
};

namespace {

enum Tag { kAsk = 1, kBlock, kRows, kFailed, kBye };
constexpr int kInHand = 2;  // blocks that a rank has asked for: the one it makes, and the next
// Beyond what is handed on, so that a slow rank does not stop the others: rows, or blocks for each rank.
constexpr int kAheadRows = 512, kAheadARank = 8;
constexpr int kMostRows = 8, kBlocksARank = 32;

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

bool same(const space::RayGrid& a, const space::RayGrid& b) {
  return a.axis == b.axis && a.parts == b.parts && a.u == b.u && a.v == b.v && a.du == b.du && a.dv == b.dv &&
         a.nu == b.nu && a.nv == b.nv;
}

std::vector<space::RayRow> rows_of(const MpiTeam& team, const space::RaySource& source, int begin, int count) {
  std::vector<space::RayRow> out(static_cast<std::size_t>(count));
  plane::parallel_for(out.size(), [&](std::size_t k) {
    out[k] = source.row(begin + static_cast<int>(k));
    team.progress();
  });
  return out;
}

/// That of a row, and messages move on meanwhile.
io::RowDigester with_progress(const MpiTeam& team, const io::RowDigester& digester) {
  return [&team, &digester](const space::RayGrid& grid, int j, const space::RayRow& row, bool written) {
    io::RowDigest digest = digester(grid, j, row, written);
    team.progress();
    return digest;
  };
}

}  // namespace

/// Rank 0's end of what all ranks make of the rows of a source.
template <class Item>
class SharedBlocks {
 public:
  using Items = std::vector<Item>;
  struct Way {
    RequestKind kind;
    std::function<Items(int begin, int count)> make;
    std::function<Items(int begin, int count, std::string_view bytes)> read;
    std::function<void(int, Item&&)> take;
  };

  SharedBlocks(MpiTeam& team, const space::RayGrid& grid, Way way) : team_(team), grid_(grid), way_(std::move(way)) {
    rows_ = std::clamp(grid.nv / (team.count_ * kBlocksARank), 1, kMostRows);
    blocks_ = (grid.nv + rows_ - 1) / rows_;
  }
  /// After an error blocks may be on their way still.
  ~SharedBlocks() {
    for (Coming& message : coming_) MPI_Wait(&message.request, MPI_STATUS_IGNORE);
  }
  SharedBlocks(const SharedBlocks&) = delete;
  SharedBlocks& operator=(const SharedBlocks&) = delete;
  void run();

 private:
  int begin_of(int block) const { return block * rows_; }
  int count_of(int block) const { return std::min(rows_, grid_.nv - begin_of(block)); }
  bool may_begin() const {
    return next_ < blocks_ && next_ - taken_ < std::max(kAheadRows / rows_, kAheadARank * team_.count_);
  }
  Items own_items(int block);
  void hear(bool wait);
  void give();
  bool begin_to_receive();
  bool receive_what_has_come();
  void understand(int rank, int tag, std::string_view bytes);
  void hand_on(Items items);

  /// A message on its way. Its sender may come to send it between two of its blocks only, so nothing waits for it.
  struct Coming {
    std::string bytes;
    int rank = 0, tag = 0;
    MPI_Request request = MPI_REQUEST_NULL;
  };

  MpiTeam& team_;
  const space::RayGrid& grid_;
  Way way_;
  int rows_ = 1, blocks_ = 0, next_ = 0, taken_ = 0;
  std::map<int, Items> made_;
  std::list<Coming> coming_;
};

template <class Item>
typename SharedBlocks<Item>::Items SharedBlocks<Item>::own_items(int block) {
  double seconds = 0;
  Items items;
  {
    const Spent spent(CLOCK_THREAD_CPUTIME_ID, seconds);
    items = way_.make(begin_of(block), count_of(block));
  }
  MpiTeam::Account& account = team_.account_;
  account.rows_made += int(items.size());
  account.making += seconds;
  account.slowest_row = std::max(account.slowest_row, seconds / double(items.size()));
  return items;
}

template <class Item>
void SharedBlocks<Item>::give() {
  while (!team_.waiting_.empty() && may_begin()) {
    const space::RayGrid& g = grid_;
    const BlockRequest request{g.axis,          g.parts,         g.u,      g.v, g.du, g.dv, g.nu, g.nv,
                               begin_of(next_), count_of(next_), way_.kind};
    MPI_Send(&request, sizeof request, MPI_BYTE, team_.waiting_.back(), kBlock, team_.ranks_);
    team_.waiting_.pop_back();
    ++next_;
  }
}

/// One message, if there is one.
template <class Item>
bool SharedBlocks<Item>::begin_to_receive() {
  int there = 0, size = 0;
  MPI_Status status;
  MPI_Message message = MPI_MESSAGE_NULL;
  MPI_Improbe(MPI_ANY_SOURCE, MPI_ANY_TAG, team_.ranks_, &there, &message, &status);
  if (there == 0) return false;
  MPI_Get_count(&status, MPI_BYTE, &size);
  Coming& next = coming_.emplace_back();
  next.bytes.resize(static_cast<std::size_t>(size));
  next.rank = status.MPI_SOURCE;
  next.tag = status.MPI_TAG;
  MPI_Imrecv(next.bytes.data(), size, MPI_BYTE, &message, &next.request);
  return true;
}

/// Whether anything has.
template <class Item>
bool SharedBlocks<Item>::receive_what_has_come() {
  bool any = false;
  for (auto i = coming_.begin(); i != coming_.end();) {
    int here = 0;
    MPI_Test(&i->request, &here, MPI_STATUS_IGNORE);
    if (here == 0) {
      ++i;
      continue;
    }
    understand(i->rank, i->tag, i->bytes);
    i = coming_.erase(i);
    any = true;
  }
  return any;
}

template <class Item>
void SharedBlocks<Item>::understand(int rank, int tag, std::string_view bytes) {
  if (tag == kAsk) return team_.waiting_.push_back(rank);
  if (tag == kBye) return void(++team_.ended_);
  std::int64_t begin = 0;
  std::memcpy(&begin, bytes.data(), sizeof begin);
  const int block = static_cast<int>(begin) / rows_;
  if (tag == kFailed) {  // here it fails as well, with its message
    made_.emplace(block, own_items(block));
    return;
  }
  const Spent spent(CLOCK_THREAD_CPUTIME_ID, team_.account_.taking);
  made_.emplace(block, way_.read(static_cast<int>(begin), count_of(block), bytes.substr(sizeof begin)));
}

template <class Item>
void SharedBlocks<Item>::hear(bool wait) {
  for (bool heard = false; !heard; std::this_thread::yield()) {
    while (begin_to_receive()) {
    }
    heard = receive_what_has_come() || !wait;
    give();
  }
}

template <class Item>
void SharedBlocks<Item>::hand_on(Items items) {
  const Spent spent(CLOCK_THREAD_CPUTIME_ID, team_.account_.taking);
  for (int k = 0; k < int(items.size()); ++k) way_.take(begin_of(taken_) + k, std::move(items[k]));
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

/// Rows of a source that all ranks make.
class SharedRows : public space::RaySource {
 public:
  SharedRows(MpiTeam& team, space::RaySourcePointer own) : team_(team), own_(std::move(own)), reader_(*own_) {}
  const space::RayGrid& grid() const override { return own_->grid(); }
  exact::Tried<space::RayRow> try_row(int j) const override { return own_->try_row(j); }
  bool searched() const override { return own_->searched(); }
  void each_row(const std::function<void(int, space::RayRow&&)>& take) const override {
    const auto make = [&](int begin, int count) { return rows_of(team_, *own_, begin, count); };
    const auto read = [&](int begin, int count, std::string_view bytes) {
      std::vector<space::RayRow> rows;
      for (int k = 0; k < count; ++k) rows.push_back(reader_.read(begin + k, bytes));
      return rows;
    };
    SharedBlocks<space::RayRow>(team_, grid(), {kWholeRows, make, read, take}).run();
  }

 private:
  MpiTeam& team_;
  space::RaySourcePointer own_;
  mutable space::RowReader reader_;
};

MpiTeam::~MpiTeam() = default;

MpiTeam::MpiTeam(MPI_Comm ranks) : ranks_(ranks) {
  MPI_Comm_rank(ranks, &rank_);
  MPI_Comm_size(ranks, &count_);
}

space::RaySourcePointer MpiTeam::shared(space::RaySourcePointer rows) {
  if (count_ == 1 || rows->grid().oblique) return rows;
  return std::make_unique<SharedRows>(*this, std::move(rows));
}

void MpiTeam::progress() const {
  int there = 0;
  if (std::this_thread::get_id() == main_) MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, ranks_, &there, MPI_STATUS_IGNORE);
}

/// Of any size: MPI counts bytes in an int.
void MpiTeam::broadcast(std::string& text, int from) {
  std::uint64_t size = text.size();
  MPI_Bcast(&size, 1, MPI_UINT64_T, from, ranks_);
  text.resize(size);
  constexpr std::uint64_t kAtOnce = std::uint64_t{1} << 30;
  for (std::uint64_t begin = 0; begin < size; begin += kAtOnce)
    MPI_Bcast(text.data() + begin, static_cast<int>(std::min(kAtOnce, size - begin)), MPI_BYTE, from, ranks_);
}

std::string MpiTeam::shared_text(const std::function<std::string()>& make) {
  std::string text, place;
  int fault = -1;  // the code of the leader's Error
  if (leads()) try {
      text = make();
    } catch (const Error& e) {
      fault = static_cast<int>(e.code());
      text = e.message();
      place = e.place();
    }
  MPI_Bcast(&fault, 1, MPI_INT, 0, ranks_);
  broadcast(text, 0);
  if (fault < 0) return text;
  broadcast(place, 0);
  throw Error(static_cast<ErrorCode>(fault), text, place);
}

bool MpiTeam::any(bool own) {
  int said = own ? 1 : 0;
  MPI_Allreduce(MPI_IN_PLACE, &said, 1, MPI_INT, MPI_MAX, ranks_);
  return said != 0;
}

std::string MpiTeam::best_of(std::span<const double> cost, std::string own) {
  std::vector<double> all(cost.size() * count());
  const int each = static_cast<int>(cost.size());
  MPI_Allgather(cost.data(), each, MPI_DOUBLE, all.data(), each, MPI_DOUBLE, ranks_);
  const auto of = [&](int rank) { return std::span(all).subspan(std::size_t(rank) * cost.size(), cost.size()); };
  int best = 0;
  for (int rank = 1; rank < count_; ++rank)
    if (std::lexicographical_compare(of(rank).begin(), of(rank).end(), of(best).begin(), of(best).end())) best = rank;
  broadcast(own, best);
  return own;
}

std::string MpiTeam::account() const {
  if (account_.rows_taken == 0) return "";
  return fmt::format(
      "{} ranks: rank 0 made {} rows in {:.3f} s (slowest {:.4f} s a row), took {} rows in {:.3f} s, waited {:.3f} s",
      count_, account_.rows_made, account_.making, account_.slowest_row, account_.rows_taken, account_.taking,
      account_.waiting);
}

void MpiTeam::each_digest(const space::RaySource& own, const io::RowDigester& digester, bool written,
                          const std::function<void(int, io::RowDigest&&)>& take) {
  if (count_ == 1 || own.grid().oblique) return io::each_digest(own, digester, written, take);
  const io::RowDigester moving_on = with_progress(*this, digester);
  const auto make = [&](int begin, int count) { return io::digests_of(own, moving_on, written, begin, count); };
  const auto read = [](int, int count, std::string_view bytes) {
    std::vector<io::RowDigest> digests;
    plane::ByteReader in(bytes);
    for (int k = 0; k < count; ++k) digests.push_back(io::take_digest(in));
    return digests;
  };
  SharedBlocks<io::RowDigest>(*this, own.grid(), {written ? kWrittenDigests : kDigests, make, read, take}).run();
}

void MpiTeam::make_source(const Source& source, const space::RayGrid& grid) {
  if (made_->region.rays && same(made_->grid, grid)) return;
  made_->region = source(grid);
  made_->grid = grid;
}

std::string MpiTeam::answer(const BlockRequest& request, const io::RowDigester& digester) const {
  const space::RaySource& rays = *made_->region.rays;
  const int begin = static_cast<int>(request.begin), count = static_cast<int>(request.count);
  std::string bytes;
  if (request.kind == kWholeRows) {
    for (const space::RayRow& row : rows_of(*this, rays, begin, count)) space::append_bytes(row, bytes);
    return bytes;
  }
  plane::ByteWriter out;
  const io::RowDigester moving_on = with_progress(*this, digester);
  for (const io::RowDigest& digest : io::digests_of(rays, moving_on, request.kind == kWrittenDigests, begin, count))
    io::put_digest(digest, out);
  return std::move(out).take();
}

void MpiTeam::serve_block(const Source& source, const io::RowDigester& digester, const BlockRequest& request) {
  const std::int64_t begin = request.begin;
  std::string bytes(reinterpret_cast<const char*>(&begin), sizeof begin);
  Tag tag = kRows;
  try {
    make_source(source, request.grid());
    bytes += answer(request, digester);
  } catch (const std::exception&) {
    bytes.resize(sizeof begin);
    tag = kFailed;
  }
  made_->wait_for(kInHand);
  Made::Sending& block = made_->sending.emplace_back();
  block.bytes = std::move(bytes);
  MPI_Isend(block.bytes.data(), static_cast<int>(block.bytes.size()), MPI_BYTE, 0, tag, ranks_, &block.request);
}

void MpiTeam::serve(const Source& source, const space::RayGrid& first, const io::RowDigester& digester) {
  made_ = std::make_unique<Made>();
  for (int k = 0; k < kInHand; ++k) MPI_Send(nullptr, 0, MPI_BYTE, 0, kAsk, ranks_);
  try {
    make_source(source, first);
  } catch (const std::exception&) {  // rank 0 says so
  }
  while (true) {
    BlockRequest request{};
    MPI_Recv(&request, sizeof request, MPI_BYTE, 0, kBlock, ranks_, MPI_STATUS_IGNORE);
    if (request.count == 0) break;
    serve_block(source, digester, request);
    MPI_Send(nullptr, 0, MPI_BYTE, 0, kAsk, ranks_);
  }
  released_ = true;
  made_->wait_for(0);
  made_.reset();
}

void MpiTeam::finish() {
  BlockRequest end{};
  if (!leads()) {
    if (!released_) MPI_Recv(&end, sizeof end, MPI_BYTE, 0, kBlock, ranks_, MPI_STATUS_IGNORE);
    MPI_Send(nullptr, 0, MPI_BYTE, 0, kBye, ranks_);
    return;
  }
  for (int rank = 1; rank < count_; ++rank) MPI_Send(&end, sizeof end, MPI_BYTE, rank, kBlock, ranks_);
  while (ended_ < count_ - 1) {
    MPI_Status message;
    MPI_Recv(nullptr, 0, MPI_BYTE, MPI_ANY_SOURCE, MPI_ANY_TAG, ranks_, &message);  // asks for blocks, too
    if (message.MPI_TAG == kBye) ++ended_;
  }
}

}  // namespace findspace::app
