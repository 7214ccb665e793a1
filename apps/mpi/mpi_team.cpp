// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "mpi/mpi_team.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace findspace::app {
namespace {

constexpr std::size_t kOnTheirWay = 2;  // large messages of one rank
constexpr std::size_t kSmall = 256;     // bytes that are sent at once

}  // namespace

MpiTeam::MpiTeam(MPI_Comm ranks) : ranks_(ranks) {
  MPI_Comm_rank(ranks, &rank_);
  MPI_Comm_size(ranks, &count_);
}

MpiTeam::~MpiTeam() {
  for (auto* messages : {&coming_, &going_})
    for (Moving& m : *messages) MPI_Wait(&m.request, MPI_STATUS_IGNORE);
}

void MpiTeam::progress() const {
  int there = 0;
  if (std::this_thread::get_id() == main_) MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, ranks_, &there, MPI_STATUS_IGNORE);
}

/// Of any size: MPI counts bytes in an int.
void MpiTeam::broadcast(std::string& bytes, std::size_t from) {
  const int root = static_cast<int>(from);
  std::uint64_t size = bytes.size();
  MPI_Bcast(&size, 1, MPI_UINT64_T, root, ranks_);
  bytes.resize(size);
  constexpr std::uint64_t kAtOnce = std::uint64_t{1} << 30;
  for (std::uint64_t begin = 0; begin < size; begin += kAtOnce)
    MPI_Bcast(bytes.data() + begin, static_cast<int>(std::min(kAtOnce, size - begin)), MPI_BYTE, root, ranks_);
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
  const auto of = [&](std::size_t rank) { return std::span(all).subspan(rank * cost.size(), cost.size()); };
  std::size_t best = 0;
  for (std::size_t rank = 1; rank < count(); ++rank)
    if (std::lexicographical_compare(of(rank).begin(), of(rank).end(), of(best).begin(), of(best).end())) best = rank;
  broadcast(own, best);
  return own;
}

void MpiTeam::send(std::size_t to, int kind, std::string bytes) {
  const int rank = static_cast<int>(to);
  if (bytes.size() <= kSmall) {
    MPI_Send(bytes.data(), static_cast<int>(bytes.size()), MPI_BYTE, rank, kind, ranks_);
    return;
  }
  for (; going_.size() > kOnTheirWay; going_.pop_front()) MPI_Wait(&going_.front().request, MPI_STATUS_IGNORE);
  Moving& next = going_.emplace_back();
  next.message.bytes = std::move(bytes);
  const std::string& sent = next.message.bytes;
  MPI_Isend(sent.data(), static_cast<int>(sent.size()), MPI_BYTE, rank, kind, ranks_, &next.request);
}

/// One message, if there is one.
bool MpiTeam::begin_to_receive() {
  int there = 0, size = 0;
  MPI_Status status;
  MPI_Message message = MPI_MESSAGE_NULL;
  MPI_Improbe(MPI_ANY_SOURCE, MPI_ANY_TAG, ranks_, &there, &message, &status);
  if (there == 0) return false;
  MPI_Get_count(&status, MPI_BYTE, &size);
  Moving& next = coming_.emplace_back();
  next.message = {static_cast<std::size_t>(status.MPI_SOURCE), status.MPI_TAG,
                  std::string(static_cast<std::size_t>(size), '\0')};
  MPI_Imrecv(next.message.bytes.data(), size, MPI_BYTE, &message, &next.request);
  return true;
}

std::optional<Team::Message> MpiTeam::receive(bool wait) {
  while (true) {
    while (begin_to_receive()) {
    }
    for (auto i = coming_.begin(); i != coming_.end(); ++i) {
      int here = 0;
      MPI_Test(&i->request, &here, MPI_STATUS_IGNORE);
      if (here == 0) continue;
      std::optional<Message> out(std::move(i->message));
      coming_.erase(i);
      return out;
    }
    if (!wait) return std::nullopt;
    std::this_thread::yield();
  }
}

}  // namespace findspace::app
