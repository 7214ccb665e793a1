// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Simple convex pieces for rays: polytopes and half spaces, balls, cylinders with flat ends, slabs about polygons.
// Balls, cylinders and slabs about the vertices, edges and polygons of a set are together the set grown by their
// radius, and their interiors hold the points nearer than the radius: every projection lies inside a polygon, inside an
// edge or is a vertex. Guarantee: exact. Keywords: offset surface, capsule, rounded polytope, Minkowski sum with a
// ball.
#pragma once

#include <vector>

#include "space/polytope/convex_region.h"

namespace findspace::space {

/// {x : all planes <= 0, |x - base| <= radius}, the latter without its part along `direction` where there is one.
struct LinePiece {
  std::vector<HalfSpace> planes;
  std::vector<char> held;  // whether points on plane k count as inner ones; empty: none do
  bool round = false;
  bool held_round = false;                // the same of points at the radius
  RealVector base{}, direction{}, tip{};  // tip: where the axis ends; of a ball its centre
  exact::Real radius{};
  Vector low, high;  // a box that holds it; may be infinite
};

/// The open half spaces' intersection; the box is found by cutting `around`, or infinite.
LinePiece polytope_piece(std::vector<HalfSpace> planes, const Vector& low, const Vector& high);
LinePiece ball_piece(const RealVector& center, const exact::Real& radius);
LinePiece cylinder_piece(const RealVector& from, const RealVector& to, const exact::Real& radius);
/// About a convex polygon, given counter-clockwise about the normal.
LinePiece slab_piece(std::span<const RealVector> ring, const RealVector& normal, const exact::Real& radius);
/// Balls, cylinders and slabs of the radius (more than 0) about the vertices, edges and facets of a set of any
/// dimension.
void add_round_pieces(const ConvexRegion& set, const exact::Real& radius, std::vector<LinePiece>& pieces);
/// Every point of the piece counts as inner.
void hold(LinePiece& piece);
LinePiece moved(LinePiece piece, const RealVector& by);
/// Every ball and cylinder of one radius only once.
void drop_repeated(std::vector<LinePiece>& pieces);

}  // namespace findspace::space
