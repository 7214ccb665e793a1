// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Which lines a map of space is taken on: how many or how far apart, along which axis, or along all three.
#pragma once

#include "common/session.h"
#include "space/rays/ray_surface.h"

namespace findspace::app {

struct LineChoice {
  int count = 0;           // lines each way; 0: by `apart`
  std::int64_t apart = 0;  // grid steps from line to line; 0: by `count`
  int axis = 2;
  bool axes = false;  // along all three

  space::RayGrid grid(const space::Point& low, const space::Point& high) const;
  space::RayLattice lattice(const space::Point& low, const space::Point& high) const;
};

/// What --resolution, --step, --axis and --axes ask for; nothing without the first two. Throws Error(kUsage).
std::optional<LineChoice> asked_lines(const Session& session);

/// Throws Error(kUsage) where one of these options, or --side, was given: the verb's question has no lines in space.
void refuse_lines(const Options& options, const char* because);

}  // namespace findspace::app
