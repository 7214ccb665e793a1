// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The position nearest to p, or farthest from it, outside an open set of positions O, which is
//   contact:     {p : int A meets int (B + p)}   (the distance from p in O is the penetration depth, -gamma1),
//   containment: {p : B + p leaves A}            (it is eta1 > 0; the farthest is eta2),
// from the boundary of O there alone: boxes of positions are taken in the order of their distance; one is
// dropped where two edges cross, a vertex lies inside, or a disc inside one shape reaches into the other, by more than
// the box is wide; else it is halved, or, once few curves reach into it, arranged exactly (grid polygons,
// plane/sum/local_sum.h) or its free meetings found (arcs, holes that one could go round,
// plane/rotation/free_places.h). Guarantee: exact, slots and single free points included. Cost: boxes along the part of
// O's boundary that is about as near as the nearest point; 0.02 to 0.2 s for jagged polygons of 1000 vertices,
// milliseconds for smooth ones. Keywords: penetration depth, branch and bound, local arrangement.
#pragma once

#include <atomic>
#include <memory>
#include <variant>

#include "distance/planar_features/feature_pair_search.h"
#include "distance/planar_features/feature_pairs.h"
#include "distance/planar_features/inner_disc.h"
#include "plane/query/nearest.h"
#include "plane/rotation/free_places.h"
#include "plane/sum/local_sum.h"

namespace findspace::distance {

class PenetrationDepth {
 public:
  enum class Of { kContact, kContainment };

  enum class When { kPaying, kAlways };

  /// Null where a shape has parts without interior, or, for kPaying, where the map of all positions is cheap.
  /// References are kept.
  static std::unique_ptr<const PenetrationDepth> make(const FeatureTree& moving, const FeatureTree& fixed, Of of,
                                                      When when = When::kPaying);

  /// Is p in O?
  bool holds(const exact::RealPoint& p) const;

  /// Whether more questions cost less than the map.
  bool pays() const { return boxes_left_ > 0; }

  struct Found {
    bool known = true;                      // false where the map would have cost less
    std::optional<plane::Nearest> nearest;  // nothing if O is everything
  };
  /// The nearest position outside O, for p in O.
  Found nearest(const exact::RealPoint& p) const { return search(p, false); }
  /// The farthest position outside O, of containment: eta2.
  Found farthest(const exact::RealPoint& p) const { return search(p, true); }

 private:
  using Grid = std::shared_ptr<const plane::LocalSum>;
  using Places = std::shared_ptr<const plane::FreePlaces>;
  using Sum = std::variant<Grid, Places>;

  PenetrationDepth(const FeatureTree& moving, const FeatureTree& fixed, Of of, Sum sum, std::int64_t boxes);
  Found search(const exact::RealPoint& p, bool far) const;
  template <class Boundary>
  Found search(const Boundary& boundary, const std::optional<plane::GridBox>& bounds, const exact::RealPoint& p,
               bool far) const;
  /// How long to look for edges that cross, of one question. Where one finds them it finds them soon, as a rule: a look
  /// that is much longer is cut short, unless those that were cut took as long as the last whole one.
  class Patience {
   public:
    std::size_t most() const { return looks_of_cut_ < looks_of_whole_ ? usual() : SIZE_MAX; }
    void ended(const CutSearch& search);

   private:
    std::size_t usual() const;

    std::size_t found_ = 0, looks_of_found_ = 0, looks_of_cut_ = 0, looks_of_whole_ = 0;
  };
  /// At a place the shapes overlap (or B leaves A), and they do wherever moves so far lead.
  bool certainly_holds(double x, double y, const Moves& by, Patience& patience) const;
  bool edges_cross(double x, double y, const Moves& by, Patience& patience) const;
  /// B is too wide or too high for A there, or reaches beyond it.
  bool sticks_out(double x, double y, const Moves& by) const;
  bool certainly_holds(const plane::GridBox& w, Patience& patience) const;
  /// Whether left and right halves of a window are likelier to be dropped than lower and upper ones: moves along y
  /// alone lead nowhere else than its middle does. Windows of thin teeth become long, and few.
  bool halves_across_x(const plane::GridBox& w, Patience& patience) const;
  /// They do not, and the boundaries are farther than the margin from each other.
  bool certainly_free(double x, double y, double margin) const;

  const FeatureTree &moving_, &fixed_;
  Of of_;
  Sum sum_;
  InnerDisc moving_disc_, fixed_disc_;
  mutable std::atomic<std::int64_t> boxes_left_;  // for all questions together
};

}  // namespace findspace::distance
