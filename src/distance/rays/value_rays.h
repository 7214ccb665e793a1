// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The sign map on rays of a function of the position that no step changes by more than its length, by its values: a
// value v at a place says the sign as far as |v| on either side of it; what v is measured from may say the sign in a
// ball, whose chord ends at the boundary or nearly so. What is left of a line is halved. So distances
// at a level are decided from where round boundaries are to be measured from. Guarantee: the sign is - or + only where
// that is certain; 0 where the function is within kCertain of the sizes of 0 (more where a line runs along the
// boundary: kCoarse). Cost: some forty values for each end, more where the line is nearly along the boundary; refused
// where the function is 0 on long stretches. Keywords: sphere tracing, interval bisection, Lipschitz bound.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "distance/rays/line_signs.h"
#include "distance/solid/solid_pair.h"
#include "exact/margins/space_distance.h"
#include "space/rays/ray_map.h"

namespace findspace::distance {

/// Whether the sign map of gamma1, eta1, eta2 or mu at the level is found by values. No `outside` of B.
bool by_values(Which which, const exact::Real& level, const space::Body& b, const space::Body& a);
/// That map; bounded bodies of one scale, the level in their steps.
std::unique_ptr<space::RaySource> by_values_map(Which which, const exact::Real& level, const space::Body& b,
                                                const space::Body& a, const space::RayGrid& grid);

/// The sign at all positions nearer to the centre than the radius, or at all that are farther.
struct SignBall {
  space::Vector center;
  double radius = 0;
  int sign = 1;
  bool beyond = false;
};

/// What the function lies between at a position, and what that says of others.
struct Between {
  double low = 0, high = 0;
  std::optional<SignBall> ball{};
};
/// Less the level, of a value and what that may be off: infinite where it may be any from there on.
inline Between about(double value, double error, double level = 0) {
  if (!(error < exact::kInfinity)) return {value - level, error};
  return {value - error - level, value + error - level};
}
/// Nothing where the function is undefined: so everywhere, and its sign is +. Refused where a search does not tell.
using TriedBetween = exact::Tried<std::optional<Between>>;
using RayRule = std::function<TriedBetween(const space::RealVector&)>;

class ValueRays : public space::RaySource {
 public:
  static constexpr double kCertain = margin::kRayCertain, kCoarse = margin::kRayCoarse;

  /// Positions in steps of the scale. Farther than `size` from the middle the function is more than 0.
  ValueRays(RayRule rule, const space::Vector& middle, double size, std::int64_t scale, const space::RayGrid& grid)
      : rule_(std::move(rule)),
        grid_(grid),
        unit_(static_cast<double>(scale) / static_cast<double>(grid.parts)),
        size_(size),
        middle_(middle) {}

  const space::RayGrid& grid() const override { return grid_; }
  exact::Tried<space::RayRow> try_row(int j) const override;
  bool searched() const override { return true; }

 private:
  struct Walk {
    PositionLine line;
    std::vector<SignStretch> known;
    int values = 0;
    std::optional<exact::Refusal> refused{};
  };

  /// Ends at once where the walk is refused.
  void look(Walk& walk, double from, double to) const;
  /// Of the line where a value's ball says the sign, by growing place.
  std::vector<SignStretch> chords(const Walk& walk, const SignBall& ball) const;

  RayRule rule_;
  space::RayGrid grid_;
  double unit_, size_;  // unit: grid parts to steps
  space::Vector middle_;
};

}  // namespace findspace::distance
