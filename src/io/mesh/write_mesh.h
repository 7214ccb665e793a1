// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Surfaces out: OBJ, OFF and ASCII STL, and a picture in SVG: a wireframe with hidden lines dashed, or the surface of a
// large mesh; PLY, GLB, 3MF and STEP by write_mesh_binary.h, mesh_3mf.h and mesh_step.h. Guarantee: OBJ, OFF, PLY and
// STEP keep polygons and every bit of the vertices; STL, GLB and 3MF triangulate faces about their first corner (faces
// are convex). The picture is an orthogonal view; an edge is hidden if both its faces look away.
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

/// Surfaces that stand in several places: 3MF and GLB hold each of them once, with where its copies stand.
struct Assembly {
  struct Kind {
    std::string name;
    Surface surface;
  };
  /// A point p of the surface is at rotation p + at.
  struct Copy {
    std::size_t kind = 0;
    std::string name;
    std::array<std::array<double, 3>, 3> rotation{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};  // rows
    std::array<double, 3> at{};
    bool is_moved() const { return *this != Copy{kind, name}; }
    friend bool operator==(const Copy&, const Copy&) = default;
  };
  std::vector<Kind> kinds;
  std::vector<Copy> copies;
};
/// One surface alone, where it is.
Assembly assembly_of(Surface surface);
/// All copies as one surface; the labels are their names.
Surface united(const Assembly& assembly);

std::string obj_text(const Surface& surface, std::string_view title);
std::string off_text(const Surface& surface);
std::string stl_text(const Surface& surface, std::string_view title);
std::string svg_text(const Surface& surface, std::string_view title, std::string_view unit);

/// The endings that surface_text() knows.
inline constexpr std::array<const char*, 8> kSurfaceEndings{".obj", ".off",  ".stl", ".ply",
                                                            ".glb", ".step", ".3mf", ".svg"};

/// By the ending; throws Error(kUnsupported) for another. `unit`: the scene's, for formats that state one; may be
/// empty.
std::string surface_text(const Surface& surface, std::string_view title, std::string_view ending,
                         std::string_view unit);
/// The same: copies are kept apart in 3MF and GLB, as groups in OBJ, and nowhere else.
std::string assembly_text(const Assembly& assembly, std::string_view title, std::string_view ending,
                          std::string_view unit);

}  // namespace findspace::io
