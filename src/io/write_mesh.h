// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Surfaces out: OBJ, OFF and ASCII STL, and a wireframe picture in SVG with hidden lines dashed.
// Guarantee: OBJ and OFF keep polygons and the shortest decimals that read back the same; STL triangulates faces about
// their first corner (faces are convex). The picture is an orthogonal view; an edge is hidden if both its faces look
// away.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace findspace::io {

/// Convex faces, counter-clockwise from outside, in the scene's unit.
struct Surface {
  std::vector<std::array<double, 3>> vertices;
  std::vector<std::vector<int>> faces;
  std::vector<std::string> labels;  // one a face, or none: the groups of OBJ
};

std::string obj_text(const Surface& surface, std::string_view title);
std::string off_text(const Surface& surface);
std::string stl_text(const Surface& surface, std::string_view title);
std::string svg_text(const Surface& surface, std::string_view title);

/// By the ending .obj .off .stl .svg; throws Error(kUnsupported) for another.
std::string surface_text(const Surface& surface, std::string_view title, std::string_view ending);

}  // namespace findspace::io
