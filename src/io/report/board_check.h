// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The rule check of a whole board: a formula holds for every part where it stands. In it `self` is the part and
// `others` are the parts that share a side of the board with it; without a formula no body may leave the board or
// overlap another. Guarantee: as of a check at a position; parts that are farther away by their boxes than a rule asks
// are not looked at. Cost: two boxes for each pair, and a distance for each that is near. Keywords: design rule check,
// DRC, courtyard overlap, clearance matrix.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "formula/language/position_answers.h"
#include "io/board/board.h"
#include "io/scene/scene.h"

namespace findspace::io {

class BoardCheck {
 public:
  /// Of the board of a scene, by its "where". `place`: of the rules in errors.
  BoardCheck(Scene scene, const std::string& place);
  ~BoardCheck();
  BoardCheck(const BoardCheck&) = delete;
  BoardCheck& operator=(const BoardCheck&) = delete;

  /// How many parts have a body.
  std::size_t parts() const;
  const std::string& rules() const;
  /// What had to be rounded.
  const std::vector<std::string>& notes() const;
  /// A part that breaks the rules, and what it breaks.
  struct BrokenPart {
    const Part* part;
    const formula::Check* check;
  };
  std::vector<BrokenPart> broken() const;

  /// For people, as JSON and as a picture. `explain`: which way decided each atom, and how long it took.
  std::string text(bool explain) const;
  std::string json(bool explain) const;
  std::string svg() const;

 private:
  struct Work;
  std::unique_ptr<const Work> work_;
};

}  // namespace findspace::io
