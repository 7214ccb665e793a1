// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The sign map on rays of how far a position is from the nearest place of a set, or a moved body from it, less a level.
// The least of it on a whole stretch is one search, which says that all of the stretch is beyond the level, or names a
// place; that place alone is near enough along a chord of the line. At its ends other places are nearer; each is nearer
// along more of the line, and the ends come to where no place is near enough as tangents do (Newton), the last
// stretches being searched to show that. Guarantee: as value_rays.h: the sign is - or + only where that is certain; 0
// where the function is within kCertain of the sizes of 0 (kCoarse on lines with many ends), and, where work is
// strictly limited, on what is left of a line when it ends; refused where searches do not tell. Cost: some eight
// searches for each end. Keywords: sphere tracing, Newton's method, continuous collision detection.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "distance/rays/line_signs.h"
#include "distance/search/boundary_search.h"
#include "space/rays/ray_map.h"

namespace findspace::distance {

/// A line of positions in numbers.
struct NearLine {
  space::Vector start, unit;
};

/// A convex function along a line, with its slope; no step changes it by more than its length.
struct AlongPlace {
  double value = 0, slope = 0;
};

class NearRule {
 public:
  virtual ~NearRule() = default;
  /// The least of the function on a stretch is between `low` and `high`; where that is finite, `beyond` is nowhere on
  /// the line less than the function, and at most `high` somewhere on the stretch.
  struct Least {
    double low, high;
    std::function<AlongPlace(double)> beyond;
    bool quick = false;  // without a search
  };
  /// The level is 0: that of `until` is ignored.
  virtual exact::Tried<Least> least(const NearLine& line, double from, double to, const Until& until) const = 0;
  /// Stretches on which the function is known to be less than 0, in order.
  using Known = std::vector<std::pair<double, double>>;
  virtual exact::Tried<Known> known(const NearLine& line) const;
};

/// The part of a line that is within `size` of the middle, and more.
struct NearRange {
  space::Vector middle;
  double size = 0;
};
exact::Tried<std::vector<SignStretch>> near_stretches(const NearRule& rule, const NearLine& line,
                                                      const NearRange& range);

class NearRays : public space::RaySource {
 public:
  /// Positions in steps of the scale. Out of the range the function has the sign `outer`.
  NearRays(std::unique_ptr<const NearRule> rule, const NearRange& range, int outer, std::int64_t scale,
           const space::RayGrid& grid);

  const space::RayGrid& grid() const override { return grid_; }
  exact::Tried<space::RayRow> try_row(int j) const override;
  bool searched() const override { return true; }

 private:
  std::unique_ptr<const NearRule> rule_;
  NearRange range_;
  int outer_;
  space::RayGrid grid_;
  double unit_;
};

}  // namespace findspace::distance
