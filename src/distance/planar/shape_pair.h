// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// All T-distances of one moving shape B and one fixed shape A, each made once when first asked for and sharing what
// they have in common: the sets X (shapes meet), E (B in A) and D (A in B). The table of distances.md 3.1 to 3.4.
// Guarantee: as the families'. Threads: safe. Units: grid steps.
#pragma once

#include <array>
#include <memory>
#include <mutex>
#include <optional>

#include "distance/planar/signed_distance.h"
#include "distance/planar_features/t_distance.h"
#include "plane/complex/shared_region.h"

namespace findspace::distance {

/// "moving to fixed": the first argument of the formula is the moving shape.
enum class Which {
  kGamma1,
  kGamma2,
  kEta1,
  kEta2,
  kDelta1,
  kDelta2,
  kMu,      // of B+p to A
  kMuBack,  // of A to B+p
  kHausdorff,
  kD1,
  kH,
  kHBack,      // as kMu, kMuBack
  kDstar,      // d*(B+p, A) = d(A, complement of B+p)
  kDstarBack,  // d*(A, B+p) = d(B+p, complement of A)
  kDiameter,
  kPenetration
};
inline constexpr std::size_t kWhichCount = 16;

class ShapePair {
 public:
  /// Closed sets, B bounded.
  ShapePair(plane::SharedRegion b, plane::SharedRegion a);

  TDistancePointer distance(Which which) const;
  /// The same shapes, cell by cell, where they are far from the origin for their size and searches in numbers would be
  /// coarse: near the origin. A distance at p is there that at p + by.
  struct AtOrigin {
    std::shared_ptr<const ShapePair> pair;
    exact::RealPoint by, fixed_by;  // of positions; of A
  };
  const std::optional<AtOrigin>& at_origin() const;
  /// The distance for searches: as distance(), which need not be made, but searched near the origin.
  TDistancePointer searched(Which which) const;
  /// Has it been made?
  bool has(Which which) const {
    std::lock_guard lock(guard_);
    return known_[std::size_t(which)] != nullptr;
  }
  const plane::Region& moving() const { return b_; }
  const plane::Region& fixed() const { return a_; }

 private:
  TDistancePointer made(Which which) const;
  TDistancePointer farthest(Which base) const;
  TDistancePointer diameter() const;

  plane::SharedRegion b_, a_;
  mutable std::recursive_mutex guard_;
  mutable std::array<TDistancePointer, kWhichCount> known_;
  mutable std::once_flag moved_;
  mutable std::optional<AtOrigin> at_origin_;
};

}  // namespace findspace::distance
