// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The faces of an arrangement: boundary cycles, and for every connected component of curves the face it lies in, found
// by a vertical ray from its leftmost vertex through the cell grid. Guarantee: exact. Cost: O(edges) and one ray a
// component.
#pragma once

#include "plane/complex/broad_phase.h"

namespace findspace::plane {

/// Fills face, face_count and isolated_face.
void nest(Arrangement& a, const CellGrid& grid, Memory memory);

}  // namespace findspace::plane
