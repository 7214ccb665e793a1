// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A tree of shapes in the plane mirrored in the x axis, (x, y) to (x, -y): the same tree over mirrored leaves, since
// all constructions commute with it. Guarantee: exact. Cost: linear. Keywords: axis reflection, flip.
#pragma once

#include "plane/contour/shape.h"

namespace findspace::io {

/// Throws Error(kUnsupported) for a leaf in space.
plane::ShapePtr mirrored_in_x_axis(const plane::ShapePtr& shape);

}  // namespace findspace::io
