// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Surfaces of flat faces, as other programs have them. Guarantee: vertices are the exact ones, or points of the true
// boundary, rounded once. Cost of text: linear. Keywords: mesh, trimesh, OBJ, STL, PLY, GLB.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "findspace/number.h"

namespace findspace {

/// Flat faces, counter-clockwise seen from outside, by their vertices counted from 0.
struct Surface {
  /// Its corners.
  std::vector<Position3> vertices;
  /// Circuits of corners.
  std::vector<std::vector<int>> faces;

  /// As a file: ".obj", ".off", ".stl", ".ply", ".glb", ".3mf", ".step", or a picture, ".svg"; the unit for those that
  /// state one. Error(kUnsupported) for another ending.
  std::string text(std::string_view ending, std::string_view unit = {}) const;
};

}  // namespace findspace
