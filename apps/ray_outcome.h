// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A set on the lines of a grid as the answer of a verb: numbers, lines and surface.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "session.h"
#include "situation/solve_rays.h"
#include "space/ray_extreme.h"

namespace findspace::app {

struct RaySet {
  std::string title;
  int resolution = 0;                                                              // lines each way
  bool axes = false;                                                               // along all three axes
  space::Point low, high;                                                          // a box that holds the frontier
  bool unbounded = false;                                                          // the set goes on beyond it
  std::optional<space::RayAim> aim;                                                // what is looked for in the set
  std::function<std::unique_ptr<space::RaySource>(const space::RayGrid&)> source;  // at most 0 in the set
};

/// The scene's shapes for rays; refers to them.
situation::RayWorld ray_world(const Session& session);

Outcome rays_outcome(const Session& session, const RaySet& set);

}  // namespace findspace::app
