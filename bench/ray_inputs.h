// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Meshes for ray_bench: generated ones, and files made coarser by edge collapses, so that one mesh gives any size.
#pragma once

#include <string>

#include "space/convolution/ray_body.h"

namespace ray_bench {

using findspace::space::Point;
using findspace::space::Triangles;

/// Grid steps to a unit of length.
inline constexpr double kUnit = 1e6;

Triangles octahedron(double radius);
/// A bumpy sphere of 2 * around * across - 2 * around triangles, or a little more: non-convex, closed.
Triangles bumpy_sphere(double radius, double bump, int waves, int around, int across);
/// Vertices and faces of an OBJ file, in units.
Triangles read_obj(const std::string& path);
/// Collapses shortest edges, ends kept where they are, until at most `faces` are left. Edges whose collapse would turn
/// a face over by much, or make it meet another one (exactly decided), are left out.
Triangles coarser(const Triangles& mesh, int faces);

}  // namespace ray_bench
