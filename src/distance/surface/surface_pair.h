// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Those T-distances of a moving body B and a fixed body A of space at a position that their surfaces tell, without
// convex parts (solid_pair.h defines them all and needs parts):
//   gamma1, d1, penetration        apart: the least distance of the surfaces; d1 is 0 where the interiors meet;
//   eta1, mu, h, hausdorff         B + p in A, of one surface: minus the least distance of the surfaces;
//   gamma2, diameter               of the convex hulls;
//   eta1, eta2, mu in a convex A   of the convex hull of B;
//   eta1, eta2                     undefined where B's box is larger than A's;
//   dstar                          0 where the one does not lie in the other;
//   gamma1, penetration            overlapping: the nearest position at which they touch from outside;
//   eta1, eta2 in one surface      the nearest, and the farthest, position at which B touches it from inside;
//   mu, h, hausdorff outside       at a corner of B, or by search (surface_max_min.h);
//   delta1, delta2, mu, h back     as these with the roles exchanged.
// Guarantee: exact, but for what is searched (to 2^-40; `proven` is false then). Other values are refused.
// Cost: surface_gap.h; surface_contact.h where positions are looked for at which they touch. Source: decisions 11 (why
// facets suffice), 15, 19. Keywords: clearance, mesh distance, penetration depth.
#pragma once

#include <mutex>

#include "distance/solid/solid_pair.h"
#include "distance/surface/surface_contact.h"
#include "space/surface/surface_gap.h"

namespace findspace::distance {

/// A body as its surface knows it, at a scale that it shares with another.
struct Surfaced {
  std::shared_ptr<const space::SurfaceSet> surface;  // may be null
  /// A body of the same convex hull; null where there is none. `convex`: it is the body.
  std::shared_ptr<const space::Body> outline;
  bool convex = false;
  std::shared_ptr<const space::Body> parts{};  // the body, where it is known
};

class SurfacePair : public PairDistances {
 public:
  SurfacePair(Surfaced b, Surfaced a);

 private:
  /// Positions at which the moving one touches the fixed one from one side, made when first needed.
  struct Contacts {
    std::once_flag made;
    std::unique_ptr<const SurfaceContacts> contacts;
  };
  struct Side {
    const Surfaced *moving = nullptr, *fixed = nullptr;
    std::unique_ptr<const space::SurfaceGaps> gaps;
    std::unique_ptr<Contacts> outside = std::make_unique<Contacts>(), inside = std::make_unique<Contacts>();
  };
  static Side side(const Surfaced& moving, const Surfaced& fixed);
  static std::optional<space::SurfaceGaps::Relation> relation(const Side& side, const space::RealVector& p,
                                                              std::optional<Answer>& gap);
  static const SurfaceContacts& contacts(const Side& side, space::TouchSide from);
  const Side& side(Inner inner) const { return inner == Inner::kB ? forth_ : back_; }
  /// As seen by the one that is to lie in the other.
  static space::RealVector seen(Inner inner, const space::RealVector& p) {
    return inner == Inner::kB ? p : space::negated(p);
  }
  static TriedAnswer decided(Inner inner, TriedAnswer v, const space::RealVector& p) {
    return inner == Inner::kB ? v : exchanged_back(std::move(v), p);
  }
  /// How deep they overlap; how far the moving one, which does not lie in the fixed one, is from it, and the farthest
  /// position at which it does.
  TriedAnswer depth(const space::RealVector& p) const;
  static TriedAnswer to_fit(const Side& side, bool farthest, const space::RealVector& p);
  static Answer protrusion(const Side& side, const space::RealVector& p);
  /// Whether boxes tell that it fits nowhere.
  static bool too_large(const Side& side);

  TriedAnswer gap(const space::RealVector& p, Depth depth) const override;
  TriedAnswer reach(const space::RealVector& p) const override { return of_outlines(Which::kGamma2, p); }
  TriedAnswer diameter(const space::RealVector& p) const override { return of_outlines(Which::kDiameter, p); }
  TriedAnswer of_outlines(Which which, const space::RealVector& p) const;
  TriedAnswer fit(Inner inner, const space::RealVector& p) const override;
  TriedAnswer farthest_fit(Inner inner, const space::RealVector& p) const override;
  TriedAnswer protrusion(Inner inner, const space::RealVector& p, Depth depth) const override;
  TriedAnswer clearance(Inner inner, const space::RealVector& p) const override;

  Surfaced b_, a_;
  Side forth_, back_;
};

}  // namespace findspace::distance
