// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Features that touch each other with one normal: corners and what ends in them, smooth joins, halves of a circle; not
// circles that touch from outside, nor lines on the other side.
#include <gtest/gtest.h>

#include <cmath>

#include "plane/rotation/contact_joints.h"

namespace findspace::plane {
namespace plane_contact_joints {

using exact::Real;

RoundFeature round(const Real& x, const Real& y, const Real& r) {
  return {{x, y}, r, x.to_double(), y.to_double(), r.to_double(), {0, 1}};
}

/// From p to q, the normal to the right.
EdgeFeature edge(double x0, double y0, double x1, double y1) {
  const double length = std::hypot(x1 - x0, y1 - y0), nx = (y1 - y0) / length, ny = (x0 - x1) / length;
  const auto real = [](double x) { return Real::from_double(x); };
  return {{real(x0), real(y0)}, {real(x1), real(y1)}, -1, x0, y0, x1, y1, nx, ny, std::atan2(ny, nx)};
}

TEST(ContactJoints, ArcsAndTheCornersAtTheirEnds) {
  const Real root = sqrt(Real(2));
  const ContactJoints joints{{{round(0, 0, 2), round(root, root, 0), round(root, root + Real::ratio(1, 1000000), 0),
                               round(0, 0, 2), round(0, 0, -2), round(3, 0, 5), round(3, 0, 1)},
                              {}}};
  EXPECT_TRUE(joints.rounds(0, 1));  // sqrt(2), sqrt(2) lies on the circle
  EXPECT_TRUE(joints.rounds(1, 0));
  EXPECT_FALSE(joints.rounds(0, 2));  // a millionth off
  EXPECT_EQ(joints.circle(3), 0u);    // the other half
  EXPECT_TRUE(joints.rounds(3, 1));
  EXPECT_EQ(joints.circle(4), 4u);  // material on the other side
  EXPECT_TRUE(joints.rounds(4, 1));
  EXPECT_TRUE(joints.rounds(0, 5));   // a smooth join: one in the other
  EXPECT_FALSE(joints.rounds(0, 6));  // they touch from outside: opposite normals
  EXPECT_TRUE(joints.rounds(4, 6));   // an arc that goes over into one bent the other way
}

TEST(ContactJoints, EdgesWithCornersAndArcs) {
  const ContactJoints joints{{{round(4, 3, 0), round(4, 4, 0), round(0, 5, 4), round(3, -4, 5), round(-3, 4, 5)},
                              {edge(0, 0, 4, 3), edge(0, 9, 1, 9)}}};
  EXPECT_TRUE(joints.edge(0, 0));  // its end
  EXPECT_FALSE(joints.edge(0, 1));
  EXPECT_TRUE(joints.edge(0, 2));   // goes over into it: normal (3, -4)/5 there, too
  EXPECT_FALSE(joints.edge(0, 3));  // on the other side
  EXPECT_TRUE(joints.edge(0, 4));
  EXPECT_FALSE(joints.edge(1, 2));  // tangent with the opposite normal
}

}  // namespace plane_contact_joints
}  // namespace findspace::plane
