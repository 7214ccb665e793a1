// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Processes that answer one question together. All run the same command. One of them leads: it reads files for all and
// writes the result. Of a map the leader takes rows from the others, which give them until it has all. A packing is
// searched by all. The others write nothing.
#pragma once

#include <findspace/pack_search.h>

#include <cstddef>
#include <functional>
#include <string>

#include "io/question/row_team.h"

namespace findspace::app {

class ProcessTeam : public io::RowTeam {
 public:
  virtual std::size_t count() const = 0;
  /// Returns when all have come here.
  virtual void meet() = 0;
  /// What makes a text, called by the leader alone; all get the text, or the Error. All call this in the same order.
  virtual std::string shared_text(const std::function<std::string()>& make) = 0;
  /// For a search that all take part in.
  virtual PackPeers& peers() = 0;
};

}  // namespace findspace::app
