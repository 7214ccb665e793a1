// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Places on an arc by which a format states it, such that whoever rounds each of them to a grid is off by three grid
// steps at most. An arc by bulge or by three points of nearly a full circle would be off by much more: its radius is a
// multiple of the small chord. So it is divided. Places where a circle of the grid has grid points are taken first: the
// leftmost, rightmost, highest and lowest ones. Cost: constant. Source: a bulge b moves the middle of its arc by b / 2
// times what the chord grows; of three points each moves the arc by at most itself times 1 where none is nearer to
// another than a third of the way. Keywords: ill-conditioned arcs, three-point arc, bulge.
#pragma once

#include <vector>

#include "plane/query/curve_net.h"

namespace findspace::io {

struct ArcPlace {
  plane::Place at{};
  double angle = 0;  // from the beginning of the arc
};

/// Both ends, and between them what divides an arc of more than half a circle into pieces of a quarter at most.
std::vector<ArcPlace> divided_arc(const plane::CurveNet& net, const plane::CurveNet::Curve& arc);

/// Both ends of each piece of half a circle at most, or of little more, and a place near its middle: an odd number.
std::vector<ArcPlace> three_point_arcs(const plane::CurveNet& net, const plane::CurveNet::Curve& arc);

}  // namespace findspace::io
