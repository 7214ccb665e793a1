// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The intersection M of finitely many closed balls, a convex set, and the points of it nearest to and farthest from p:
// where a polytope fits into a ball is such a set. The nearest point is p, or lies on one, two or three of the spheres;
// the farthest is opposite p on a sphere, on a circle of two, or a point of three. Guarantee: exact (nested square
// roots); which of several points that agree to 2^-40 is the farthest may be exchanged. Cost: nearest: a few sets of
// four balls; farthest: O(n^4), for up to kMostBalls. Keywords: ball intersection, lens, alpha shape.
#pragma once

#include <optional>
#include <vector>

#include "space/body/name_place.h"

namespace findspace::space {

class BallMeet {
 public:
  static constexpr std::size_t kMostBalls = 40;

  explicit BallMeet(std::vector<Ball> balls) : balls_(std::move(balls)) {}

  bool holds(const RealVector& p) const;
  /// Nothing if M is empty.
  std::optional<RealVector> nearest(const RealVector& p) const;
  /// Whether farthest() may be asked.
  bool few() const { return balls_.size() <= kMostBalls; }
  /// Of at most kMostBalls balls.
  std::optional<RealVector> farthest(const RealVector& p) const;

 private:
  std::optional<RealVector> nearest_of(const std::vector<int>& few, const RealVector& p, std::vector<int>& basis) const;
  bool holds(int ball, const RealVector& p) const;

  std::vector<Ball> balls_;
};

/// The point nearest to p that none of at most BallMeet::kMostBalls balls holds in its interior; nothing where that is
/// not found.
std::optional<RealVector> nearest_outside(const std::vector<Ball>& balls, const RealVector& p);

}  // namespace findspace::space
