// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Any bytes are a board or an Error. A board becomes a scene, also with a group or a part that moves, in a map and in a
// placement. Its file with nothing moved is the same bytes.
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string_view>

#include "findspace/error.h"
#include "io/board/board_scene.h"
#include "io/board/read_board.h"
#include "io/board/write_board.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace findspace;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    const auto board = std::make_shared<const io::Board>(io::read_board(text, "fuzz"));
    if (!board->outline) std::abort();
    if (io::moved_board(text, "fuzz", {}) != text) std::abort();
    if (io::board_scene(board, {}).shapes.empty()) std::abort();
    io::BoardQuestion question;
    for (const io::Part& part : board->parts)
      if (part.body && question.move.empty()) question.move = {part.name};
    if (!board->groups.empty()) question.move = {board->groups.back().name};
    for (const bool place : {false, true}) {
      question.place = place;
      if (!question.move.empty() && io::board_scene(board, question).moving.empty() != place) std::abort();
    }
  } catch (const Error& error) {
    if (error.message().empty()) std::abort();
  }
  return 0;
}
