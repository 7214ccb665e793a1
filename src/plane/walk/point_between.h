// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Some point inside a part of a curve, about in its middle: where a question is asked that has one answer along all of
// it. Guarantee: exactly on the curve. Cost: a crossing; exact coordinates for parts shorter than two grid steps.
#pragma once

#include "plane/complex/cell_complex.h"

namespace findspace::plane {

/// A point of the supporting curve strictly between two of its points.
Index point_between(exact::Geometry& geometry, Index supporting_curve, Index p, Index q);

}  // namespace findspace::plane
