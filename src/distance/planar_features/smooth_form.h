// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A distance of shapes is, near a position p, one of a few smooth functions: the distance to a point, a line or a
// circle. A form is one of these as seen from p: its value there, its gradient, and how far it departs from its tangent
// plane within a radius,
//     value + g.(q - p) + below <= form(q) <= value + g.(q - p) + above   for all q with |q - p| <= radius.
// Guarantee: bounds hold to the rounding of doubles (margin::kMaxMinNoise of the coordinates); `curve` is exact.
// Keywords: Taylor bound, subgradient, elementary distance.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "distance/planar_features/boundary_features.h"

namespace findspace::distance {

struct SmoothForm {
  double value = 0, gx = 0, gy = 0;
  double below = 0, above = 0;
  std::function<LevelCurve()> curve{};  // where the form equals a level
};

/// scale * (|q - c| - radius) for scale +1 or -1, c being the circle's centre.
SmoothForm ring_form(double x, double y, double cx, double cy, double r, int scale, double radius);
/// All forms that the distance to the closed features of a set can be near p, where `sign` = +1 (outside) counts the
/// distance to marks <= 0 and -1 minus that to marks >= 0.
class BoundaryForms {
 public:
  BoundaryForms(const plane::SignMap& base, int sign);
  ~BoundaryForms();
  BoundaryForms(const BoundaryForms&) = delete;
  BoundaryForms& operator=(const BoundaryForms&) = delete;
  /// The distance to the nearest feature, without sign; infinite where there are none.
  double nearest(double x, double y) const;
  void add_forms(double x, double y, double radius, std::vector<SmoothForm>& out) const;

 private:
  void add_edge(const BoundaryFeature& s, double x, double y, double radius, std::vector<SmoothForm>& out) const;
  struct Features;

  const plane::SignMap& base_;
  int sign_;
  std::unique_ptr<const Features> all_;
};

}  // namespace findspace::distance
