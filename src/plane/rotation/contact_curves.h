// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The positions s in which a set B, rotated by an angle and moved by s, touches a set A: curves, one for each pair of
// features with opposite normals (contact_features.h). An edge and a round give a segment, two rounds a part of a
// circle, or a point where the radii cancel. Each curve as numbers at an angle, exactly at an exact turn, and for a
// sector as polynomials of the half angle, in doubles or exact. With u the normal at the contact, pointing from A to B,
// B goes free of A by moving along u: a round pair touches at s = center + radius * u, a segment has one u. Guarantee:
// rough numbers and polynomials to about 1e-14 of the sizes, exact curves exact. Keywords: c-space obstacle boundary,
// moving convolution.
#pragma once

#include <compare>
#include <memory>

#include "plane/rotation/contact_features.h"
#include "plane/rotation/curve_forms.h"
#include "plane/rotation/rough_overlap.h"

namespace findspace::plane {

struct ContactPair {
  enum class Kind : std::uint8_t { kRounds, kFixedEdge, kTurningEdge };
  Kind kind;
  Index fixed, rotating;  // in the features of A and of B
  friend auto operator<=>(const ContactPair&, const ContactPair&) = default;
};

struct RoughCurve {
  bool line = false;
  RoughPoint p, q, normal;  // of a segment; normal = u
  RoughPoint center;
  double radius = 0;      // signed
  Cone normals, opposed;  // u lies in both
  double offset() const { return normal.real() * p.real() + normal.imag() * p.imag(); }
  bool allows(RoughPoint u, double tolerance) const;  // of a round pair
  bool holds(RoughPoint at, double tolerance) const;  // a point of its line or circle lies on it
  RoughPoint normal_at(RoughPoint at) const;          // u
  double least() const;                               // a lower bound of the distance to the origin
};

/// normal * s = offset (the normal has any length, points along u), or the circle.
struct ExactCurve {
  bool line = false;
  RealVector normal;
  exact::Real offset;
  RealVector center;
  exact::Real radius;  // signed
};

class ContactCurves {
 public:
  /// Features of B relative to the point it rotates about, of A relative to where that point comes to lie.
  ContactCurves(ContactFeatures rotating, ContactFeatures fixed)
      : ContactCurves(std::make_shared<ContactFeatures>(std::move(rotating)), std::move(fixed)) {}
  ContactCurves(std::shared_ptr<const ContactFeatures> rotating, ContactFeatures fixed)
      : rotation_(std::move(rotating)), fixed_(std::move(fixed)) {}

  /// The pairs that can touch at some angle (radians) between middle - half and middle + half.
  std::vector<ContactPair> pairs(double middle, double half) const;
  /// Those among some that can in a narrower sector.
  std::vector<ContactPair> pairs(const std::vector<ContactPair>& among, double middle, double half) const;
  RoughCurve rough(const ContactPair& pair, double angle) const;
  ExactCurve exact(const ContactPair& pair, const exact::ExactAngle& rotation) const;
  /// Around an angle.
  SectorCurve sector(const ContactPair& pair, double middle) const;
  ExactSectorCurve exact_sector(const ContactPair& pair, int quarters) const;

  const ContactFeatures& rotating() const { return *rotation_; }
  const ContactFeatures& fixed() const { return fixed_; }

 private:
  bool may_touch(const ContactPair& pair, double middle, double half) const;

  std::shared_ptr<const ContactFeatures> rotation_;
  ContactFeatures fixed_;
};

/// Whether a feature of A and one of B can touch at some angle between middle - half and middle + half.
bool can_touch(const Cone& a, Outside of_a, const Cone& b, Outside of_b, double middle, double half);
/// Whether a feature of the other set, as it stands, may touch one of these. `fixed`: they stand still.
bool may_touch_one(const ContactFeatures& these, bool fixed, const FeatureOutline& other);

/// Its normal of the edge's length, exact.
RealVector exact_normal(const EdgeFeature& e);
/// r times the length of n.
exact::Real times_length(const exact::Real& r, const RealVector& n);

}  // namespace findspace::plane
