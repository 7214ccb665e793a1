// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A curve as a chain of circular arcs and segments between grid points, within a bound and on a chosen side.
//
// Guarantee (arc_proof.h proves each arc): every point of the chain is within `bound` of the curve and the other way
// round. With side kLeft the chain goes round no point that the curve goes round clockwise less often, that is: closed
// curves with their material on the right become sets that contain it, up to the caps; kRight is the mirror image. Caps
// are boxes of a diameter of at most `bound` about places where no arc could be proved (cusps, corners, ends): the set
// joined with them, or for material on the other side less them, holds the bound on its side. Without a side there are
// no caps. The ends of the curve are ends of the chain.
//
// Number of arcs: each reaches as far as it can, so about (c k' / bound)^(1/3) per unit of length, where k' is the
// derivative of the curvature and c = 1/125 (near) or 1/36 (one side, at 7/8 of the bound); biarcs with common tangents
// need 1.45 times as many (Meek and Walton, "Approximating smooth planar curves by arc splines", 1995: error
// k' H^3 / 324 of two arcs over length H). Cost: about 20 us an arc.
// Keywords: arc spline, biarc, offset curve, tolerance band, curve flattening (not used).
#pragma once

#include <vector>

#include "plane/curve/arc_proof.h"

namespace findspace::plane {

/// Closed box of grid points.
struct CapBox {
  GridPoint low, high;
};

struct ArcChain {
  Contour edges;  // without the end point
  std::vector<CapBox> caps;
};

/// The least bound, in grid steps.
inline constexpr double kLeastBound = 64;

/// Throws Error(kBadValue) for a bound below kLeastBound.
ArcChain arcs_of(const Curve& curve, double bound, CurveSide side);

}  // namespace findspace::plane
