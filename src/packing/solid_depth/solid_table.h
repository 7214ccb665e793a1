// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The kinds of parts, and how deep any two of them overlap at any position, in doubles. The depth of two convex parts
// is minus the greatest plane of their Phi-function (convex_overlap.h), that of two unions the sum over all pairs of
// convex parts. So along any line it is concave between the ends of the pairs' intervals, and least at one of them.
// What lies about a container that is no box is one more kind, which never moves (container_walls.h). A pair's planes
// are made when it is first looked at, by any thread. Guarantee: that of doubles; it steers a search, proofs do not use
// it. Keywords: penetration depth, configuration-space obstacle, no-fit polyhedron.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "packing/solid_depth/container_walls.h"
#include "packing/solid_depth/convex_overlap.h"
#include "packing/solid_problem/solid_pair_formula.h"

namespace findspace::packing {

/// Of two kinds.
class OverlapPair {
 public:
  Vector low, high;  // the box of all
  std::vector<ConvexOverlap> overlaps;
  std::optional<SolidPairFormula> tie;  // where there are conditions

  bool may_hold(const Vector& u) const {
    return u.x > low.x && u.y > low.y && u.z > low.z && u.x < high.x && u.y < high.y && u.z < high.z;
  }
  double depth(const Vector& u, double shallow) const;

 private:
  friend class SolidTable;

  /// make(overlap, blocks) makes an overlap and adds its planes.
  template <class Make>
  void add(const Make& make) {
    begins_.push_back(blocks_.size());
    make(overlaps.emplace_back(), blocks_);
  }
  /// After all are added.
  void close();

  std::vector<space::PlaneBlock> blocks_;
  std::vector<space::HeightBlock> heights_;  // the same along each axis
  std::vector<std::size_t> begins_;          // of each overlap's planes
};

/// A part where it stands, relative to the corner within the edges, in the column of containers.
struct SolidPose {
  std::size_t variant = 0;
  Vector at;
};

inline constexpr std::size_t kWallPart = std::size_t(-1);

/// A form of a part that fits the floor or a container; of forms that look the same, moved, only the first and those of
/// fixed solids. Or the walls of a container that is no box: its part is kWallPart, its form the kind of container.
struct SolidVariant {
  std::size_t part = 0, form = 0;
  Vector low, high;  // the box about its origin
};

/// Boxes and planes that take about as long as the conditions of a pair.
inline constexpr std::uint64_t kWorkOfTie = 20;

class SolidTable {
 public:
  /// A part that fits no container has no variants. The problem must live as long.
  explicit SolidTable(const SolidProblem& problem);

  const std::vector<SolidVariant>& variants() const { return variants_; }
  const std::vector<std::size_t>& variants_of(std::size_t part) const { return of_part_[part]; }
  /// Of the fixed solids of the problem.
  const std::vector<std::size_t>& fixed_variants() const { return fixed_; }
  /// Of the walls of a kind of container; nothing of a box.
  std::optional<std::size_t> walls_of(std::size_t kind) const { return walls_of_[kind]; }
  /// The pose of a placed part.
  SolidPose pose_of(const SolidPlaced& item) const;
  /// Of the widest floor within the edges, which all margins are relative to.
  double size() const { return size_; }
  /// The widest gap of any two.
  double gap() const { return gap_; }
  double edge() const { return edge_; }
  /// The highest part in its lowest form; no layout with it is lower.
  double tallest() const { return tallest_; }

  /// How a copy of b overlaps one of a at the origin, or the other way round with all positions reflected: sign -1.
  struct Link {
    const OverlapPair& pair;
    double sign;
  };
  Link link(std::size_t a, std::size_t b) const {
    const double sign = a <= b ? 1 : -1;
    if (a > b) std::swap(a, b);
    const std::atomic<const OverlapPair*>& known = pairs_[a * variants_.size() + b];
    if (const OverlapPair* pair = known.load(std::memory_order_acquire)) return {*pair, sign};
    return {make(a, b), sign};
  }

  /// Whether there is a condition between the parts of two variants: then they are never too far apart to be looked at.
  bool are_tied(std::size_t a, std::size_t b) const { return problem_.are_tied(variants_[a].part, variants_[b].part); }
  bool has_ties() const { return !problem_.conditions.empty(); }
  /// By how much their conditions hold with a copy of b at u from one of a, in doubles; below 0 where they fail. What
  /// is put onto the grid of a layout then holds exactly, contacts where they are contacts on the grid.
  double slack(std::size_t a, std::size_t b, const Vector& u) const {
    const auto [pair, sign] = link(a, b);
    return pair.tie->slack(sign * u, room_, contact_);
  }
  /// How far one of them may be moved for certain.
  double free_move(std::size_t a, std::size_t b, const Vector& u) const {
    return link(a, b).pair.tie->jumps() ? 0 : std::max(slack(a, b, u), 0.0);
  }
  /// Parts of different containers are farther apart than any condition asks.
  double greatest_level() const { return greatest_level_; }

 private:
  const SolidForm& form_of(const SolidVariant& v) const { return problem_.parts[v.part].forms[v.form]; }
  void add_variants(std::size_t part);
  void add_fixed();
  void add_walls();
  const OverlapPair& make(std::size_t a, std::size_t b) const;
  std::unique_ptr<OverlapPair> of_parts(std::size_t a, std::size_t b) const;
  std::unique_ptr<OverlapPair> of_walls(std::size_t part, std::size_t wall) const;

  const SolidProblem& problem_;
  double size_ = 0, gap_, edge_, tallest_ = 0, greatest_level_ = 0, room_ = 0, contact_ = 0;
  std::vector<SolidVariant> variants_;
  std::vector<std::vector<std::size_t>> of_part_;
  std::vector<std::size_t> fixed_;
  std::vector<std::optional<std::size_t>> walls_of_;  // of each kind of container
  std::vector<ContainerWalls> walls_;                 // of the last variants
  mutable std::vector<std::atomic<const OverlapPair*>> pairs_;
  mutable std::vector<std::unique_ptr<const OverlapPair>> made_;
  mutable std::mutex guard_;
};

}  // namespace findspace::packing
