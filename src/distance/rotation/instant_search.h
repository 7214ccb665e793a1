// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Looks for the least or greatest value of a distance at instants of a motion that turns: first evenly, then where it
// may be best (Piyavskii 1972, squared_bound.h), then beside the best one. Guarantee: ends after a stated amount of
// work (search_work.h), in which a look that needs a map of positions weighs more; what it did not look at is bounded.
// Keywords: Lipschitz optimisation, golden section.
#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "distance/rotation/rotation_motion.h"
#include "distance/rotation/squared_bound.h"
#include "plane/base/search_work.h"
#include "plane/base/subdivide.h"

namespace findspace::distance {

/// f is rotated round for suprema, so that the least value is looked for.
class InstantSearch {
 public:
  static constexpr double kNone = std::numeric_limits<double>::infinity();

  /// An instant that was looked at.
  struct Sample {
    std::size_t leg;
    double s, f;
    double rated;    // not above f: what bounds it beside
    double off = 0;  // both may be
    double most() const { return f + off; }
  };

  /// `most`: cells of work. Keeps references.
  InstantSearch(const RotatingMotion& motion, const exact::RealPoint& p, bool least, long most)
      : motion_(motion), p_(p), sign_(least ? 1 : -1), most_work_(most) {}

  void look_evenly(std::size_t legs);
  /// Until the best value is as near its bound as `enough`, and roundings allow; or as low as `floor`; or all work is
  /// done.
  void narrow(double enough, double floor = -kNone);
  /// f is smooth or has one kink near its extremum: golden sections of the gaps beside the best instant.
  void refine();

  const std::vector<Sample>& undefined() const { return undefined_; }  // instants that were looked at
  const Sample& best() const { return best_; }
  /// f is nowhere less, if it keeps to its rate.
  double certain() const { return std::min(gaps_.best().low, best_.f - best_.off); }
  double most() const { return most_; }  // of the plain f

 private:
  struct Gap {
    Sample a, b;
    std::optional<Sample> before, after;  // on the same leg
    double low;
    double off() const { return std::max(a.off, b.off); }
    bool operator<(const Gap& other) const { return low > other.low; }
  };

  Sample look(std::size_t leg, double s, bool refining = false);
  void keep_better(const Sample& k) {
    if (k.most() < best_.most()) best_ = k;
  }
  void add(Gap gap);
  double low_between(const Gap& gap) const;
  bool spent() const { return work_ >= most_work_ || question_.work().spent(); }
  /// The instants looked at before and after the best one, on its leg.
  std::pair<double, double> beside_best() const;

  const RotatingMotion& motion_;
  const exact::RealPoint& p_;
  double sign_;
  long most_work_, work_ = 0;
  plane::SearchQuestion question_;
  plane::Subdivision<Gap> gaps_;  // the lowest first
  Sample best_{0, 0, kNone, kNone};
  double scale_ = 0, least_gap_ = 0, most_ = -kNone;
  std::vector<Sample> undefined_;
};

}  // namespace findspace::distance
