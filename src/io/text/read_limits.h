// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What reading a scene may open and cost. It is handed to every reader. The defaults are those of the program and of
// the library alike (docs/security.md). Keywords: sandbox, quota, zip bomb.
#pragma once

#include <cstdint>
#include <filesystem>

#include "io/text/drawing_rules.h"
#include "plane/base/work_budget.h"

namespace findspace::io {

inline constexpr std::uint64_t kUsualInput = std::uint64_t{256} << 20;

struct ReadOptions {
  bool files = true;                                   // whether shapes may come from other files
  std::filesystem::path root{};                        // these lie in this folder, links followed; empty: anywhere
  std::uint64_t input_limit = kUsualInput;             // bytes of all files together, packed ones as they are unpacked
  std::uint64_t work_limit = plane::kUsualWorkBudget;  // units, of reading, of each shape and of each formula
  DrawingRules drawings{};                             // before those that the scene states
};

}  // namespace findspace::io
