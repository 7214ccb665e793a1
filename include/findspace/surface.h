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

  /// Of a shape: what it has that flat faces cannot hold; else empty.
  std::string lost{};

  /// As a file of that ending, or a picture, ".svg"; the unit and the name for those that state them.
  /// Error(kUnsupported) for another ending.
  std::string text(std::string_view ending, std::string_view unit = {}, std::string_view name = "surface") const;
  /// ".obj", ".off", ".stl", ".ply", ".glb", ".step", ".3mf", ".svg".
  static std::vector<std::string> endings();
  /// A scene with what it encloses as its one shape.
  std::string scene_json(std::string_view name, std::string_view unit = {}) const;
};

}  // namespace findspace
