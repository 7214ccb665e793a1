// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Which features of one set touch each other, with one normal there: rounds whose circles do (an arc and the corner at
// its end, two arcs that join smoothly), edges and rounds (an edge and its corners). Their contacts with one and the
// same feature of another set then touch each other at every angle, in one point and with one normal. So a third
// contact through that point holds nothing there that it does not hold together with one of the two; and the equation
// of such three has double roots only, which are costly to prove. Guarantee: exact. Cost: quadratic in doubles, an
// exact sign for each pair that is near. Keywords: tangent circles, smooth join.
#pragma once

#include <set>
#include <utility>
#include <vector>

#include "plane/rotation/contact_curves.h"

namespace findspace::plane {

class ContactJoints {
 public:
  explicit ContactJoints(const ContactFeatures& features);

  /// The first round that has the same centre and radius.
  Index circle(Index round) const { return circle_[round]; }
  /// Whether two rounds touch, or are of one circle.
  bool rounds(Index a, Index b) const;
  bool edge(Index edge, Index round) const { return edges_.contains({edge, circle(round)}); }

 private:
  std::vector<Index> circle_;                   // by rounds
  std::set<std::pair<Index, Index>> touching_;  // circles, the lower number first
  std::set<std::pair<Index, Index>> edges_;     // edge and circle
};

/// What two contact curves are to each other at every angle.
class ContactTies {
 public:
  explicit ContactTies(const ContactCurves& curves)
      : curves_(curves), rotation_(curves.rotating()), fixed_(curves.fixed()) {}

  /// They lie on one line or circle, for being of the same edges and circles.
  bool alike(const ContactPair& k, const ContactPair& m) const;
  /// They touch in one point with one normal, are one, or are parallel.
  bool never_cross(const ContactPair& k, const ContactPair& m) const;

 private:
  bool joined(const ContactPair& round, const ContactPair& other) const;
  bool is_point(const ContactPair& k) const;

  const ContactCurves& curves_;
  ContactJoints rotation_, fixed_;
};

}  // namespace findspace::plane
