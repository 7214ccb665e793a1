// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Where what protrudes on a line ends (protrusion_end.h), on an edge in a crease, and from there inward; and how far
// convex functions run (protrusion_rays.h).
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "distance/rays/protrusion_end.h"
#include "distance/rays/protrusion_rays.h"

namespace findspace::distance {
namespace distance_protrusion_end {

using space::Vector;

constexpr double kHalfRoot = 0.70710678118654752;

/// The distances of places within a crease along z that closes towards x: they are 0 at the crease, at x of 5.
class Crease : public EndField {
 public:
  static std::vector<Tangent> at(const Vector& x) {
    std::vector<Tangent> out;
    for (const double side : {-kHalfRoot, kHalfRoot})
      out.push_back({side * x.y + kHalfRoot * (5 - x.x), {-kHalfRoot, side, 0}});
    return out;
  }
  std::vector<Tangent> tangents(const Vector& x, double least, double most) const override {
    std::vector<Tangent> out;
    for (const Tangent& t : at(x)) {
      if (least <= t.value && t.value <= most) out.push_back(t);
    }
    return out;
  }
};

TEST(ProtrusionEnd, AnEdgeInACreaseAndFromThereInward) {
  // The wedge has its edge along y at its place, and opens towards x.
  const std::vector<NearPlane> wedge{{{-kHalfRoot, 0, kHalfRoot}, 0}, {{-kHalfRoot, 0, -kHalfRoot}, 0}};
  for (const double slant : {0.0, 0.25}) {
    EndQuestion q{wedge, {0, 0, 0}, {std::sqrt(1 - slant * slant), slant, 0}};
    q.target = 2 * kHalfRoot;
    q.reach = 20;
    q.noise = 1e-9;
    const std::optional<EndPlace> found = outermost_place(Crease(), q, {1, 0.5, 0.25}, 0);
    ASSERT_TRUE(found);
    // As far as the target within both sides of the crease, and held by both of the wedge.
    EXPECT_NEAR(found->x.x, 3, 1e-6);
    EXPECT_NEAR(found->x.y, 0, 1e-6);
    EXPECT_NEAR(found->x.z, 0, 1e-6);
    EXPECT_NEAR(found->at * q.unit.x, 3, 1e-6);
    for (const Tangent& t : Crease::at(found->x)) EXPECT_NEAR(space::dot(t.slope, found->inward), 1, 1e-9);
    for (const NearPlane& p : wedge) {
      const Vector off = found->inward - space::scaled(found->inward_at, q.unit);
      EXPECT_NEAR(space::dot(p.unit, off), 0, 1e-9);
    }
    EXPECT_LT(found->inward_at, 0);  // back from the end
  }
}

TEST(ProtrusionEnd, ConvexFunctionsRunUntilTheyAreNoLongerPositive) {
  const auto parabola = [](double s) { return (s - 5) * (s - 5) - 4; };  // 0 at 3
  const double run = convex_run(parabola, 10, 100);
  EXPECT_LE(run, 3);
  EXPECT_GT(run, 3 - 1e-6);
  EXPECT_EQ(convex_run([](double s) { return (s - 5) * (s - 5) + 1; }, 10, 100), 100);
  for (const double farthest : {0.5, 1.0, 2.0, 2.9}) {  // a shorter run is enough, and never a longer one than is true
    const double part = convex_run(parabola, 10, farthest);
    EXPECT_GE(part, farthest);
    EXPECT_LE(part, 3);
  }
}

}  // namespace distance_protrusion_end
}  // namespace findspace::distance
