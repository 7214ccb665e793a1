// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A team of MPI ranks (findspace/team.h): its messages, broadcasts and reductions. Large messages are received and sent
// while rows are made. Keywords: MPI.
#pragma once

#include <findspace/team.h>
#include <mpi.h>

#include <list>
#include <thread>

namespace findspace::app {

class MpiTeam : public Team {
 public:
  explicit MpiTeam(MPI_Comm ranks);
  /// Waits for what is on its way.
  ~MpiTeam() override;

  std::size_t number() const override { return static_cast<std::size_t>(rank_); }
  std::size_t count() const override { return static_cast<std::size_t>(count_); }
  void broadcast(std::string& bytes, std::size_t from) override;
  bool any(bool own) override;
  std::string best_of(std::span<const double> cost, std::string own) override;
  void send(std::size_t to, int kind, std::string bytes) override;
  std::optional<Message> receive(bool wait) override;
  /// A large message moves only while both ends call MPI. Of the thread that made the team; others pass.
  void progress() const override;

 private:
  /// A message on its way. Its sender may come to send it between two of its blocks only, so nothing waits for it.
  struct Moving {
    Message message;
    MPI_Request request = MPI_REQUEST_NULL;
  };
  bool begin_to_receive();

  MPI_Comm ranks_;
  std::thread::id main_ = std::this_thread::get_id();
  int rank_ = 0, count_ = 1;
  std::list<Moving> coming_, going_;
};

}  // namespace findspace::app
