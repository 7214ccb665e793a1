// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The greatest signed distance of a point of B + p to A, which are given by their surfaces: how far B protrudes from A,
// where it does. A cell that a tetrahedron fills is bounded by the signed distance of its centre and its size, as no
// distance grows faster than a step; where few triangles can be nearest in it, by the linear program of their
// distances, which are convex (tetrahedral_max_min.h). The centre's signed distance is that to the nearest triangle of
// a tree of boxes, its sign exact. Cells fill B's parts where they are known; else the box about B, less what is found
// to lie outside B, and what a corner is beyond a plane of its hull may be taken off its distances. Guarantee: doubles;
// no point has more than `bound`, which is within 2^-40 of the value, or of the sizes, unless kMostMaxMinCells cells
// were not enough
// (`complete` is false then). Cost: some ten microseconds a cell, where triangles are small a thousand cells. Keywords:
// directed Hausdorff distance, branch and bound.
#pragma once

#include "distance/search/round_solid.h"
#include "space/surface/surface_set.h"

namespace findspace::distance {

inline constexpr int kMostMaxMinCells = 60000;

/// Signed distances to a set given by its surfaces, in doubles.
class SurfaceField {
 public:
  /// Moved by `by`. Keeps a reference.
  SurfaceField(const space::SurfaceSet& set, const space::Vector& by);

  struct Signed {
    double value = 0;            // negative inside
    double distance = 0;         // from the surface that is nearest
    bool certain = false;        // near the surface the side is not decided; the value counts as outside
    space::Vector projection{};  // the nearest place of the surface
  };
  /// Inside a union it is not less than the true one; outside it is that.
  /// `known`: some place of the surface is no farther.
  Signed at(const space::Vector& x, double known = exact::kInfinity) const;
  /// The triangles and balls to which some place within `within` of x may be nearest, by number, if they are not more
  /// than `most`.
  std::optional<std::vector<int>> near(const space::Vector& x, double within, std::size_t most) const;
  /// From one of them.
  double distance(int part, const space::Vector& x) const;
  const space::SurfaceSet& set() const { return set_; }
  const space::Vector& by() const { return by_; }

 private:
  const space::SurfaceSet& set_;
  space::Vector by_;
  std::vector<int> first_;  // the numbers of the triangles of each surface begin there; those of the balls last
};

/// B as its parts, already moved, or by its field.
struct MaxMinDomain {
  std::vector<Tetrahedron> cells;
  std::vector<RoundSolid> round;  // balls
  const SurfaceField* within = nullptr;
  std::vector<space::HalfSpace> planes{};  // of the convex hull of a B that is not of known parts
  std::vector<space::Vector> corners;      // of B
};

SolidMaxMin surface_max_min(const MaxMinDomain& domain, const SurfaceField& a);

}  // namespace findspace::distance
