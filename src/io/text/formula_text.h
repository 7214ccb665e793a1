// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A formula and a position as a file states them: text with its place, and whole grid steps.
#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace findspace::io {

/// A formula, and where its first character stands in the scene file (from 1; 0 where there is no formula).
struct FormulaText {
  std::string text;
  std::string file;
  int line = 0, column = 0;

  bool empty() const { return text.empty(); }
};

/// Grid coordinates of a position; the third is 0 in 2D.
using GridPosition = std::array<std::int64_t, 3>;

}  // namespace findspace::io
