// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Circuit boards of KiCad: whether every part keeps the rules where it stands, and a world in which some of them move.
// Names are those of docs/boards.md: every part, pad "U3.14", `board`, `holes`, `keepouts`, copper by layer and net,
// and lists of parts. Lengths are in millimetres, y runs downwards. Guarantee: as of World::check. Cost: that of the
// pairs of parts that are near each other. Source: docs/boards.md. Keywords: PCB, design rule check, DRC, courtyard,
// clearance.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "findspace/files.h"
#include "findspace/formula.h"
#include "findspace/number.h"
#include "findspace/scene.h"
#include "findspace/values.h"
#include "findspace/world.h"

namespace findspace {

/// A list of parts by a name of its own.
struct BoardGroup {
  /// Its name in formulas.
  std::string name;
  /// References of its parts.
  std::vector<std::string> parts;
};

struct BoardOptions {
  std::string name = "board";               // of the file, as messages call it
  std::vector<BoardGroup> groups = {};      // beside those of the board
  std::vector<std::string> fixed = {};      // parts and groups that must not move, beside those that are locked
  std::uint64_t input_limit = kUsualInput;  // bytes
};

/// What a scene of a board asks.
struct BoardQuestion {
  std::vector<std::string> move = {};  // parts and groups: together, in a placement each on its own
  std::string where = {};              // a formula, as a scene has it
  std::string minimize = {};           // an objective
  std::string maximize = {};           // the same
  std::string before = {};             // what messages put before these three words
  bool place = false;                  // it is a placement of these parts
  std::vector<Number> angles = {};     // they may have these, in degrees as KiCad counts them, from the part's own on
};

/// What a check of a board says.
class BoardVerdict {
 public:
  /// Whether every part keeps the rules.
  bool holds() const { return broken().empty(); }
  /// How many were asked: those with a body.
  std::size_t parts() const;
  /// The rules, also where none were given.
  const std::string& rules() const;
  /// What had to be rounded.
  const std::vector<std::string>& notes() const;
  /// A part that breaks the rules.
  struct Broken {
    /// Its reference.
    std::string part;
    /// Where its anchor is.
    Position at{};
    /// What it breaks: of rules about pairs those that do not hold.
    Check check;
  };
  /// In the order of the file.
  const std::vector<Broken>& broken() const;

  /// In words, as `findspace check --json` writes it, and as a picture of the board. `explain`: also which way decided
  /// each condition, and how long it took.
  std::string text(bool explain = false) const;
  std::string json(bool explain = false) const;
  std::string svg() const;

  struct Data;
  explicit BoardVerdict(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

 private:
  std::shared_ptr<const Data> data_;
};

/// Immutable and cheap to copy.
class Board {
 public:
  /// A file ".kicad_pcb", and its text. Error(kFile), Error(kSyntax) with its line, Error(kUnknownName) for a part of a
  /// group that is none.
  static Board file(const std::string& path, const BoardOptions& options = {});
  static Board text(std::string_view kicad_pcb, const BoardOptions& options = {});

  /// What it was read from, and how.
  const std::string& source() const;
  const BoardOptions& options() const;
  /// References of the parts that have a body, in the order of the file.
  std::vector<std::string> parts() const;
  /// What was found odd on the way.
  const std::vector<std::string>& notes() const;

  /// Whether the rules hold for each part, `self`; `others` are the parts on the same side of the board. Without rules
  /// every body is on the board and overlaps no other. Errors in the rules have `place` and line and column.
  BoardVerdict check(const std::optional<Formula>& rules = {}, const std::string& place = "rules") const;
  /// The world in which these parts or groups move together; a position is that of the first one's anchor. A world,
  /// that of a scene too, knows coordinates alone: its degrees go from the x axis to the y axis, clockwise as the board
  /// is seen. Those of a scene() go counter-clockwise.
  World world(const std::vector<std::string>& moving) const;
  /// A scene whose lengths and positions are the board's own. Error(kUnknownName) for what is to move and is no part,
  /// kBadValue where that is fixed, or is to be placed and is locked.
  Scene scene(const BoardQuestion& question) const;

  struct Data;
  explicit Board(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

 private:
  std::shared_ptr<const Data> data_;
};

}  // namespace findspace
