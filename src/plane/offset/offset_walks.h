// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The closed walks along curves that can be boundary of D (offset_curves.h), with D on their left: at every crossing
// and tie they turn to the outside. Guarantee: exact; every ring of the boundary is among them. Cost: linear. Source:
// docs/decisions/0012-offsets-by-outer-walks.md. Keywords: outer boundary, trimmed parallel curve.
#pragma once

#include <array>
#include <vector>

#include "plane/complex/ring_map.h"
#include "plane/offset/offset_meetings.h"
#include "plane/offset/offset_ties.h"

namespace findspace::plane {

struct OffsetWalks {
  struct Ring {
    Index start;                  // its first edge; it ends before the next
    std::array<Index, 2> pieces;  // at its first corner
    bool tied;                    // it passes a tie, so it is boundary
  };

  std::vector<RingEdge> edges;
  std::vector<Ring> rings;
};

OffsetWalks offset_walks(const OffsetCurves& curves, const OffsetMeetings& meetings, const OffsetTies& ties);

}  // namespace findspace::plane
