// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Teams of processes of the public header.

#include <findspace/error.h>
#include <findspace/team.h>

#include "io/team/row_team.h"
#include "io/text/read_text.h"

namespace findspace {

struct Team::Data {
  io::RowTeam rows;

  explicit Data(Team& team) : rows(team) {}
};

Team::Team() : data_(std::make_unique<Data>(*this)) {}
Team::~Team() = default;

std::string Team::shared_text(const std::function<std::string()>& make) {
  if (data_->rows.is_released()) throw Error(ErrorCode::kLimit, "the process that leads has ended");
  data_->rows.end();
  std::string text, place, fault;  // the code of the leader's Error
  if (leads()) try {
      text = make();
    } catch (const Error& e) {
      fault = std::to_string(static_cast<int>(e.code()));
      text = e.message();
      place = e.place();
    }
  broadcast(fault, 0);
  broadcast(text, 0);
  if (fault.empty()) return text;
  broadcast(place, 0);
  throw Error(static_cast<ErrorCode>(std::stoi(fault)), text, place);
}

void Team::finish() { data_->rows.finish(); }

struct TeamScope::Data {
  io::TextReader shared;
  io::ReadTextBy reading;
  io::RowsByTeam rows;

  explicit Data(Team* team)
      : shared([team](const auto& read) { return team->shared_text(read); }),
        reading(team == nullptr ? nullptr : &shared),
        rows(team == nullptr ? nullptr : &team->data().rows) {}
};

TeamScope::TeamScope(Team* team) : data_(std::make_unique<Data>(team)) {}
TeamScope::~TeamScope() = default;

}  // namespace findspace
