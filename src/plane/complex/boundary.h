// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The boundary of a set as directed closed paths, the set on their left: what a convolution takes. A set is given as
// parts: open faces of a complex, and (for closed sets) the curves and points outside the closure of its interior,
// which are walked on both sides. Guarantee: exact. Cost: linear; a bridge between a hole and its surroundings is
// linear in the face. Keywords: boundary cycles, weakly simple polygon, keyhole.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "plane/complex/cell_complex.h"

namespace findspace::plane {

/// A point: integer, or a pair of exact reals.
struct Position {
  std::int64_t x = 0, y = 0;
  std::shared_ptr<const exact::RealPoint> real;  // null: the grid point (x, y)

  bool grid() const { return !real; }
  static Position of(const exact::Geometry& g, Index point);
  static Position of(const exact::Real& x, const exact::Real& y);
  exact::Real real_x() const { return real ? real->x : exact::Real(x); }
  exact::Real real_y() const { return real ? real->y : exact::Real(y); }
  double approx_x() const { return real ? middle(real->x) : double(x); }
  double approx_y() const { return real ? middle(real->y) : double(y); }
  friend Position operator+(const Position& p, const Position& q);
  void mirror();  // through the origin

 private:
  static double middle(const exact::Real& r) { return (r.interval().lo + r.interval().hi) / 2; }
};

/// A direction of travel: a primitive integer vector, or a pair of exact reals of length 1.
struct Direction {
  std::int64_t x = 0, y = 0;
  std::shared_ptr<const exact::RealPoint> real;  // null: the integer vector (x, y)

  bool grid() const { return !real; }
  static Direction of(const exact::Real& x, const exact::Real& y);
  Direction operator-() const;
  void mirror();
  /// The unit normal to the right of the direction.
  Position right_normal() const;
};

/// Sign of the cross product: +1 when q is to the left of p.
int cross_sign(const Direction& p, const Direction& q);
int dot_sign(const Direction& p, const Direction& q);
/// Angle in [180, 360) from the positive x axis.
bool is_lower(const Direction& d);
/// Order by angle in [0, 360) from the positive x axis.
int compare_angle(const Direction& p, const Direction& q);

/// A directed segment or arc (x-monotone) of a boundary path.
struct Step {
  Position from, to;
  Direction start, end;  // tangents; equal for a segment
  bool arc = false, ccw = true;
  Position center;  // of an arc
  exact::Real radius;
  std::int8_t half = 0;  // of an arc: +1 upper, -1 lower

  Step reversed() const;
  void mirror();  // through the origin
};

/// Sign of curvature(p) - curvature(q), positive when turning left.
int compare_curvature(const Step& p, const Step& q);

/// A closed path. `lonely`: a single point instead of steps.
struct Path {
  std::vector<Step> steps;
  std::optional<Position> lonely;
};

struct Extent {
  double x0, y0, x1, y1;  // a little larger than the truth
};

/// One connected piece of a set with its boundary paths.
struct Part {
  std::vector<Path> paths;
  bool flat = false;  // a curve or point walked on both sides, without interior
  bool unbounded = false;
  int euler = 1;              // Euler characteristic of the part: 1 minus its bridgeless holes
  Extent filled{};            // of the part with its holes filled (bounded parts)
  std::vector<Extent> holes;  // of the holes that are not bridged
};

/// An open face as a part. Of its boundary, isolated vertices for which `wanted` holds are left out.
Part face_part(const CellComplex& complex, const Face& face, const std::function<bool(Mark)>& wanted);

/// The open faces for which `wanted` holds, each as a part.
std::vector<Part> face_parts(const CellComplex& complex, const std::function<bool(Mark)>& wanted);

/// For a closed set: the edges and vertices for which `wanted` holds and which touch no wanted face: flat parts.
std::vector<Part> flat_parts(const CellComplex& complex, const std::function<bool(Mark)>& wanted);

/// The same part with its holes joined to their surroundings by horizontal bridges, so that it is simply connected. The
/// bridge is walked on both sides; as an open set it lacks the bridge, which no Minkowski sum with an open set notices.
/// For an unbounded part one bridge leads left for at least `reach`.
Part bridged(Part part, const exact::Real& reach);

Part mirrored(Part part);

}  // namespace findspace::plane
