// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The places about which a body is missing that another may hold while its surface is near the body: a place within the
// other one that is farther from the body than any around it is surrounded by its nearest places. In a box from all of
// whose places some way leads off all triangles that may be nearest there is none; boxes are divided until that is so,
// or all of the box is farther than a level. Guarantee: each place that is the farthest one around it, by more than
// `least`, is in a part of space that is farther than `most` and holds one of the places; nothing where that is not
// found. Cost: some microseconds a box, of which there are some ten thousand about a mesh of as many triangles.
// Keywords: critical points of a distance function, medial axis, Clarke gradient.
#pragma once

#include <optional>
#include <vector>

#include "distance/rays/protrusion_rays.h"
#include "distance/surface/surface_field.h"

namespace findspace::distance {

/// 0 < least < most.
std::optional<std::vector<VoidPlace>> void_places(const SurfaceField& body, double least, double most);

}  // namespace findspace::distance
