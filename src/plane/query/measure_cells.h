// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Coordinates, lengths and areas of the cells of a complex as numbers, in grid steps. Guarantee: computed from the
// coordinates with 94 bits or more (measure_cells_places.h), arcs by their angles, so that a double made from a result
// is right to the last place or two even for slivers and thin rings. Cost: about a microsecond a vertex and an arc.
// Source: Green's formula, area = 1/2 of the integral of x dy - y dx around the boundary.
// Keywords: polygon area, arc length, circular segment, shoelace formula.
#pragma once

#include <array>
#include <vector>

#include "plane/complex/cell_complex.h"
#include "plane/query/measure_cells_twofold.h"

namespace findspace::plane {

class CellMeasures {
 public:
  /// Keeps a reference to the complex.
  explicit CellMeasures(const CellComplex& c);

  Twofold x(Index vertex) const { return x_[vertex]; }
  Twofold y(Index vertex) const { return y_[vertex]; }
  Twofold length(Index edge) const;
  /// Areas of the bounded faces that are in the set; 0 for all other faces.
  std::vector<Twofold> face_areas() const;
  /// The angle an arc subtends at its centre, in (0, pi].
  Twofold angle(Index arc) const;

  struct Circle {
    Twofold x, y, radius;
  };
  /// Centre and radius of the circle that carries an arc.
  Circle circle(Index arc) const;

 private:
  void add_circles();
  struct Spread {
    Twofold cross, dot;  // of the vectors from the centre to the arc's ends, in counter-clockwise order
  };
  Spread spread(Index arc) const;
  /// From the centre of the circle to an end of the arc.
  std::array<Twofold, 2> directed_edge(Index arc, Index vertex) const;
  Twofold swept_area(Index half_edge, const Twofold& ox, const Twofold& oy) const;

  const CellComplex& c_;
  std::vector<Twofold> x_, y_;
  std::vector<Twofold> radii_;                     // of circles about grid points, which share them
  std::vector<Circle> circles_;                    // the other ones
  std::vector<Index> circle_of_supporting_curve_;  // among the ones or the others
};

}  // namespace findspace::plane
