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

#include "distance/solid/solid_pair.h"
#include "distance/surface/convex_gap.h"
#include "distance/surface/outline.h"
#include "distance/surface/surface_contact.h"
#include "distance/surface/surface_field.h"
#include "plane/base/lazy.h"
#include "space/surface/surface_gap.h"

namespace findspace::distance {

/// A body as its surface knows it, at a scale that it shares with another.
struct Surfaced {
  std::shared_ptr<const space::SurfaceSet> surface;  // may be null
  Outline outline;                                   // `convex`: it is the body
  bool convex = false;
  std::shared_ptr<const space::Body> parts{};  // the body, where it is known
};

PairDistances surface_pair(const Surfaced& b, const Surfaced& a);

/// "B in A": a provider of pair_distances.h.
class SurfaceSide : public PairSide {
 public:
  SurfaceSide(Surfaced b, Surfaced a);

  TriedAnswer gap(const space::RealVector& p, Depth depth) const override;
  TriedAnswer reach(const space::RealVector& p) const override { return of_outlines(Which::kGamma2, p); }
  TriedAnswer diameter(const space::RealVector& p) const override { return of_outlines(Which::kDiameter, p); }
  TriedAnswer fit(const space::RealVector& p) const override;
  TriedAnswer farthest_fit(const space::RealVector& p) const override;
  TriedAnswer protrusion(const space::RealVector& p, Depth depth) const override;
  TriedAnswer clearance(const space::RealVector& p) const override;
  /// The distance where the surfaces are apart and neither solid holds a piece of the other; else that there is none.
  exact::Interval gap_within(const space::Vector& p) const override;
  /// No less than some corners say.
  exact::Interval protrusion_within(const space::Vector& p) const override;

 private:
  /// Positions at which the one touches the other from one side, made when first needed.
  using Contacts = plane::Lazy<std::unique_ptr<const SurfaceContacts>>;
  /// How the two lie, and their distance where that is one.
  std::optional<space::SurfaceGaps::Relation> relation(const space::RealVector& p, std::optional<Answer>& gap) const;
  /// How deep they overlap; how far B, which does not lie in A, is from it, and the farthest position at which it does.
  TriedAnswer depth(const space::RealVector& p) const;
  TriedAnswer to_fit(bool farthest, const space::RealVector& p) const;
  Answer protrusion_out(const space::RealVector& p) const;
  TriedAnswer of_outlines(Which which, const space::RealVector& p) const;
  /// The same of their points, where these tell it: then no hull is made.
  std::optional<Answer> of_corners(Which which, const space::RealVector& p) const;
  /// Whether the outlines tell how B fits, and whether boxes tell that it fits nowhere.
  bool by_outlines() const { return a_.convex && b_.outline; }
  bool too_large() const;

  /// One of the two as numbers see it, and a place of each of its pieces.
  struct Field {
    SurfaceField field;
    std::vector<space::Vector> pieces;
    explicit Field(const space::SurfaceSet& set);
    /// None of the places, moved by p, lies in it, and they are so far from its surface.
    bool surely_outside(const std::vector<space::Vector>& places, const space::Vector& p, double away) const;
  };
  struct Near {
    Field b, a;
    std::optional<ConvexGap> of_b, of_a;  // the distance, where that one is convex
  };
  Near made_near() const;
  /// The least distance of the surfaces, or less than 0 where they cross.
  exact::Interval surfaces_within(const Near& near, const space::Vector& p) const;

  Surfaced b_, a_;
  plane::Lazy<Near> near_;
  /// Corners of B, few, and A.
  struct FewCorners {
    std::vector<space::Vector> corners;
    std::optional<SurfaceField> field;
    double size = 0;
  };
  FewCorners made_few_corners() const;
  plane::Lazy<FewCorners> few_corners_;
  std::unique_ptr<const space::SurfaceGaps> gaps_;
  Contacts outside_, inside_;
};

}  // namespace findspace::distance
