// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The distances of a pair at a position that are translations to a contact: gamma1, eta1, delta1 (the nearest) and
// eta2, delta2 (the farthest). They come from the boundaries where these are clearly apart or inside each other; else
// from the boundary of the sum near p (penetration_depth.h) where its map is large; else from the map of the family. Of
// a collection only what lies within about the distance counts, and the rest is not looked at. The witness is the pair
// of points that come together. Guarantee: as the families'. Threads: safe. Keywords: penetration depth, containment
// margin, contact.
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>

#include "distance/planar/pair_boundaries.h"
#include "distance/planar/penetration_depth.h"
#include "distance/planar/shape_pair.h"
#include "plane/query/boundary_components.h"

namespace findspace::distance {

class ContactValues {
 public:
  /// The boundaries have to outlive it.
  ContactValues(std::shared_ptr<const ShapePair> pair, const PairBoundaries& boundaries)
      : pair_(std::move(pair)), boundaries_(boundaries) {}

  /// gamma1, eta1 or delta1.
  std::optional<PlanarAnswer> signed_distance(Which which, const exact::RealPoint& p) const;
  /// The same of shapes whose standing is known, and is not the one that boundaries answer for.
  std::optional<PlanarAnswer> signed_value(Which which, const Standing& s, const exact::RealPoint& p) const;
  /// eta2 or delta2.
  std::optional<PlanarAnswer> farthest(Which which, const exact::RealPoint& p) const;

 private:
  std::optional<PlanarAnswer> by_map(Which which, const exact::RealPoint& p) const;
  /// Whether the insides (or that of B and the outside of A) meet at p, and the nearest position where not.
  struct Held {
    bool holds;
    PenetrationDepth::Found found;  // where it holds
  };
  /// Nothing where the map has to tell.
  std::optional<Held> held(Which which, const exact::RealPoint& p) const;
  /// Of a collection A, from those of its parts that are near. Nothing of another, where the map is made, and where
  /// none but isolated points are near.
  std::optional<Held> held_near(Which which, const exact::RealPoint& p) const;
  const plane::BoundaryComponents* parts() const;
  /// Null where there is none, or the map serves better.
  const PenetrationDepth* penetration_depth(Which which) const;
  /// The points that come together when B goes from p to `position`, where it touches A.
  std::vector<Feature> contact(const exact::RealPoint& position, const exact::RealPoint& p) const;

  std::shared_ptr<const ShapePair> pair_;
  const PairBoundaries& boundaries_;
  mutable std::once_flag parts_made_;
  mutable std::optional<plane::BoundaryComponents> parts_;  // of A, where it has many and B is bounded
  mutable std::atomic<std::int64_t> questions_left_ = 0;    // that look at what is near
  mutable std::array<std::once_flag, 3> made_;
  mutable std::array<std::unique_ptr<const PenetrationDepth>, 3> depths_;  // of gamma1, eta1, delta1; null without one
};

}  // namespace findspace::distance
