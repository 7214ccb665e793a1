// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The Phi-function of two bodies of the plane in text: the JSON result of the verb `phi`, and a readable table.
// Coordinates are in the scene's unit; lines are coprime integers a x + b y + c <= 0 (inside) in that unit, exactly.
// Vertices of a part count counter-clockwise from the leftmost one (of several the lowest).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/write/write_phi.h"
#include "space/phi/planar_phi_union.h"

namespace findspace::io {

struct PlanarPhiReport {
  std::string first, second;  // names of A and B
  const space::PlanarPhiUnion* phi = nullptr;
  int parts_second = 1;
  exact::Real step;                    // of the parts' grid, in the scene's unit
  std::optional<exact::RealPoint> at;  // the position asked for, in the scene's unit
  std::optional<space::PlanarPhiUnion::At> value;
  std::vector<PhiLimit> limits;
};

std::string planar_phi_json(const PlanarPhiReport& report);
std::string planar_phi_table(const PlanarPhiReport& report);

}  // namespace findspace::io
