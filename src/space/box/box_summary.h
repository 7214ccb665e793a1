// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What a set with axis-parallel faces is like, in numbers: the summary of plane/query/summary.h one dimension higher.
// Two cells are connected where one lies in the closure of the other and both belong. Truth values and counts are
// exact; volumes, areas and lengths are exact numbers given as the nearest double. Cost: linear in the cells. Keywords:
// connected components, cavities, Betti numbers.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "space/box/box_complex.h"

namespace findspace::space {

using Place3 = std::array<double, 3>;

struct PlaceBox {
  Place3 low{}, high{};
};

struct SpaceComponent {
  int dimension = 0;             // the highest of its cells
  std::optional<double> volume;  // none where unbounded
  double dangling_area = 0, dangling_length = 0;
  int holes = 0;  // bounded components of its own complement
  Place3 sample{};
  std::optional<PlaceBox> bbox;  // none where unbounded
};

struct SpaceSummary {
  bool empty = true, whole = false, bounded = true;
  bool open = true, closed = true, regular = true;
  std::optional<double> volume;                   // none where unbounded
  double dangling_area = 0, dangling_length = 0;  // of sheets and lines of the set outside the closure of its interior
  double crack_area = 0, crack_length = 0;  // of sheets and lines missing from it inside the interior of its closure
  int holes = 0;                            // bounded components of the complement
  std::vector<Place3> isolated;
  std::optional<PlaceBox> bbox;
  std::vector<SpaceComponent> components;  // higher dimension first, then by their samples
};

/// `step`: one unit of the coordinates in the unit of the results.
SpaceSummary summarize(const BoxComplex& set, const exact::Real& step);

}  // namespace findspace::space
