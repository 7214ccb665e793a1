// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What a set with axis-parallel faces is like, in numbers: the summary of plane/query/summary.h one dimension higher.
// Two cells are connected where one lies in the closure of the other and both belong. Truth values and counts are
// exact; volumes, areas and lengths are exact numbers given as the nearest double. Cost: linear in the rows
// of cells and their runs. Keywords:
// connected components, cavities, Betti numbers.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "plane/query/summary.h"
#include "space/box/box_complex.h"

namespace findspace::space {

using Place3 = std::array<double, 3>;

using PlaceBox = plane::BoundsOf<Place3>;

struct SpaceComponent : plane::ComponentOf<Place3> {
  std::optional<double> volume;  // none where unbounded
  double dangling_area = 0;
};

/// Components: higher dimension first, then by their samples.
struct SpaceSummary : plane::SummaryOf<Place3, SpaceComponent> {
  std::optional<double> volume;  // none where unbounded
  double dangling_area = 0;      // of sheets of the set outside the closure of its interior
  double crack_area = 0;         // of sheets missing from it inside the interior of its closure
};

/// `step`: one unit of the coordinates in the unit of the results.
SpaceSummary summarize(const BoxComplex& set, const exact::Real& step);

}  // namespace findspace::space
