// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Least directed and Hausdorff distances of shapes with arcs, general ones and ones that are their own mirror image:
// also where the value is enclosed only (`proven` false), no position beyond the bound is as good, what is given has
// the value, and where points are given the value grows all around each of them, so that no curve or face was missed.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "distance/planar/shape_pair.h"
#include "distance/planar_least/extremum.h"
#include "distance_random.h"
#include "findspace/error.h"
#include "plane/contour/contour.h"
#include "plane/query/topology.h"

namespace findspace::distance {
namespace distance_round_least {

class RoundShapes {
 public:
  explicit RoundShapes(unsigned seed) : random_(seed) {}

  int number(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }

  /// A star-shaped polygon, some edges of which are arcs.
  Region star() {
    for (;;) {
      plane::Contour ring;
      const int n = number(3, 7);
      for (int k = 0; k < n; ++k) {
        const double angle = 2 * M_PI * (k + number(1, 9) / 10.0) / n, r = number(150, 400);
        ring.push_back({.start = {std::llround(r * std::cos(angle)), std::llround(r * std::sin(angle))}});
      }
      for (std::size_t k = 0; k < ring.size(); ++k)
        if (number(0, 2) == 0)
          ring[k] = plane::bulge_arc(ring[k].start, ring[(k + 1) % ring.size()].start,
                                     Real::ratio(number(-4, 4) * 2 + 1, 20));
      if (const auto made = region(std::move(ring))) return *made;
    }
  }

  /// Four corners and two of the edges arcs, the same left and right.
  Region mirrored() {
    const std::int64_t w = number(100, 400), v = number(100, 400), h = number(100, 300);
    const Real bulge = Real::ratio(number(1, 6), 10), other = Real::ratio(number(-3, 6) * 2 + 1, 20);
    plane::Contour ring{plane::bulge_arc({-w, -h}, {w, -h}, other),
                        {.start = {w, -h}},
                        plane::bulge_arc({v, h}, {-v, h}, bulge),
                        {.start = {-v, h}}};
    const auto made = region(std::move(ring));
    return made ? *made : mirrored();
  }

 private:
  static std::optional<Region> region(plane::Contour ring) {
    try {
      return plane::region_of_rings(plane::make_rings({std::move(ring)}, 1).contours);
    } catch (const Error&) {
      return std::nullopt;  // it crosses itself
    }
  }

  std::mt19937 random_;
};

/// Is f more than the level in all directions around the point?
bool grows_around(const TDistance& f, const RealPoint& p, double level, double radius) {
  for (int k = 0; k < 16; ++k) {
    const double angle = 2 * M_PI * k / 16;
    const RealPoint q{p.x + Real::from_double(radius * std::cos(angle)),
                      p.y + Real::from_double(radius * std::sin(angle))};
    if (!(f.value(q)->value.to_double() > level + 1e-9)) return false;
  }
  return true;
}

void expect_right(const TDistance& f, const Extremum& e) {
  ASSERT_TRUE(e.exists());
  const double level = e.answer->value.to_double();
  if (!e.proven()) {
    EXPECT_LE(level - e.bound()->to_double(), 1e-12 * std::abs(level) + 1e-12);
    EXPECT_FALSE(plane::any_mark(f.sign_map(*e.bound()), [](plane::Mark m) { return m <= 0; }));
    EXPECT_LT(e.within, 1e-8);
  }
  for (const auto& v : e.at.vertices) {
    if (v.mark <= 0) continue;
    const RealPoint p = e.at.geometry.exact(v.point);
    EXPECT_NEAR(f.value(p)->value.to_double(), level, 1e-10);
    if (e.at.edges.empty()) {
      EXPECT_TRUE(grows_around(f, p, level, 1)) << "proven " << e.proven();
    }
  }
}

TEST(RoundLeast, GeneralShapes) {
  RoundShapes random(31);
  int points = 0, proven = 0;
  for (int k = 0; k < 10; ++k) {
    const ShapePair pair(random.star(), random.star());
    for (const Which w : {Which::kMu, Which::kMuBack}) {
      SCOPED_TRACE(::testing::Message() << "case " << k << " distance " << int(w));
      const auto f = pair.distance(w);
      const Extremum e = least(*f);
      expect_right(*f, e);
      points += e.at.edges.empty();
      proven += e.proven();
    }
  }
  EXPECT_GT(points, 15);
  EXPECT_GT(proven, 17);
}

TEST(RoundLeast, ShapesThatAreTheirMirrorImages) {
  RoundShapes random(32);
  int proven = 0;
  for (int k = 0; k < 12; ++k) {
    const ShapePair pair(random.mirrored(), random.mirrored());
    for (const Which w : {Which::kMu, Which::kMuBack, Which::kHausdorff}) {
      SCOPED_TRACE(::testing::Message() << "case " << k << " distance " << int(w));
      const auto f = pair.distance(w);
      const Extremum e = least(*f);
      expect_right(*f, e);
      proven += e.proven();
    }
  }
  EXPECT_GT(proven, 25);
}

}  // namespace distance_round_least
}  // namespace findspace::distance
