// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A box around all curves and points of a complex: outside it the mark is that of the unbounded face. Guarantee: the
// box holds them; it may be larger by the rounding of doubles. No sign is decided. Cost: linear. Keywords: bounding
// box, locality, culling.
#pragma once

#include <optional>
#include <span>

#include "plane/complex/broad_phase.h"
#include "plane/complex/cell_complex.h"
#include "plane/contour/shape.h"

namespace findspace::plane {

/// Nothing for a complex of one face.
std::optional<PieceBox> extent(const CellComplex& c);

/// Whether no vertex is farther along x or y, as far as doubles tell.
bool is_within(const CellComplex& c, double most);

/// Of one ring or more, with the whole circles of their arcs.
PieceBox extent(std::span<const Contour> rings);

/// A box around one edge with its ends.
PieceBox edge_box(const CellComplex& c, Index edge);

/// The box moved; again a box that holds what the first one held.
PieceBox moved(const PieceBox& box, const exact::RealPoint& by);

}  // namespace findspace::plane
