// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A board as a scene: which shapes a question about it may name, and which of them move. A part has its anchor as its
// position, so that positions are the board's own coordinates. Its pads move with it. Names: `board`, every part, every
// pad "U3.14", `holes`, `keepouts` and each of them, the copper of a layer "F.Cu", of a net 'net GND', and the lists
// `parts`, `smd`, `tht`, `front`, `back`, `fixed` and the board's groups, of parts without what moves. `others` are the
// parts that share a side of the board with what moves, and the keep-outs there. A group of which every part moves is
// their union. Nothing is computed here.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "io/board/board.h"
#include "io/scene/scene.h"

namespace findspace::io {

/// What the command line asks of a board.
struct BoardQuestion {
  std::vector<std::string> move;  // parts and groups; empty: none moves
  std::string where, minimize, maximize;
  bool place = false;               // the parts move each on its own, one after another: a placement
  std::vector<exact::Real> angles;  // degrees as KiCad counts them, from the orientation that the part has
  std::vector<std::string> fixed;   // parts and groups that must not move, beside those that are locked in the board
  std::vector<PartGroup> groups;    // beside those of the board
};

/// Throws Error: kUnknownName where a part that is to move or to stay is none; kBadValue where one that is fixed is to
/// move, or that is locked is to be placed.
Scene board_scene(std::shared_ptr<const Board> board, const BoardQuestion& question);

}  // namespace findspace::io
