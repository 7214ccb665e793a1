// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// How a set of space is asked for: on which lines, how many or how far apart, along which axis, or along all three; in
// which files.
#pragma once

#include <findspace/scene.h>

#include <optional>
#include <string>
#include <vector>

#include "common/options.h"

namespace findspace::app {

struct SetInSpace {
  std::optional<MapLines>
      lines{};           // what --resolution, --step, --axis, --axes and --side say; nothing without the first two
  bool listed = false;   // JSON is written, which has the lines
  bool surface = false;  // another file is, which needs flat faces
};
/// Throws Error(kUsage), for other files too.
SetInSpace asked_in_space(const Options& options);
/// JSON, and the endings of surfaces.
std::vector<std::string> space_formats();

/// Throws Error(kUsage) where one of these options was given: the verb's question has no lines in space.
void refuse_lines(const Options& options, const char* because);

}  // namespace findspace::app
