// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The Phi-function of two shapes of the plane, A that stands still and B that is moved by u: the one place where its
// ways are tried. Unions of polygons and discs go by their convex parts (planar_phi_union.h). Every other body (arcs
// that bound no disc, irrational vertices) goes by curves: the boundary of the positions at which the two overlap,
// whose signed distance gamma1 is a normalised Phi-function. `way()` says which. Guarantee: state and
// compare_distance() are exact at every real position. Cost: by parts a filter over the edges of every pair; by curves
// that of gamma1 at a position (at_position.h). Threads: safe. Source: phi.md 7. Keywords: phi-function, no-fit
// polygon, signed distance.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>

#include "distance/answer/way.h"
#include "distance/planar/at_position.h"
#include "space/phi/planar_phi_union.h"

namespace findspace::distance {

/// Two bodies as closed sets.
class PhiCurves {
 public:
  PhiCurves(plane::Region a, plane::Region b);

  const plane::SharedRegion& a() const { return a_; }
  const plane::SharedRegion& b() const { return b_; }
  /// The open set of positions of B at which the interiors meet. Made anew.
  plane::Region overlap() const;

 private:
  plane::SharedRegion a_, b_;
};

/// Two unions of convex parts.
struct PhiParts {
  space::PlanarPhiUnion phi;
  std::size_t a = 0, b = 0;  // how many parts
  exact::Real unit;          // of its coordinates and values, in the unit of the shapes
};

class ShapePhi {
 public:
  /// The closures of both are bodies: Error(kGeometry) for others. `step`: a grid step in the unit of the shapes.
  /// `regions`: the sets that the two are, called where the parts do not do.
  ShapePhi(const plane::Shape& a, const plane::Shape& b, const exact::Real& step,
           const std::function<std::array<plane::Region, 2>()>& regions);

  /// kParts or kContacts.
  Way way() const { return parts_ ? Way::kParts : Way::kContacts; }
  /// Null by the other way.
  const PhiParts* parts() const { return parts_ ? &*parts_ : nullptr; }
  const PhiCurves* curves() const { return curves_ ? &*curves_ : nullptr; }

  using At = space::PlanarPhiUnion::At;
  /// In the unit of the shapes; by curves without a pair and active edges, and with a gradient of 0 in contact.
  At at(const exact::RealPoint& u) const;
  /// The sign of the normalised form minus rho, for rho >= 0.
  int compare_distance(const exact::RealPoint& u, const exact::Real& rho) const;

 private:
  /// In grid steps, as u.
  PlanarAnswer gap(const exact::RealPoint& u) const;

  exact::Real step_;
  std::optional<PhiParts> parts_;
  std::optional<PhiCurves> curves_;
  std::shared_ptr<const AtPosition> pair_;
};

}  // namespace findspace::distance
