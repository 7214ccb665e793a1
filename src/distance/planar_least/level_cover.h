// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Where a T-distance f can be about as good as its best value over a closed set S, and between which numbers that value
// lies: squares of positions, halved where f may be good. f is 1-Lipschitz, so its value in the middle of a square
// bounds it all over the square from the one side, and from the other, by the distance of S. Guarantee: certain, to
// margin::kKnownNumber of the coordinates, which is added: every position of S whose value is at most `slack` worse
// than the best lies in a square. Cost: a value of f for each square. Keywords: branch and bound, Lipschitz
// optimisation, quadtree.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "distance/planar_features/feature_tree.h"
#include "distance/planar_features/t_distance.h"
#include "exact/margins/rounding.h"

namespace findspace::distance {

class LevelCover {
 public:
  /// Of f and a closed set that is not empty, whole or bounded; both are kept as references. `rotation`: +1 where less
  /// is better, -1 where more is. `start`: a position of the set. Nothing where it is not known how far to look, or a
  /// value is not finite.
  static std::optional<LevelCover> of(const TDistance& f, const plane::Region& closed, int rotation,
                                      const exact::RealPoint& start);

  /// Whether a position of the set is certainly better than the level, or none is as good; nothing where the bounds do
  /// not tell.
  std::optional<bool> is_passed(const exact::Real& level) const;
  /// Halves the squares that leave that open, a few times.
  void decide(const exact::Real& level);
  /// Halves squares until they are this small, and keeps those that may be at most `slack` worse than the best. False
  /// where they would be too many.
  bool narrow(double slack, double half);

  /// Numbers, times the rotation, that the best value lies between.
  double low() const;
  double high() const { return high_; }
  double most() const { return high_ + slack_; }
  /// Squares that hold every position of S that is no worse than `most()`.
  std::vector<plane::PieceBox> boxes() const;

 private:
  struct Square {
    double x, y, half;
    double low = 0, high = 0;  // of f over it, and at some position of S
  };

  LevelCover(const TDistance& f, const plane::Region& closed, int rotation);
  bool look(Square& s) const;
  bool split(double most, double half);

  const TDistance* f_;
  int rotation_;
  bool whole_;
  std::shared_ptr<const FeatureTree> set_;  // of S, where it is not the whole plane
  std::vector<Square> squares_;
  double high_ = exact::kInfinity, slack_ = exact::kInfinity;
  double scale_ = 0;  // of coordinates, which a value may be off by rounding of
  std::size_t looks_ = 0, most_looks_ = 0;
};

}  // namespace findspace::distance
