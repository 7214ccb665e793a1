// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What certainly lies in the open Minkowski sum of two sets: a box that, moved back by a corner of one set, lies in
// cells inside the other. Curves of the convolution that lie so need not be made, and points need no winding number.
// Where outlines of many chords are added, most curves are of this kind, and nearly coincide with others. inner_mask.h
// asks the same of cells of a common lattice, which is coarse next to such curves; here each set has a lattice of its
// own.
// Guarantee: a box that is covered lies in the open sum; many others do, too. Only conservative double arithmetic; no
// sign is decided. Cost: the lattices once; a question looks at some dozens of corners, mostly at one.
// Keywords: hole filter, collision test, distance transform.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "plane/base/cell_depths.h"
#include "plane/grid/grid_faces.h"

namespace findspace::plane {

struct CoveredBox {
  double x0, y0, x1, y1;
};

class CoveredCurves {
 public:
  /// Of the faces of two bounded sets; keeps references.
  CoveredCurves(const GridFaces& a, const GridFaces& b) : faces_{&a, &b} {}

  bool prepared() const { return sets_.has_value(); }
  /// The box lies in the open sum. Prepares what it needs when asked first; one thread at a time.
  bool covers(const CoveredBox& box);

 private:
  struct Spot {
    double x, y;
  };
  /// Some corners, spread over an outline, and for places about it those that are near.
  class Corners {
   public:
    explicit Corners(const GridFaces& faces);
    /// The corners to try, the nearest first; not all.
    std::span<const Spot> near(const Spot& place) const;

   private:
    double x0_ = 0, y0_ = 0, columns_per_step_ = 0, rows_per_step_ = 0;
    std::size_t each_ = 0;
    std::vector<Spot> near_;  // `each_` of every bucket
  };
  struct Set {
    double side = 0;
    CellDepths depths;
    Spot deep{0, 0};  // where a large box has most room
    Corners corners;
    std::optional<Spot> last;  // the corner that served last

    explicit Set(const GridFaces& faces);
    bool covers(double x, double y, double half) const;
  };
  static bool covers(const Set& cells, Set& moved, const CoveredBox& box);

  std::array<const GridFaces*, 2> faces_;
  std::optional<std::array<Set, 2>> sets_;
};

}  // namespace findspace::plane
