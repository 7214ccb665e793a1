// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/planar_least/level_extremum.h"

#include <algorithm>
#include <cmath>

#include "distance/planar_features/point_set.h"
#include "distance/planar_least/extremum_candidates.h"
#include "distance/planar_least/level_probe.h"
#include "exact/margins/planar_distance.h"
#include "exact/margins/plane.h"
#include "plane/complex/extent.h"
#include "plane/query/topology.h"

namespace findspace::distance {

using exact::Real;
using plane::CellComplex;
using plane::Region;

namespace {

class LevelSearch {
 public:
  LevelSearch(const PositionFunction& f, const Region& s, Sense sense)
      : f_(f), s_(s), sense_(sense), rotation_(sense == Sense::kMinimum ? 1 : -1) {
    // What is least, or greatest but finite, is so near to shapes or at the frontier of S.
    if (const auto box = plane::extent(s)) most_ += 4 * std::max({-box->x0, box->x1, -box->y0, box->y1});
  }

  Extremum run(bool continuous) {
    Extremum out = no_optimum<Region>(sense_);
    if (plane::is_empty(s_) || !f_.defined()) return out;
    if (!bracket(out)) return out;
    narrow(0.25);
    if (whole_number(out, continuous)) return out;
    narrow(margin::kLevelWidth);
    out.set_enclosed(level(good_), level(bad_), Way::kSearch);
    out.attained = true;
    const ComponentPoints found = one_point_a_component(probe(level(good_), s_));
    out.within = found.within;
    out.at = point_set(found.points);
    return out;
  }

 private:
  CellComplex probe(const Real& level, const Region& over) const { return distance::probe(f_, level, over, rotation_); }
  Real level(double number) const { return Real::from_double(rotation_ * number); }
  bool reaches(double number) const { return !plane::is_empty(probe(level(number), s_)); }

  /// The extremum into (bad, good], less being better; false where there is none.
  bool bracket(Extremum& out) {
    good_ = 1;
    bad_ = -1;
    for (; good_ < most_ && !reaches(good_); good_ *= 2) bad_ = good_;
    if (good_ >= most_) return false;
    for (; bad_ > -most_ && reaches(bad_); bad_ *= 2) good_ = bad_;
    out.unbounded = bad_ <= -most_;
    return !out.unbounded;
  }

  /// Bisects to a width of so many steps, or 2^-48 of the value.
  void narrow(double width) {
    while (good_ - bad_ > std::max(width, std::abs(good_) * margin::kNarrowLevelBracket)) {
      const double middle = bad_ + (good_ - bad_) / 2;
      (reaches(middle) ? good_ : bad_) = middle;
    }
  }

  /// Whether the extremum is the whole number in the bracket, with proof.
  bool whole_number(Extremum& out, bool continuous) const {
    const double whole = std::round(good_);
    if (whole < bad_ || whole > good_) return false;
    const CellComplex at = probe(level(whole), s_);
    if (has_mark(at, kBeyond)) return false;
    out.attained = has_mark(at, kOn);
    // Where S has nothing there, its closure may: an infimum, of which all that is beyond is reached.
    if (!out.attained && !continuous) return false;
    out.at = on_level(out.attained ? at : probe(level(whole), plane::closure(s_)));
    if (!out.attained && plane::is_empty(out.at)) return false;
    out.set_exact(level(whole), Way::kMap);
    return true;
  }

  const PositionFunction& f_;
  const Region& s_;
  Sense sense_;
  int rotation_;
  double most_ = 2 * margin::kBeyondAll;  // no value lies beyond half of it
  double bad_ = 0, good_ = 0;
};

}  // namespace

Extremum level_extremum(const PositionFunction& f, const Region& s, Sense sense, bool continuous) {
  return LevelSearch(f, s, sense).run(continuous);
}

}  // namespace findspace::distance
