// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What every distance f(p) of a moving shape B at p and a fixed shape A offers (a PositionFunction): its sign map at a
// level and its value at a position. A T-distance (distances.md 3) is one that is 1-Lipschitz in p and tends to
// infinity with |p|; it offers besides the elementary distances ("level curves") that can decide it near a position,
// from which exact extrema are made. Distances along a direction (7.1) are no T-distances, they jump. Lengths are in
// grid steps. Guarantee: sign maps and values are exact unless the family says otherwise. Keywords: T-distance, level
// set, sublevel set.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "distance/answer/answer.h"
#include "distance/planar_features/level_curve.h"
#include "distance/planar_features/smooth_form.h"
#include "plane/complex/broad_phase.h"
#include "plane/complex/cell_complex.h"

namespace findspace::distance {

class PositionFunction {
 public:
  virtual ~PositionFunction() = default;

  /// False where the distance is +infinity everywhere.
  virtual bool defined() const = 0;
  /// The sign of f - level at every position; + everywhere if undefined.
  virtual plane::SignMap sign_map(const exact::Real& level) const = 0;
  /// f at a position; nothing if undefined.
  virtual std::optional<PlanarAnswer> value(const exact::RealPoint& p) const = 0;
};

using PositionFunctionPointer = std::shared_ptr<const PositionFunction>;

class TDistance : public PositionFunction {
 public:
  /// A position where a search may begin.
  virtual exact::RealPoint seed() const = 0;
  /// What a search over all positions has to expect: of how many edges sign maps are made, and f(p) >= |p| - reach,
  /// where the family grows so.
  struct Size {
    std::size_t edges;
    std::optional<double> reach;
  };
  /// Nothing where the family has no near().
  virtual std::optional<Size> size() const { return std::nullopt; }
  /// A function made of the few features that count in the window: for levels from low to high, the sign of f - level
  /// at its positions is that of the other one. Null where there is none, or too much counts.
  virtual std::shared_ptr<const TDistance> near(const plane::PieceBox& /*window*/, double /*low*/,
                                                double /*high*/) const {
    return nullptr;
  }
  /// Smooth functions of which f is one at every position no farther than `radius` from p, where the family knows them.
  virtual std::optional<std::vector<SmoothForm>> forms(const exact::RealPoint& /*p*/, double /*radius*/) const {
    return std::nullopt;
  }
  /// The level curves with a gap of at most `tolerance` at p.
  virtual std::vector<NearLevelCurve> level_curves(const exact::RealPoint& p, double tolerance) const = 0;
  /// The least value and the only position that has it, where the family can tell by itself.
  struct Lowest {
    exact::Real level;
    exact::RealPoint at;
  };
  virtual std::optional<Lowest> lowest() const { return std::nullopt; }
  /// The same function in other coordinates, f(p) = in(p + by), where numbers are more exact: searches are made there.
  struct Elsewhere {
    const TDistance& in;
    exact::RealPoint by;
  };
  virtual std::optional<Elsewhere> elsewhere() const { return std::nullopt; }
  /// Levels at which f may have a minimum or a plateau that no level curves explain.
  virtual std::vector<exact::Real> special_levels() const { return {}; }
};

using TDistancePointer = std::shared_ptr<const TDistance>;

}  // namespace findspace::distance
