// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A Phi-function in text: the JSON result of the verb `phi`, a readable table, and the surface for the mesh writers.
// Coordinates are in the scene's unit. Planes are coprime integers a x + b y + c z + d <= 0 (inside) in that unit,
// exactly.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/write_mesh.h"
#include "space/phi_union.h"

namespace findspace::io {

struct PhiReport {
  std::string first, second;  // names of A and B
  const space::PhiUnion* phi = nullptr;
  int parts_first = 1, parts_second = 1;
  exact::Real step;                  // of the polytopes' grid, in the scene's unit
  std::optional<exact::Real> at[3];  // the position asked for, in the scene's unit
  std::optional<space::PhiUnion::At> value;
};

std::string phi_json(const PhiReport& report);
std::string phi_table(const PhiReport& report);
/// The contact surfaces of all pairs of parts; faces are labelled with their contact types.
Surface phi_surface(const PhiReport& report);

/// [a, b, c, d] of a plane given in grid steps, for coordinates in the scene's unit.
std::vector<std::string> plane_numbers(const space::Plane& plane, const exact::Real& step);

}  // namespace findspace::io
