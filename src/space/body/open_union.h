// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A union O of open convex sets of space, each {x : every plane < 0} (bounded or not), and what lies outside it:
//   nearest_in_complement(p)  the point of the complement of O nearest to p: p itself if no set holds it;
//   nearest_touching(p)   the point of the union of the closed sets nearest to p.
// Both distances of the signed pair sd(p; O, C) of distances.md 3.1 are these two. Slits of no width, fits of no play
// and single points of the complement are found as well as bulky parts of it: whether a point is covered is decided
// exactly. Method: a point nearest to p is the projection of p on at most three planes. Sets of such planes are tried
// by growing distance; a projection that a set covers is replaced by the projections with one more plane of that set,
// each beyond it. Only sets near p are made. Where many sets hold p, boxes of space are looked at one by one
// (complement_search.h). Guarantee: covered or not is exact, also where planes have irrational offsets; the point
// returned is complement, exactly; it is the nearest one but for points that are nearer by less than 2^-40 relative.
// Cost: grows with the number of boxes within the ball about p that no set covers alone. They count for the question
// (search_work.h), and where that may look at no more the search ends with what it knows. Keywords: penetration depth
// of non-convex bodies, distance to complement, union of convex sets, dual simplex, branch and bound.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "exact/margins/rounding.h"
#include "exact/number/tried.h"
#include "space/polytope/extent_tree.h"

namespace findspace::space {

/// How a search for the nearest complement point ended.
struct NearestOutside {
  std::optional<RealVector> at{};  // the nearest one that was found; unless spent, nothing says that there is none
  bool spent = false;              // it did not come to its end
  double bound = 0;                // then none is nearer than that

  /// The point; refused where the search did not come to its end.
  exact::Tried<std::optional<RealVector>> settled() const;
};

class OpenUnion {
 public:
  using Planes = std::vector<HalfSpace>;
  /// A plane to rounding: its value at x is off by no more than share * (|x| + 2 |shift|) + off, with the size of x.
  struct RoundedPlane {
    Vector unit;
    double shift;
    double share = margin::kRoundings32, off = 0;
  };
  using RoundedPlanes = std::vector<RoundedPlane>;
  /// The sets; each is made when it is first looked at.
  void add(const Extent& extent, std::function<Planes()> make);
  void add(const Extent& extent, Planes planes);
  /// One whose planes doubles know much sooner; perhaps more of them, which touch it. Nothing where they do not.
  void add(const Extent& extent, std::function<Planes()> make, std::function<std::optional<RoundedPlanes>()> rounded);
  /// What the functions need lives as long as this.
  void keep(std::shared_ptr<const void> needed) { kept_.push_back(std::move(needed)); }

  std::size_t size() const { return parts_.size(); }
  /// A set that holds p, or -1.
  int covering(const RealVector& p) const;
  bool covers(const RealVector& p) const { return covering(p) >= 0; }
  /// Nothing where everything is covered. `within`: boxes that hold the complement, if some are known.
  NearestOutside nearest_in_complement(const RealVector& p, std::span<const Extent> within = {}) const;
  /// Nothing where there are no sets.
  std::optional<RealVector> nearest_touching(const RealVector& p) const;
  const Planes& planes(std::size_t k) const;
  /// The same to rounding, side by side in memory.
  std::span<const RoundedPlane> rounded_planes(std::size_t k) const;
  /// Whether these are known sooner than the exact ones.
  bool rounds_early(std::size_t k) const { return bool(parts_[k]->round); }
  const Extent& extent(std::size_t k) const { return parts_[k]->extent; }
  /// Of the extents; made when first needed.
  const ExtentTree& tree() const;

 private:
  struct Part {
    Extent extent;
    std::function<Planes()> make;
    std::function<std::optional<RoundedPlanes>()> round;
    mutable std::once_flag made, made_rounded;
    mutable Planes planes;
    mutable RoundedPlanes rounded;
  };
  struct Index {
    std::once_flag made;
    ExtentTree tree;
  };
  std::vector<std::unique_ptr<Part>> parts_;
  std::vector<std::shared_ptr<const void>> kept_;
  std::unique_ptr<Index> index_ = std::make_unique<Index>();
};

/// The complement point of the box that is farthest from p; nothing if the box is covered. Cost: the convex pieces
/// looked at, which count for the question; refused where that may look at no more.
exact::Tried<std::optional<RealVector>> farthest_in_complement(const OpenUnion& cover, const RealVector& low,
                                                               const RealVector& high, const RealVector& p);

/// The point of the closed convex set {x : every plane <= 0} nearest to p; nothing if the set is empty. It counts for
/// no question.
std::optional<RealVector> nearest_in(std::span<const HalfSpace> planes, const RealVector& p);

}  // namespace findspace::space
