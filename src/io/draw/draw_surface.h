// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What is to be seen of a surface of flat faces in the view of draw_view.h: faces towards the eye with the light that
// falls on them, from back to front, each with those of its edges that are creases or lie on the silhouette. So a fine
// mesh shows its form and not its net. Guarantee: every edge at which faces meet at more than 25 degrees, or at which
// one face is seen and the other is not, is given. Cost: n log n. Keywords: painter's algorithm, flat shading, creases.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace findspace::io {

using Edge3 = std::array<int, 2>;  // of vertices

struct SeenFace {
  std::vector<int> ring;
  double light = 1;  // 0 where it falls along the face
  double depth = 0;  // towards the eye
  std::vector<Edge3> edges;
};

struct SeenSurface {
  std::vector<SeenFace> faces;  // from back to front; faces of two corners are lines
  std::vector<Edge3> hidden;    // creases behind; none where they are many
};

SeenSurface seen_surface(const std::vector<std::array<double, 3>>& vertices,
                         const std::vector<std::vector<int>>& faces);

/// "#rrggbb": a colour darkened where less light falls.
std::string shaded(const std::array<int, 3>& colour, double light);

}  // namespace findspace::io
