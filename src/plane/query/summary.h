// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What a region of the plane is like, in numbers: topology, measures, connected components (docs/results.md).
// The truth values and the counts are exact, about the point set itself: two cells are connected where one lies in the
// closure of the other and both belong to the set (or both to the complement). Coordinates, lengths and areas are
// computed from the exact boundary and given as the nearest double but for an ulp or so, in the unit in which the grid
// step is given. Cost: O(n log n). Keywords: connected components, genus, isolated points, whiskers, cracks, bounding
// box, area.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "plane/complex/cell_complex.h"

namespace findspace::plane {

using Place = std::array<double, 2>;

/// The smallest box whose closure contains the set.
template <class Place>
struct BoundsOf {
  Place low{}, high{};
};
using Bounds = BoundsOf<Place>;

/// What is said of a component in the plane and in space; `Place`: a point in the unit of the results.
template <class Place>
struct ComponentOf {
  int dimension = 0;  // the highest of its cells
  double dangling_length = 0;
  int holes = 0;                        // bounded components of its own complement
  Place sample{};                       // a point of it, strictly inside where it has an interior
  std::optional<BoundsOf<Place>> bbox;  // none where unbounded
};

struct Component : ComponentOf<Place> {
  std::optional<double> area;     // none where unbounded
  exact::RealPoint sample_point;  // the sample exactly, in grid steps
};

/// What is said of a set in the plane and in space.
template <class Place, class Component>
struct SummaryOf {
  bool empty = true, whole = false, bounded = true;
  bool open = true, closed = true, regular = true;
  double dangling_length = 0;           // of the curves of the set outside the closure of its interior
  double crack_length = 0;              // of the curves missing from it inside the interior of its closure
  int holes = 0;                        // bounded components of the complement
  std::vector<Place> isolated;          // its isolated points, from left to right
  std::optional<BoundsOf<Place>> bbox;  // none where empty or unbounded
  std::vector<Component> components;
};

/// Components: unbounded first, then higher dimension, then from left to right.
struct Summary : SummaryOf<Place, Component> {
  std::optional<double> area;  // none where unbounded
};

/// `step`: one grid step in the unit of the results.
Summary summarize(const Region& s, const exact::Real& step);

}  // namespace findspace::plane
