// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Where the distance to a closed set A, bounded by segments, can have a strict local maximum in the plane outside A:
// the box around A, halved and halved again, each part with the part of A nearest to its middle, and whether it is
// certainly barren, without such a place: it lies in A, or the distance grows in one direction everywhere in it, or
// only two parts of A are near. That is a matter of A alone, so what is found for one position of a moving set is kept
// for the next. Guarantee: a barren box has no such place; what a box says does not depend on what was asked before.
// Cost: a box about ten nearest neighbours once, then a look-up; at most some tens of megabytes are kept. Threads:
// safe. Keywords: medial axis, quadtree, largest empty circle.
#pragma once

#include <cstdint>
#include <shared_mutex>
#include <unordered_map>

#include "distance/planar_features/feature_tree.h"
#include "distance/planar_features/search_range.h"

namespace findspace::distance {

class MaxMinBoxes {
 public:
  /// One of the squares that 2^level by 2^level divide the square around A.
  struct Part {
    int level = 0;
    std::uint64_t column = 0, row = 0;

    Part quarter(int k) const { return {level + 1, 2 * column + unsigned(k & 1), 2 * row + unsigned(k / 2)}; }
    friend bool operator==(const Part&, const Part&) = default;
  };
  struct Look {
    FeatureTree::Near near;  // to the middle
    bool inside, barren;     // inside: the middle lies in A
  };

  /// Keeps a reference; no arcs.
  explicit MaxMinBoxes(const FeatureTree& a);

  Spot middle(const Part& part) const;
  double half(const Part& part) const;
  /// `guess`: the nearest part of the square that this is a quarter of.
  Look look(const Part& part, plane::Index guess) const;

 private:
  struct Hash {
    std::size_t operator()(const Part& p) const {
      return (p.column * 0x9e3779b97f4a7c15u + p.row) * 0x9e3779b97f4a7c15u + std::size_t(p.level);
    }
  };
  bool in_set(Spot at, const FeatureTree::Near& near) const;
  bool few_features(Spot middle, double reach) const;
  bool can_grow(Spot middle, const FeatureTree::Near& near, double radius) const;
  Look looked(const Part& part, plane::Index guess) const;

  const FeatureTree& a_;
  Spot corner_{};
  double size_ = 0, slack_;
  mutable std::shared_mutex guard_;
  mutable std::unordered_map<Part, Look, Hash> known_;
};

}  // namespace findspace::distance
