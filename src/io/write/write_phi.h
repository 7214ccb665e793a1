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

#include "io/mesh/write_mesh.h"
#include "space/body/rounded_phi.h"

namespace findspace::io {

/// A least or a greatest allowed distance (adjusted Phi-function) at the position asked for: Phi - distance or
/// distance - Phi, with Phi normalised.
struct PhiLimit {
  bool minimum = true;
  exact::Real distance;  // in the scene's unit
  double value = 0;
  int sign = 0;  // exact; >= 0: the limit is kept
};
/// `, "adjusted": [...]`, or nothing.
std::string limits_json(const std::vector<PhiLimit>& limits);
/// A line a limit.
std::string limits_table(const std::vector<PhiLimit>& limits);

const char* state_name(space::State state);

struct PhiReport {
  std::string first, second;  // names of A and B
  const space::RoundedPhi* phi = nullptr;
  int parts_first = 1, parts_second = 1;
  exact::Real step;                  // of the polytopes' grid, in the scene's unit
  std::optional<exact::Real> at[3];  // the position asked for, in the scene's unit
  std::optional<space::RoundedPhi::At> value;
  std::vector<PhiLimit> limits;
};

std::string phi_json(const PhiReport& report);
std::string phi_table(const PhiReport& report);
/// The contact surfaces of all pairs of parts; faces are labelled with their contact types. Throws
/// Error(kUnsupported) where a pair has a ball: its surface is not a polyhedron.
Surface phi_surface(const PhiReport& report);

/// "6y - 5z + 29 <= 0": the coefficients of the coordinates, then the constant.
std::string half_space_text(const std::vector<std::string>& numbers);

/// [a, b, c, d] of a plane given in grid steps, for coordinates in the scene's unit.
std::vector<std::string> plane_numbers(const space::Plane& plane, const exact::Real& step);

}  // namespace findspace::io
