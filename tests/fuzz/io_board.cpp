// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Any bytes are a board or an Error. A board becomes a scene; its file with nothing moved is the same bytes.
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
  } catch (const Error& error) {
    if (error.message().empty()) std::abort();
  }
  return 0;
}
