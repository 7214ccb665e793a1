// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Whether the interiors of two solids meet, with B moved to a rational position: p in U = iA (+) i(-B)?
// It decides the cells that a winding number of 0 leaves open, coincident sheets (slits, exact fits) and positions in
// walls.
//
// The interiors meet iff one of these holds (B stands for B + p):
//   1  a triangle of A and one of B cross, interior through interior;
//   2  an edge of one lies in a triangle of the other, inside, and its dihedral angle reaches behind that triangle;
//   3  two edges overlap on one line and their dihedral angles overlap;
//   4  two triangles overlap in one plane with equal outward normals;
//   5  none of these, and some triangle of one lies inside the other: then all of its piece of surface does, for a
//   piece can
//      pass from inside to outside only over points of kinds 1 to 3. So one point a piece is enough.
// Guarantee: exact in every degenerate position. Cost: the pairs of triangles whose boxes meet, some ten nanoseconds
// each. Source: crossing test as in Guigue and Devillers 2003, "Fast and robust triangle-triangle overlap test".
// Keywords: collision detection, intersection test, contact.
#pragma once

#include "space/convolution/ray_boxes.h"

namespace findspace::space {

/// (x, y, z + by): a position on a ray; 0 <= by < 1.
struct RayPlace {
  Point whole;
  exact::Fraction by;
};

/// x, y and the fraction.
RayPlace ray_place(std::int64_t x, std::int64_t y, const exact::Fraction& z);

class RayOverlap {
 public:
  /// Keeps references. `a_inside_out`: A is the complement of the solid that its surface bounds.
  RayOverlap(const RayBody& a, const RayBody& b, bool a_inside_out)
      : a_(a), b_(b), a_tree_(a), b_tree_(b), a_inside_out_(a_inside_out) {}

  /// The pairs of triangles that showed the last overlaps: likely to show the next one nearby, so they are tried first.
  struct Recent {
    std::vector<std::array<int, 2>> pairs;
  };
  bool interiors_meet(const RayPlace& p, Recent& recent) const;
  bool interiors_meet(const RayPlace& p) const {
    Recent none;
    return interiors_meet(p, none);
  }

 private:
  bool pieces_inside(const RayPlace& p) const;

  const RayBody& a_;
  const RayBody& b_;
  BoxTree a_tree_, b_tree_;
  bool a_inside_out_;
};

/// Whether the triangles f of A and g of B + p show an overlap (1 to 4 above).
bool faces_overlap(const RayBody& a, int f, const RayBody& b, int g, const RayPlace& p);
/// Whether the triangles f and g of a body overlap in one plane, the body on both its sides.
bool faces_back_to_back(const RayBody& body, int f, int g);

}  // namespace findspace::space
