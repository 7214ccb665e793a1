// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// How a closed surface meets itself. It crosses itself where two of its triangles show a place that the solid behind
// one and the solid behind the other both cover (space/convolution/ray_overlap.h, 1 to 4). Parts of a surface that
// touch, from outside or across a slit of no width, do not cross; where faces lie on each other the solid goes on
// across them. Guarantee: exact, the same for any number of threads. Cost: the pairs of triangles whose boxes meet, in
// parallel, but for those that a plane parts with many others (parting_plane.h). Where they cost more units than the
// asker allows, Error(kLimit). Keywords: self-intersection, mesh validation.
#pragma once

#include <array>
#include <optional>

#include "space/convolution/ray_boxes.h"

namespace findspace::space {

struct SelfContact {
  std::optional<std::array<int, 2>> crossing;  // the least pair of faces that cross, by number
  bool inner_walls = false;                    // there are faces that lie on each other, the solid on both sides
};
SelfContact self_contact(const RaySheet& sheet);

}  // namespace findspace::space
