// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What the boundaries of B + p and A tell by themselves, without a map of positions: how the two stand, points that
// they share, and the diameter of their union. Both near the origin, where numbers are small. Guarantee: exact where
// something is said. Cost: about log n boxes a question; trees are made once, when first asked for. Threads: safe.
// Keywords: relative position, closest features.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "distance/answer/answer.h"
#include "distance/planar/max_min_boxes.h"
#include "distance/planar_features/common_corner.h"
#include "distance/planar_features/feature_pair_search.h"

namespace findspace::distance {

/// A pair of A and B + p as features, B's first.
inline std::vector<Feature> features(const FeaturePair& k) {
  return {{true, k.second_cell, k.second}, {false, k.first_cell, k.first}};
}

/// A value that boundaries tell, and the features that take it.
inline PlanarAnswer boundary_answer(exact::Real value, std::vector<Feature> witness) {
  PlanarAnswer out = exact_answer(std::move(value), Way::kFeatures);
  out.witness = std::move(witness);
  return out;
}

/// How B + p and A stand, as far as their boundaries tell.
struct Standing {
  enum class Kind {
    kApart,
    kInside,  // B + p in the inside of A
    kAround,
    kMixed,
    kClose  // boundaries meet, or nearly
  } kind;
  std::optional<FeaturePair> pair;  // of nearest boundary points, unless kClose
};

class PairBoundaries {
 public:
  /// References to the shapes are kept.
  PairBoundaries(const plane::Region& b, const plane::Region& a);

  const FeatureTree& moving() const { return shapes_[0].prepared().tree; }
  const FeatureTree& fixed() const { return shapes_[1].prepared().tree; }
  const MaxMinBoxes& fixed_boxes() const { return shapes_[1].prepared().boxes; }
  const MaxMinBoxes& moving_boxes() const { return shapes_[0].prepared().boxes; }
  /// Whether each shape has a boundary that belongs to it.
  bool complete() const { return shapes_[0].has_boundary && shapes_[1].has_boundary; }
  bool bounded() const;
  /// The size of the numbers of a search at p.
  double scale(const exact::RealPoint& p) const;

  Standing standing(const exact::RealPoint& p) const;
  /// d1 = 0, from a vertex of one shape inside the other. Prepares nothing.
  std::optional<PlanarAnswer> common_corner(const exact::RealPoint& p) const;
  /// A point of both shapes: their boundaries cross there, touch, or one lies in the other.
  std::vector<Feature> common_point(const Standing& s, const exact::RealPoint& p) const;
  std::optional<PlanarAnswer> diameter(const exact::RealPoint& p) const;

 private:
  struct Prepared {
    FeatureTree tree;
    MaxMinBoxes boxes;

    explicit Prepared(const plane::Region& r) : tree(r), boxes(tree) {}
  };
  /// A shape, and what is prepared of it once that is asked for.
  struct Shape {
    Boxed boxed;
    bool has_boundary;
    mutable std::once_flag made;
    mutable std::optional<Prepared> known;

    explicit Shape(const plane::Region& r);
    const Prepared& prepared() const;
  };
  /// A vertex of one shape (of B + p if `moves`) and the point inside the other where it lies.
  std::vector<Feature> corner_features(bool moves, plane::Index v, const exact::RealPoint& p) const;

  std::array<Shape, 2> shapes_;  // B, A
  mutable std::once_flag diameters_made_;
  mutable std::array<std::optional<FeaturePair>, 2> diameters_;  // of A, of B
};

}  // namespace findspace::distance
