// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The position nearest to p outside an open set of positions O that holds p, O being
//   contact:     {p : int A meets int (B + p)}   (then the distance is the penetration depth, -gamma1),
//   containment: {p : B + p leaves A}            (then it is eta1 > 0),
// from the boundary of O near p alone: boxes of positions are taken in the order of their distance from p; one is
// dropped where two edges cross, a vertex lies inside, or a disc inside one shape reaches into the other, by more than
// the box is wide; else it is halved, or, once few curves reach into it, arranged exactly (plane/local_sum.h).
// Guarantee: exact, slots and single free points included. Cost: boxes along the part of O's boundary that is about as
// near as the nearest point; 0.02 to 0.2 s for jagged polygons of 1000 vertices, milliseconds for smooth ones.
// Keywords: penetration depth, branch and bound, local arrangement.
#pragma once

#include <atomic>
#include <memory>

#include "distance/inner_disc.h"
#include "plane/local_sum.h"
#include "plane/nearest.h"

namespace findspace::distance {

class WayOut {
 public:
  enum class Of { kContact, kContainment };

  enum class When { kPaying, kAlways };

  /// Null where the shapes are not bounded by grid segments alone, or where the map of all positions is cheap (not for
  /// kAlways). References are kept.
  static std::unique_ptr<const WayOut> make(const SiteTree& moving, const SiteTree& fixed, Of of,
                                            When when = When::kPaying);

  /// Is p in O?
  bool holds(const exact::RealPoint& p) const { return sum_->holds(p); }

  /// Whether more questions cost less than the map.
  bool pays() const { return boxes_left_ > 0; }

  struct Answer {
    bool known = true;                      // false where the map would have cost less
    std::optional<plane::Nearest> nearest;  // nothing if O is everything
  };
  Answer nearest(const exact::RealPoint& p) const;

 private:
  WayOut(const SiteTree& moving, const SiteTree& fixed, Of of, std::shared_ptr<const plane::LocalSum> sum,
         std::int64_t boxes);
  /// At a place the shapes overlap (or B leaves A) by more than `reach`: so they do wherever that leads.
  bool certainly_holds(double x, double y, double reach) const;
  bool certainly_holds(const plane::GridBox& w) const;

  const SiteTree &moving_, &fixed_;
  Of of_;
  std::shared_ptr<const plane::LocalSum> sum_;
  InnerDisc moving_disc_, fixed_disc_;
  mutable std::atomic<std::int64_t> boxes_left_;  // for all questions together
};

}  // namespace findspace::distance
