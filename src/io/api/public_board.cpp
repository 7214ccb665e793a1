// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Boards of the public header.

#include <findspace/board.h>

#include <utility>

#include "api/query/world_data.h"
#include "io/api/public_scene.h"
#include "io/board/board_scene.h"
#include "io/board/read_board.h"
#include "io/report/board_check.h"
#include "io/text/read_text.h"

namespace findspace {

struct Board::Data {
  std::string source;
  BoardOptions options;
  std::shared_ptr<const io::Board> board;
  io::BoardQuestion question;  // its groups and what is fixed
  io::Scene scene;             // in which nothing moves

  Data(std::string text, BoardOptions how)
      : source(std::move(text)),
        options(std::move(how)),
        board(std::make_shared<const io::Board>(io::read_board(source, options.name))) {
    question.fixed = options.fixed;
    for (const BoardGroup& group : options.groups) question.groups.push_back({group.name, group.parts});
    scene = io::board_scene(board, question);
  }
};

struct BoardVerdict::Data {
  io::BoardCheck check;
  std::vector<Broken> broken{};

  Data(io::Scene scene, const std::string& place) : check(std::move(scene), place) {}
};

Board Board::file(const std::string& path, const BoardOptions& options) {
  return Board(std::make_shared<const Data>(io::read_text(path, options.input_limit), options));
}
Board Board::text(std::string_view kicad_pcb, const BoardOptions& options) {
  return Board(std::make_shared<const Data>(std::string(kicad_pcb), options));
}

const std::string& Board::source() const { return data_->source; }
const BoardOptions& Board::options() const { return data_->options; }
std::vector<std::string> Board::parts() const {
  std::vector<std::string> out;
  for (const io::Part& part : data_->board->parts)
    if (part.body) out.push_back(part.name);
  return out;
}
const std::vector<std::string>& Board::notes() const { return data_->scene.notes; }

BoardVerdict Board::check(const std::optional<Formula>& rules, const std::string& place) const {
  io::Scene scene = data_->scene;
  if (rules) scene.where = {rules->text(), place, 1, 1};
  const double step = scene.grid.step_size();
  auto data = std::make_shared<BoardVerdict::Data>(std::move(scene), place);
  for (const io::BoardCheck::BrokenPart& b : data->check.broken())
    data->broken.push_back({b.part->name,
                            {static_cast<double>(b.part->at.x) * step, static_cast<double>(b.part->at.y) * step},
                            api::public_check(*b.check)});
  return BoardVerdict(std::move(data));
}

World Board::world(const std::vector<std::string>& moving) const {
  if (moving.empty()) throw Error(ErrorCode::kBadValue, "nothing moves");
  io::BoardQuestion question = data_->question;
  question.move = moving;
  return io::public_world(io::board_scene(data_->board, question));
}

Scene Board::scene(const BoardQuestion& asked) const {
  io::BoardQuestion question = data_->question;
  question.move = asked.move;
  question.where = asked.where;
  question.minimize = asked.minimize;
  question.maximize = asked.maximize;
  question.place = asked.place;
  for (const Number& angle : asked.angles) question.angles.push_back(api::real_of(angle));
  io::Scene made = io::board_scene(data_->board, question);
  const auto call = [&](io::FormulaText& text) {  // that calls them as the command line does
    if (text.file.starts_with("--")) text.file = asked.before + text.file.substr(2);
  };
  for (io::FormulaText* text : {&made.where, &made.minimize, &made.maximize}) call(*text);
  for (io::FormulaText& text : made.place.constraints) call(text);
  for (io::FormulaText& text : made.place.minimize) call(text);
  return io::public_scene(std::move(made), *this, asked);
}

std::size_t BoardVerdict::parts() const { return data_->check.parts(); }
const std::string& BoardVerdict::rules() const { return data_->check.rules(); }
const std::vector<std::string>& BoardVerdict::notes() const { return data_->check.notes(); }
const std::vector<BoardVerdict::Broken>& BoardVerdict::broken() const { return data_->broken; }
std::string BoardVerdict::text(bool explain) const { return data_->check.text(explain); }
std::string BoardVerdict::json(bool explain) const { return data_->check.json(explain); }
std::string BoardVerdict::svg() const { return data_->check.svg(); }

}  // namespace findspace
