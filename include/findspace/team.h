// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Processes that answer one question together, over whatever carries their messages; the program findspace-mpi has MPI.
// All run the same program and ask the same questions in the same order. Number 0 leads: it reads files for all, and
// the answers of the others are empty. Of a map of space on lines the leader takes rows from the others, which give
// them until it asks for the next map or shape, shares a text or calls finish(). A packing is searched by all
// (PackSearch::peers). Guarantee: answers have the same bytes for any number of processes. Cost: on lines the leader's
// own work is what hands rows on in order. Source: docs/batch.md. Keywords: MPI, distributed memory, master and worker,
// cluster.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "findspace/pack_search.h"

namespace findspace {

/// What carries messages is derived from it. All processes are of one kind of machine and of one version of findspace.
class Team : public PackPeers {
 public:
  Team();
  ~Team() override;
  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;

  /// How many processes there are.
  virtual std::size_t count() const = 0;
  /// Gives the bytes of one process to all; all call it.
  virtual void broadcast(std::string& bytes, std::size_t from) = 0;
  /// A message from one process to another.
  struct Message {
    /// The number of its sender.
    std::size_t from = 0;
    /// What it is about.
    int kind = 0;
    /// What it says.
    std::string bytes;
  };
  /// Sends one; it may wait while two others are on their way to their ends.
  virtual void send(std::size_t to, int kind, std::string bytes) = 0;
  /// The next message that has come whole; where none has, it waits for one or gives nothing.
  virtual std::optional<Message> receive(bool wait) = 0;
  /// Called between two rows, from any thread: messages that are on their way may move on.
  virtual void progress() const {}

  /// Whether this process does.
  bool leads() const { return number() == 0; }
  /// What makes a text, called by the leader alone; all get the text, or the Error. All call it. Error(kLimit) for
  /// another process whose leader has called finish().
  std::string shared_text(const std::function<std::string()>& make);
  /// At the end, of all processes, whether questions failed or not: the leader lets the others go.
  void finish();

  struct Data;
  Data& data() const { return *data_; }

 private:
  std::unique_ptr<Data> data_;
};

/// While it lives, this thread's questions are answered by the team.
class TeamScope {
 public:
  /// Null: by this process alone. The team outlives it.
  explicit TeamScope(Team* team);
  ~TeamScope();
  TeamScope(const TeamScope&) = delete;
  TeamScope& operator=(const TeamScope&) = delete;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace findspace
