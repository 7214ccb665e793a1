// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/build/ring_sketch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "plane/contour/contour.h"

namespace findspace::plane {
namespace {

/// The angle of an arc as seen from its centre, positive counter-clockwise.
double turn_of(double ax, double ay, double bx, double by, bool ccw) {
  const double angle = std::atan2(ax * by - ay * bx, ax * bx + ay * by);
  if (ccw && angle < 0) return angle + 2 * std::numbers::pi;
  if (!ccw && angle > 0) return angle - 2 * std::numbers::pi;
  return angle;
}

}  // namespace

RingSketch::RingSketch(const Contour& ring) {
  const double most = std::numeric_limits<double>::infinity();
  box_ = {most, most, -most, -most};
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const GridPoint a = ring[k].start, b = end_of(ring, k);
    Side s{double(a.x), double(a.y), double(b.x), double(b.y)};
    if (ring[k].arc) {
      s.cx = ring[k].arc->cx.to_double();
      s.cy = ring[k].arc->cy.to_double();
      s.r = ring[k].arc->r.to_double();
      s.turn = turn_of(s.x - s.cx, s.y - s.cy, s.u - s.cx, s.v - s.cy, ring[k].ccw);
      s.rise = sagitta(ring[k], b);
    }
    for (const auto& [x, y] : {std::pair{s.x, s.y}, {s.u, s.v}})
      box_ = joined(box_, {x - s.rise, y - s.rise, x + s.rise, y + s.rise});
    sides_.push_back(s);
  }
}

double RingSketch::area() const {
  const double ox = sides_[0].x, oy = sides_[0].y;
  double sum = 0;
  for (const Side& s : sides_)
    sum += ((s.x - ox) * (s.v - oy) - (s.y - oy) * (s.u - ox)) / 2 + s.r * s.r * (s.turn - std::sin(s.turn)) / 2;
  return sum;
}

double RingSketch::length() const {
  double sum = 0;
  for (const Side& s : sides_) sum += s.r == 0 ? std::hypot(s.u - s.x, s.v - s.y) : s.r * std::abs(s.turn);
  return sum;
}

bool RingSketch::goes_round(double x, double y) const {
  bool inside = false;
  for (const Side& s : sides_) {
    const double side = (s.u - s.x) * (y - s.y) - (s.v - s.y) * (x - s.x);
    if ((s.y > y) != (s.v > y) && (side > 0) == (s.v > s.y)) inside = !inside;
    if (s.r != 0 && (side < 0) == (s.turn > 0) && std::hypot(x - s.cx, y - s.cy) < s.r) inside = !inside;
  }
  return inside;
}

double RingSketch::apart(double x, double y) const {
  double least = std::numeric_limits<double>::infinity();
  for (const Side& s : sides_) {
    const double dx = s.u - s.x, dy = s.v - s.y, square = dx * dx + dy * dy;
    const double share = square > 0 ? std::clamp(((x - s.x) * dx + (y - s.y) * dy) / square, 0.0, 1.0) : 0;
    double away = std::hypot(x - s.x - share * dx, y - s.y - share * dy);
    if (s.r != 0) away = std::max(away - s.rise, std::abs(std::hypot(x - s.cx, y - s.cy) - s.r));
    least = std::min(least, away);
  }
  return least;
}

}  // namespace findspace::plane
