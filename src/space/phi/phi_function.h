// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The Phi-function of two convex polytopes A (fixed) and B (translated by u), in both forms:
//   max form      max_i f_i(u) / |n_i| over the facets f_i = n_i . u + d_i of A - B; piecewise linear and convex;
//   normalised    the same where it is <= 0, the Euclidean distance of A and B + u where it is > 0.
// Both are negative where the interiors meet, 0 in contact, positive apart; inside, minus the value is the exact
// penetration depth (the least translation that ends the overlap). Positions are in grid steps, as doubles of
// at most 2^500, which are taken as the exact dyadic numbers they are. Guarantee: sign() and active() are exact. Values
// carry the roundings of a few double operations: the absolute error of the max form is at most `error_bound(u)`; the
// normalised form outside is within 2^-40 of the size of the bodies. Cost: one pass over the facets, eight at a time;
// for many queries against one pair see depth_grid.h. Source: phi.md 2. Keywords: penetration depth, signed distance,
// GJK, EPA, separating axis.
#pragma once

#include <span>
#include <vector>

#include "space/phi/contact_surface.h"
#include "space/polytope/vector.h"

namespace findspace::space {

enum class State { kOverlap, kContact, kApart };

/// The planes of a convex body with unit normals, eight to a block, in doubles; the last block is filled up with planes
/// of value -infinity.
struct PlaneBlock {
  double x[8], y[8], z[8], d[8];
};

/// The greatest plane value at u, and which plane takes it (the first one of equals).
struct Highest {
  double value = 0;
  int plane = 0;
};
Highest highest_plane(std::span<const PlaneBlock> blocks, const Vector& u);

class PhiFunction {
 public:
  PhiFunction(const Polytope& a, const Polytope& b);
  /// Of a surface made before.
  explicit PhiFunction(ContactSurface surface);

  const ContactSurface& surface() const { return surface_; }
  const Vector& unit_normal(int f) const { return unit_normals_[f]; }
  double plane_value(int f, const Vector& u) const {
    const Vector& n = unit_normals_[f];
    return ((n.x * u.x + n.y * u.y) + n.z * u.z) + offsets_[f];
  }
  std::span<const PlaneBlock> blocks() const { return blocks_; }

  /// The two forms. Other positions are refused with Error(kBadValue).
  double max_form(const Vector& u) const;
  double normalised(const Vector& u) const;

  /// -1 overlap, 0 contact, +1 apart. Exact.
  int sign(const Vector& u) const;
  State state(const Vector& u) const;

  /// The facets whose planes are highest at u, in order. Exact, ties included.
  std::vector<int> active(const Vector& u) const;

  /// A (sub)gradient of each form; of length 1. Of the max form: the normal of the first active facet.
  Vector gradient(const Vector& u) const;
  Vector normalised_gradient(const Vector& u) const;

  /// How deep B + u lies in A (0 unless they overlap), and the shortest translation that brings them into contact from
  /// an overlap: the direction is the outward normal of the active facet.
  double depth(const Vector& u) const;
  Vector penetration_depth(const Vector& u) const;

  /// The max form at many positions, and the facet that is highest at each when `facets` is not empty.
  void evaluate(std::span<const Vector> at, std::span<double> values, std::span<int> facets = {}) const;

  double error_bound(const Vector& u) const;
  /// The vertices of the surface as doubles, exactly.
  const Vector& vertex(int v) const { return vertices_[v]; }
  /// The point of A - B nearest to a u that is outside.
  Vector nearest(const Vector& u) const;

 private:
  ContactSurface surface_;
  std::vector<Vector> unit_normals_, vertices_;
  std::vector<double> offsets_;
  std::vector<PlaneBlock> blocks_;
  double reach_ = 0;  // greatest |offset| of a unit plane
};

/// The nearest point to u on the convex polygon with the given corners (counter-clockwise about the unit normal n).
Vector nearest_on_polygon(const Vector& u, const Vector& n, std::span<const Vector> corners);

}  // namespace findspace::space
