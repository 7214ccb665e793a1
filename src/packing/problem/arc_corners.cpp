// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/problem/arc_corners.h"

#include <cmath>
#include <numbers>

namespace findspace::packing {
namespace {

constexpr int kSidesOfCircle = 96;
constexpr double kSide = 2 * std::numbers::pi / kSidesOfCircle;
constexpr double kNearlyStraight = 0x1p44;  // no sign: an arc of the grid with a larger radius has no corner within

/// Where the sides of an arc end: its ends, and multiples of the angle of a side between them.
std::vector<double> angles_of(const Arc& arc) {
  const double begin = std::atan2(arc.from.y - arc.centre.y, arc.from.x - arc.centre.x);
  double sweep = std::atan2(arc.to.y - arc.centre.y, arc.to.x - arc.centre.x) - begin;
  if (arc.ccw && sweep < 0) sweep += 2 * std::numbers::pi;
  if (!arc.ccw && sweep > 0) sweep -= 2 * std::numbers::pi;
  std::vector<double> result{begin};
  const double side = arc.ccw ? kSide : -kSide, end = begin + sweep;
  // A side shorter than a hundredth of the others would be no side but rounding.
  const double first = side * std::ceil(begin / side + 0.01);
  for (int k = 0; arc.radius < kNearlyStraight && (end - (first + k * side)) / side > 0.01; ++k)
    result.push_back(first + k * side);
  result.push_back(end);
  return result;
}

}  // namespace

std::vector<Vec> corners_of(const Arc& arc, bool tangents) {
  const std::vector<double> angles = angles_of(arc);
  std::vector<Vec> result;
  Vec p = arc.from;
  for (std::size_t k = 1; k < angles.size(); ++k) {
    const bool last = k + 1 == angles.size();
    const Vec q = last ? arc.to : arc.centre + arc.radius * Vec{std::cos(angles[k]), std::sin(angles[k])};
    const Vec chord = q - p;
    // The tangents at both ends of a side meet on the right of a chord that turns to the left, so far from its middle.
    if (tangents)
      result.push_back(0.5 * (p + q) + 0.5 * std::tan((angles[k] - angles[k - 1]) / 2) * Vec{chord.y, -chord.x});
    if (!tangents && !last) result.push_back(q);
    p = q;
  }
  return result;
}

}  // namespace findspace::packing
