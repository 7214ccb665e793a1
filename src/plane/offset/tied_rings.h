// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The sign map of an open set D whose boundary is rings that may touch, slits and single points: other than in
// ring_map.h their vertices and faces have to be found. Guarantee: exact. Cost: that of joined_pieces.h. Used by
// grid_offset.cpp only.
#pragma once

#include <span>
#include <vector>

#include "plane/complex/ring_map.h"
#include "plane/offset/offset_ties.h"

namespace findspace::plane {

/// `edges`: ring by ring, which begin at `starts`. `unbounded`: so is D.
SignMap tied_ring_map(OffsetCurves&& curves, const OffsetMeetings& meetings, const OffsetTies& ties,
                      std::span<const RingEdge> edges, std::span<const Index> starts, RingMarks marks, bool unbounded);

}  // namespace findspace::plane
