// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Affine maps of drawings, with exact coefficients (only the sine and cosine of an angle that is not a multiple of 90
// degrees come from doubles). `Placed` passes the commands of a path on; arcs that a map makes elliptical become
// curves.
#pragma once

#include <optional>

#include "io/text/read_outline.h"
#include "io/text/svg_path.h"

namespace findspace::io {

/// (x, y) -> (a x + c y + e, b x + d y + f).
struct Affine {
  exact::Real a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;
  /// Factor of lengths; nothing where the map is not a similarity.
  std::optional<exact::Real> scale = exact::Real(1);
  bool mirrors = false;

  static Affine translation(const exact::Real& x, const exact::Real& y);
  static Affine scaling(const exact::Real& x, const exact::Real& y);
  static Affine rotation(const exact::Real& degrees);
  static Affine matrix(exact::Real a, exact::Real b, exact::Real c, exact::Real d, exact::Real e, exact::Real f);

  bool is_translation() const {
    return b.sign() == 0 && c.sign() == 0 && compare(a, exact::Real(1)) == 0 && compare(d, exact::Real(1)) == 0;
  }
  exact::Real x_of(const exact::Real& x, const exact::Real& y) const { return a * x + c * y + e; }
  exact::Real y_of(const exact::Real& x, const exact::Real& y) const { return b * x + d * y + f; }
  plane::CurvePoint of(const plane::CurvePoint& p) const { return {x_of(p.x, p.y), y_of(p.x, p.y)}; }
  /// The image of an ellipse.
  EllipseArc of(const EllipseArc& arc) const;
};

/// First `inner`, then `outer`.
Affine operator*(const Affine& outer, const Affine& inner);

/// Cosine and sine; exact for multiples of 90 degrees.
struct Direction {
  exact::Real cosine, sine;
};
Direction direction(const exact::Real& degrees);

/// Commands through a map into an outline.
class Placed : public PathSink {
 public:
  Placed(const Affine& map, Outline& outline) : map_(map), outline_(outline) {}
  void move_to(const exact::Real& x, const exact::Real& y) override;
  void line_to(const exact::Real& x, const exact::Real& y) override;
  void arc_to(const exact::Real& radius, bool large, bool sweep, const exact::Real& x, const exact::Real& y) override;
  void curve_to(std::span<const plane::CurvePoint> points) override { curve_to(points, {}); }
  void curve_to(std::span<const plane::CurvePoint> points, std::span<const exact::Real> weights);
  void ellipse_to(const EllipseArc& arc, const exact::Real& x, const exact::Real& y) override;
  void close() override;
  void finish() { outline_.finish(); }
  void bulge_to(const exact::Real& bulge, const exact::Real& x, const exact::Real& y);
  /// A B-spline that begins where the chain is, or a chain of its own.
  void spline_to(plane::Spline spline);
  void spline(plane::Spline spline, bool closed);
  void circle(const exact::Real& x, const exact::Real& y, const exact::Real& radius);
  void ellipse(const EllipseArc& whole);
  void point(const exact::Real& x, const exact::Real& y) { outline_.point(map_.x_of(x, y), map_.y_of(x, y)); }

 private:
  void reach(const exact::Real& x, const exact::Real& y) { at_ = {x, y}; }

  Affine map_;
  Outline& outline_;
  plane::CurvePoint at_, start_;  // before the map
};

}  // namespace findspace::io
