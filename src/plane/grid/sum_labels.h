// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

// Which cells of an arranged reduced convolution lie in the open sum. A face that has the inner side of a curve is
// inside; what is left, a few faces, edges and vertices, is decided by the displaced winding number of the whole
// convolution at one of their points. Guarantee: exact. Cost: linear, and what the decisions cost. Source: winding.h.
#pragma once

#include <functional>

#include "plane/grid/reduced_convolution.h"

namespace findspace::plane {

/// Is the point of this geometry, to which points and supporting curves may be added, in the open sum?
using InsideTest = std::function<bool(exact::Geometry&, Index point)>;

/// -1 on the open sum, 0 on its boundary, +1 elsewhere. `sides`: of the arrangement's pieces; those
/// beyond the last are not curves of the sum. `unbounded_inside`: far away.
SignMap labelled_sum(Arrangement arrangement, const std::vector<InnerSide>& sides, bool unbounded_inside,
                     const InsideTest& inside);

}  // namespace findspace::plane
