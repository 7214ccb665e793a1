// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A point of a cell that stands well for it: of a face one with clearance around it, of an edge its middle. Guarantee:
// the point of a face is strictly inside, proved by exact point location; wherever there is clearance it is a grid
// point with few digits. Method: the middles of the gaps along vertical lines, climbing from the best to more
// clearance; in a face too thin for doubles the exact middle over one of its edges. Cost: O(n) and at most some 2
// million distances a face. Keywords: interior point, label point, pole of inaccessibility.
#pragma once

#include <optional>
#include <vector>

#include "plane/query/locate.h"
#include "plane/query/measure_cells.h"

namespace findspace::plane {

class Sampler {
 public:
  Sampler(const Region& s, const CellMeasures& measures);

  exact::RealPoint inside_face(Index face);
  exact::RealPoint middle_of_edge(Index edge) const;

 private:
  exact::RealPoint exact_inside_face(Index face);
  bool is_inside(const exact::RealPoint& p, Index face);

  const Region& s_;
  const CellMeasures& measures_;
  std::optional<Locator> locator_;         // made when several points are asked for
  int located_ = 0;                        // points, without it
  std::vector<Index> start_, half_edges_;  // face -> half-edges
};

}  // namespace findspace::plane
