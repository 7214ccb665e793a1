// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The view in which pictures of space are drawn: orthogonal, x to the lower left, y to the right, z up, as in a text
// book. The three directions are perpendicular unit vectors. A picture fits what it shows into a square, and three
// edges of the box about it carry ticks with their numbers, so that lengths can be read off along each axis.
// Keywords: axonometric view, axis ticks.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "plane/query/summary.h"
#include "space/box/box_summary.h"

namespace findspace::io {

inline constexpr double kViewSize = 720;  // of the drawn part, in pixels
inline constexpr std::array<double, 3> kRight{-0.5, 0.8660254037844386, 0};
inline constexpr std::array<double, 3> kUp{-0.3535533905932738, -0.2041241452319315, 0.9128709291752769};
inline constexpr std::array<double, 3> kTowards{0.7905694150420949, 0.4564354645876384, 0.408248290463863};

inline double dot(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// From the scene's unit to pixels.
class SpaceView {
 public:
  /// Room about the drawn part for the numbers of the axes, in pixels.
  static constexpr double kLeft = 64, kAround = 48;

  /// To be seen: what lies within a radius of a place.
  void include(const space::Place3& p, double radius = 0);
  /// After all is included: the drawn part, with its axes, begins at `top`.
  void fit(double top);

  plane::Place at(const space::Place3& p) const;
  double scale() const { return scale_; }
  double top() const { return top_; }
  double width() const { return kLeft + (high_[0] - low_[0]) * scale_ + kAround; }
  /// Of all that is drawn, numbers included.
  double bottom() const { return top_ + (high_[1] - low_[1]) * scale_ + kAround; }
  /// The box about all that is to be seen.
  const space::Place3& low() const { return box_[0]; }
  const space::Place3& high() const { return box_[1]; }

 private:
  std::array<space::Place3, 2> box_{};
  std::array<double, 2> low_{}, high_{};  // on the page, y downwards, in the scene's unit
  double scale_ = 1, top_ = 0;
  bool any_ = false;
};

/// What is drawn, and the boxes of its texts, from which other texts keep away.
struct SpaceAxes {
  std::string svg;
  std::vector<plane::Bounds> texts;
};
SpaceAxes space_axes(const SpaceView& view, std::string_view unit);

}  // namespace findspace::io
