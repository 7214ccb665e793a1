// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The signed convolution of the boundaries of A and C = -B: a closed surface of triangles (face + vertex) and
// parallelograms (edge + edge), each with an outward normal (the direction of touching) and a weight. Its winding
// number at p is the Euler characteristic of the intersection of A and B + p; with A turned inside out, of B + p less
// A.
//
//   face f of A + vertex w of C   weight i(w, n_f): the local index of the solid at w, the number of times the circuit
//   of
//                                 normals about w winds about n_f; 1 - chi(link of w in C above the plane of height)
//   vertex of A + face of C       likewise
//   edge e of A + edge e' of C    where the arcs between the normals of their faces cross; weight + if both are convex
//   or both
//                                 reflex, - otherwise
//
// Ties (a normal of A perpendicular to an edge of C: always, on grid data) are decided as if the normals of A were
// mapped by I + E, E a matrix of infinitesimals of descending order: n . e + sum E_ij n_i e_j. So the sign of a tie is
// that of the first component of n times that of the first component of e, and every choice belongs to one true pair of
// bodies: the surface is closed, and its geometry is that of the unmoved bodies. Frontier points of the set of overlaps
// lie on it. Guarantee: exact. Cost: O((n + m) log) and the pairs whose cones of normals meet. Source: Guibas, Ramshaw,
// Stolfi 1983; Basch, Guibas, Ramkumar, Ramshaw 1996, "Polyhedral tracings and their convolution"; the Euler reading:
// Schapira 1991. Keywords: kinetic framework, Minkowski sum, normal cycle.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "space/convolution/ray_body.h"

namespace findspace::space {

struct RayFacet {
  std::array<Point, 4> corner;  // a convex circuit, counter-clockwise about the outward normal; three or four
  std::int8_t corners = 3;
  bool outer = false;  // as far as its two features tell, positions inside it may touch from outside
  std::int32_t weight = 1;

  Point along() const { return corner[1] - corner[0]; }
  Point across() const { return corner[corners - 1] - corner[0]; }
  Wide3 normal() const { return exact::cross(along(), across()); }
};

std::vector<RayFacet> convolution(const RayBody& a, const RayBody& c);

/// i(w, n): the local index of the solid at a vertex in direction n, which may be any vector but 0. `tie` (+1 or -1) is
/// the sense in which ties are decided.
int local_index(const RayBody& body, const RayVertex& vertex, const Wide3& n, const Approx3& n_approx, int tie);

}  // namespace findspace::space
