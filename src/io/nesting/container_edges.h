// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The lines by which a container of solids is drawn, in the view of draw_view.h: edges of a box or a surface; of a
// union of convex parts those of its boundary; of a ball its outline and equator. Guarantee: that of doubles; edges of
// a union at which faces meet at less than some ten degrees may be left out. Cost: of a union the edges of its parts
// times the planes of all others. Keywords: wireframe, creases, silhouette.
#pragma once

#include <array>
#include <vector>

#include "packing/solid_problem/solid_problem.h"

namespace findspace::io {

using Point3d = std::array<double, 3>;

struct DrawnEdge {
  Point3d from, to;
  bool is_in_front;  // of what the container holds
};

std::vector<DrawnEdge> edges_of_box(double x, const Point3d& sides);
/// Moved by x.
std::vector<DrawnEdge> edges_of_container(double x, const packing::SolidProblem& problem,
                                          const packing::SolidContainer& container);

}  // namespace findspace::io
