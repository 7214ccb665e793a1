// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Surfaces out: OBJ, OFF and ASCII STL, and a wireframe picture in SVG with hidden lines dashed; PLY, GLB, 3MF and STEP
// by write_mesh_binary.h, mesh_3mf.h and mesh_step.h. Guarantee: OBJ, OFF, PLY and STEP keep polygons and every bit of
// the vertices; STL, GLB and 3MF triangulate faces about their first corner (faces are convex). The picture is an
// orthogonal view; an edge is hidden if both its faces look away.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace findspace::io {

/// Convex faces, counter-clockwise from outside, in the scene's unit. Only OBJ takes faces of two corners or one, as
/// lines and points.
struct Surface {
  std::vector<std::array<double, 3>> vertices;
  std::vector<std::vector<int>> faces;
  std::vector<std::string> labels;  // one a face, or none: the groups of OBJ
};

std::string obj_text(const Surface& surface, std::string_view title);
std::string off_text(const Surface& surface);
std::string stl_text(const Surface& surface, std::string_view title);
std::string svg_text(const Surface& surface, std::string_view title);

/// The endings that surface_text() knows.
inline constexpr std::array<const char*, 8> kSurfaceEndings{".obj", ".off",  ".stl", ".ply",
                                                            ".glb", ".step", ".3mf", ".svg"};

/// By the ending; throws Error(kUnsupported) for another. `unit`: the scene's, for formats that state one; may be
/// empty.
std::string surface_text(const Surface& surface, std::string_view title, std::string_view ending,
                         std::string_view unit);

}  // namespace findspace::io
