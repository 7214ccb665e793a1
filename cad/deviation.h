// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// How far a curve can be from its chord and a surface from a triangle with corners on it, by bounds of derivatives.
// For f twice differentiable (or once, with pieces), f(x) - sum l_i f(v_i) = -1/2 sum l_i D2f(y_i)(v_i - x, v_i - x)
// for x = sum l_i v_i. With |D2f(d, d)| <= q(d), a diagonal form, the difference is at most half the largest variance
// of the corners in the measure of q: the squared circumradius, or a quarter of the longest squared edge where the
// triangle is obtuse. Bounds of derivatives are closed forms for planes, cylinders, cones, spheres, tori, lines and
// conics, and come from control nets for Bezier and B-spline ones (the convex hull property), rational ones too.
// Guarantee: proved, in doubles that are raised by a hundredth, which is far more than their roundings.
// Source: Filip, Magedson and Markot, Surface algorithms using bounds on derivatives, 1986. Keywords: chordal error,
// tessellation bound.
#pragma once

#include <Geom2d_Curve.hxx>
#include <Geom_Surface.hxx>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace findspace::cad {

/// Part of the plane of parameters.
struct Range {
  double u0, u1, v0, v1;
  void hold(double u, double v);
};

/// Bounds of the lengths of derivatives.
struct Derivatives {
  double u = 0, v = 0, uu = 0, uv = 0, vv = 0;
  void raise(const Derivatives& other);
};

class SurfaceBounds {
 public:
  /// Null where the kind of surface has no bound here, or a crease; kind() says which it is.
  static std::unique_ptr<const SurfaceBounds> of(const Handle(Geom_Surface) & surface);
  virtual ~SurfaceBounds() = default;
  virtual Derivatives over(const Range& range) const = 0;
};

/// In words: "plane", "cylinder", "B-spline surface", ...
std::string kind_of(const Handle(Geom_Surface) & surface);

/// The difference of the surface over the triangle of parameters and the linear map of the corners.
double triangle_bound(const Derivatives& d, const std::array<std::array<double, 2>, 3>& corners);

/// The side (from corner k to the next) that is longest in the measure of that bound.
int longest_side(const Derivatives& d, const std::array<std::array<double, 2>, 3>& corners);

/// How far, in u and in v, a curve between two parameters is from the chord of its ends; nothing where its kind has no
/// bound here.
std::optional<std::array<double, 2>> chord_bound(const Handle(Geom2d_Curve) & curve, double from, double to);

}  // namespace findspace::cad
