// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The parts at their allowed angles ("variants"), and the depth field of every two of them. A field is made when it is
// first asked for, by any thread. Pairs that are swapped, or both turned by 180 degrees, share one: the fewer fields
// there are, the more of them stay in the cache. Guarantee: see depth_field.h. Keywords: no-fit polygon cache.
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "packing/nfp/depth_field.h"
#include "packing/problem/problem.h"

namespace findspace::packing {

struct Variant {
  std::size_t part = 0;  // kNoPart: an obstacle of a sheet
  Fraction angle;
  Vec low, high;  // the box of the part about its origin
  SearchShape shape;
  bool mirrored = false;
  const Zone* zone = nullptr;  // of an obstacle that keeps out some parts only
};
inline constexpr std::size_t kNoPart = std::size_t(-1);

/// A part where it stands, relative to the corner between the edges.
struct Pose {
  std::size_t variant = 0;
  Vec at;
};

class FieldTable {
 public:
  /// Throws Error(kBadValue) where a part is higher than the strip at every angle. A part that fits no sheet has no
  /// variants. The problem must live as long as the table.
  explicit FieldTable(const Problem& problem);

  /// Between the edges; of the highest sheet.
  double height() const { return height_; }
  /// The widest gap of any two.
  double gap() const { return gap_; }
  double edge() const { return edge_; }
  const std::vector<Variant>& variants() const { return variants_; }
  const std::vector<std::size_t>& variants_of(std::size_t part) const { return of_part_[part]; }
  /// The obstacles and zones of a kind of sheet.
  const std::vector<std::size_t>& obstacles_of(std::size_t kind) const { return of_sheet_[kind]; }

  /// Of the fixed parts of the problem.
  const std::vector<std::size_t>& fixed_variants() const { return fixed_; }
  /// Whether there is a condition between the parts of two variants: then they are never too far apart to be looked at.
  bool are_tied(std::size_t a, std::size_t b) const { return !ties_.empty() && ties_[a * variants_.size() + b] != 0; }
  bool has_ties() const { return !ties_.empty(); }
  /// Parts of different containers are farther apart than any condition asks.
  double greatest_level() const { return greatest_level_; }

  /// A copy at an angle that the part may have, `at` of its own origin. It may look like another angle up to a
  /// translation; then the pose is that one's. Of what the part never looks like: the part's first variant there.
  Pose pose_of(std::size_t part, const Fraction& angle, bool mirrored, Vec at) const;
  /// How far the variant must be moved to be this shape at its own position, if it looks the same.
  std::optional<Vec> offset_to(std::size_t variant, const SearchShape& shape) const;

  /// The depth field of b about a, or that of a pair that looks the same: swapped, or both turned by 180 degrees.
  class alignas(64) Link {
   public:
    const DepthGlance& glance() const { return glance_; }
    const DepthField& field() const { return *field_.load(std::memory_order_acquire); }
    /// A position of b relative to a, in the field; and a vector of the field as one of positions, or the other way.
    Vec in_field(Vec t) const { return sign_ * t + shift_; }
    Vec rotated(Vec v) const { return sign_ * v; }
    /// The least distance of the two.
    double gap() const { return gap_; }

   private:
    friend class FieldTable;
    mutable DepthGlance glance_;  // with the field, a line of the cache
    mutable std::atomic<const DepthField*> field_ = nullptr;
    Vec shift_;
    double sign_ = 1, gap_ = 0;
    std::uint32_t first_ = 0, second_ = 0;  // the pair whose field it is
  };
  const Link& link(std::size_t a, std::size_t b) const {
    const Link& known = links_[a * variants_.size() + b];
    if (known.field_.load(std::memory_order_acquire) == nullptr) make(known);
    return known;
  }
  double depth(const Pose& p, const Pose& q) const {
    const Link& pair = link(p.variant, q.variant);
    return pair.field().depth(pair.in_field(q.at - p.at));
  }

 private:
  struct Opposite {
    std::size_t variant;
    Vec off;  // the variant turned by 180 degrees is the other one, moved by this
  };

  void make(const Link& link) const;
  static void join(const Link& link, const DepthField& field);
  void add_variants(const Problem& problem, std::size_t part);
  void add_obstacles(const Problem& problem);
  void add_fixed(const Problem& problem);
  void find_ties(const Problem& problem);
  std::optional<Tie> tie_of(const Link& link) const;
  void link_pairs(const Problem& problem);
  void link_pair(const std::vector<std::optional<Opposite>>& opposites, std::size_t a, std::size_t b);
  std::optional<double> gap_of(const Problem& problem, const Variant& a, const Variant& b) const;
  std::optional<Opposite> opposite_of(std::size_t variant) const;

  const Problem& problem_;
  double gap_ = 0, edge_ = 0, height_ = 0, greatest_level_ = 0, reach_ = 0;
  std::vector<Variant> variants_;
  std::vector<std::vector<std::size_t>> of_part_, of_sheet_;
  std::vector<std::size_t> fixed_;
  std::vector<char> ties_;  // of two variants; empty where there is no condition
  std::vector<Link> links_;
  DepthField nothing_{NoFitPolygon{}};  // of two that never collide
  mutable std::vector<std::unique_ptr<const DepthField>> made_;
  mutable std::mutex guard_;
};

}  // namespace findspace::packing
