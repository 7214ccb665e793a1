// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Every distance of a pair of shapes at one position p, with its witness: the two points, one of B + p and one of A,
// that attain it, and the vertices, edges or arcs they lie on. For the distances that are translations to a contact
// (gamma1 < 0, eta, delta) the pair are the points that come together: B + p moved by (point of A) - (point of B)
// touches A there, and the move is as long as the value. Values come from the boundaries alone where these decide:
// shapes that are clearly apart or clearly inside each other, gamma2, mu, h, Hausdorff and diameter; gamma1 < 0, eta1 >
// 0 and delta1 > 0 from the boundary of the sum near p (penetration_depth.h) where its map is large; else from the
// map of the family (t_distance.h), which is made once. Guarantee: as the families'. Cost: about log n boxes for
// boundaries, a map where these meet; of d1 where a vertex is found inside the other shape, not even trees are made.
// Prepared once, asked at many positions; threads: safe. Keywords: witness, closest
// features, contact, clearance, measure.
#pragma once

#include <memory>
#include <mutex>

#include "distance/planar/farthest_from_set.h"
#include "distance/planar/max_min_boxes.h"
#include "distance/planar/penetration_depth.h"
#include "distance/planar/shape_pair.h"
#include "distance/planar_features/common_corner.h"
#include "distance/planar_features/feature_pair_search.h"

namespace findspace::distance {

/// A point of one of the shapes, with B at its place.
struct Feature {
  bool of_moving = false;
  plane::Cell cell;  // of that shape: vertex or edge; dimension 2: a point inside
  exact::RealPoint at;
};

struct Measured {
  exact::Real value;
  std::optional<exact::RealPoint> nearest;   // the nearest position where a signed distance is 0, if its value is not
  std::optional<exact::RealPoint> farthest;  // of eta2, delta2: the position of the farthest touching
  std::vector<Feature> witness;  // two features, of B + p first (of a diameter within one shape both of that)
  bool minus_infinity = false;   // and `value` means nothing
};

/// A pair of A and B + p as features, B's first.
inline std::vector<Feature> features(const FeaturePair& k) {
  return {{true, k.second_cell, k.second}, {false, k.first_cell, k.first}};
}

class AtPosition {
 public:
  explicit AtPosition(std::shared_ptr<const ShapePair> pair);

  const ShapePair& pair() const { return *pair_; }
  /// The size of the numbers of a search at p.
  double scale(const exact::RealPoint& p) const;
  /// f(p); nothing if undefined.
  std::optional<Measured> measure(Which which, const exact::RealPoint& p) const;

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
  const FeatureTree& moving() const { return shapes_[0].prepared().tree; }
  const FeatureTree& fixed() const { return shapes_[1].prepared().tree; }
  /// How B + p and A stand, as far as their boundaries tell.
  struct Standing {
    enum class Kind {
      kApart,
      kInside,
      kAround,
      kMixed,
      kClose
    } kind;                           // kInside: B + p in the inside of A; kClose: boundaries meet, or nearly
    std::optional<FeaturePair> pair;  // of nearest boundary points, unless kClose
  };
  std::optional<Measured> measured(Which which, const exact::RealPoint& p) const;
  Standing standing(const exact::RealPoint& p) const;
  std::optional<Measured> signed_distance(Which which, Standing::Kind quick, const exact::RealPoint& p) const;
  std::optional<Measured> by_map(Which which, const exact::RealPoint& p) const;
  std::optional<Measured> signed_value(Which which, const Standing& s, const exact::RealPoint& p) const;
  const PenetrationDepth* penetration_depth(Which which) const;
  /// Of a pair with arcs: the place of B + p farthest from A, or of A from B + p if `back`.
  const FarthestFromSet& farthest_search(bool back) const;
  std::optional<Measured> farthest(Which which, const exact::RealPoint& p) const;
  /// A value of `floor` or less may come out as 0.
  std::optional<Measured> directed(bool back, const exact::RealPoint& p, double floor = 0) const;
  double protrudes(bool back, double px, double py) const;
  std::optional<Measured> hausdorff(const exact::RealPoint& p) const;
  std::optional<Measured> plain(const exact::RealPoint& p) const;
  std::optional<Measured> diameter(const exact::RealPoint& p) const;
  bool bounded() const;
  std::optional<Measured> cut(std::optional<Measured> m, bool negated) const;
  void add_contact(Measured& m, const exact::RealPoint& position, const exact::RealPoint& p) const;
  std::optional<Measured> common_corner(const exact::RealPoint& p) const;
  std::vector<Feature> corner_features(bool moves, plane::Index v, const exact::RealPoint& p) const;
  std::vector<Feature> common_point(const Standing& s, const exact::RealPoint& p) const;

  std::shared_ptr<const ShapePair> pair_, searched_;  // as given; near the origin: all that is private speaks of that
  std::array<Shape, 2> shapes_;                       // B, A
  mutable std::array<std::once_flag, 3> ways_made_;
  mutable std::array<std::unique_ptr<const PenetrationDepth>, 3>
      ways_;  // of gamma1, eta1, delta1; null where there is none
  mutable std::array<std::once_flag, 2> searches_made_;
  mutable std::array<std::unique_ptr<const FarthestFromSet>, 2> searches_;
  mutable std::once_flag diameters_made_;
  mutable std::array<std::optional<FeaturePair>, 2> diameters_;  // of A, of B
};

}  // namespace findspace::distance
