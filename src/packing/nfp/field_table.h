// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The parts at their allowed angles ("variants"), and the depth field of every two of them. A field is made when it is
// first asked for, by any thread. Guarantee: see depth_field.h. Keywords: no-fit polygon cache.
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
  std::size_t part = 0;
  Fraction angle;
  Vec low, high;  // the box of the part about its origin
  SearchShape shape;
};

/// A part where it stands, relative to the corner between the edges.
struct Pose {
  std::size_t variant = 0;
  Vec at;
};

class FieldTable {
 public:
  /// Throws Error(kBadValue) where a part is higher than the strip at every angle.
  explicit FieldTable(const Problem& problem);

  /// Between the edges.
  double height() const { return height_; }
  double gap() const { return gap_; }
  double edge() const { return edge_; }
  const std::vector<Variant>& variants() const { return variants_; }
  const std::vector<std::size_t>& variants_of(std::size_t part) const { return of_part_[part]; }

  /// How far the variant must be moved to be this shape at its own position, if it looks the same.
  std::optional<Vec> offset_to(std::size_t variant, const SearchShape& shape) const;

  /// Of positions of b relative to a; a <= b.
  const DepthField& field(std::size_t a, std::size_t b) const {
    const DepthField* known = table_[a * variants_.size() + b].load(std::memory_order_acquire);
    return known != nullptr ? *known : make(a, b);
  }
  double depth(const Pose& p, const Pose& q) const {
    return p.variant <= q.variant ? field(p.variant, q.variant).depth(q.at - p.at)
                                  : field(q.variant, p.variant).depth(p.at - q.at);
  }

 private:
  const DepthField& make(std::size_t a, std::size_t b) const;
  void add_variants(const Problem& problem, std::size_t part);

  double gap_, edge_, height_;
  std::vector<Variant> variants_;
  std::vector<std::vector<std::size_t>> of_part_;
  mutable std::vector<std::atomic<const DepthField*>> table_;
  mutable std::vector<std::unique_ptr<const DepthField>> made_;
  mutable std::mutex guard_;
};

}  // namespace findspace::packing
