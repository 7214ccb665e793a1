// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The nearest position outside a set of positions, searched near p, against that of the whole map: on lattice squares
// with holes and slots, where free points and slots count (exact fits), and on stars; for overlaps and for containment.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <string>
#include <string_view>

#include "distance/planar/at_position.h"
#include "distance/planar/farthest.h"
#include "distance/planar/penetration_depth.h"
#include "plane/base/stage_observer.h"
#include "plane/complex/overlay.h"
#include "plane/complex/primitives.h"
#include "plane/query/topology.h"
#include "plane/sum/minkowski.h"
#include "plane/walk/unite.h"

namespace findspace::distance {
namespace distance_penetration_depth {

using exact::Real;
using exact::RealPoint;
using plane::GridPoint;
using plane::Region;

Region ring(const std::vector<GridPoint>& points) {
  plane::Contour c;
  for (auto& p : points) c.push_back({.start = p});
  return plane::region_of_rings(std::array{c});
}

Region squares(std::mt19937& rng, int cells, int count, std::int64_t side) {
  std::vector<Region> parts;
  for (int k = 0; k < count; ++k) {
    std::int64_t x = side * std::int64_t(rng() % cells), y = side * std::int64_t(rng() % cells);
    parts.push_back(ring({{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}}));
  }
  std::vector<const Region*> all;
  for (auto& r : parts) all.push_back(&r);
  return plane::unite(all);
}

Region star(std::mt19937& rng, int n, double size) {
  std::vector<GridPoint> points;
  for (int k = 0; k < n; ++k) {
    double r = (k % 2 ? 0.5 + double(rng() % 200) / 1000 : 0.8 + double(rng() % 200) / 1000) * size,
           angle = 6.283185307179586 * k / n;
    points.push_back({std::llround(r * std::cos(angle)), std::llround(r * std::sin(angle))});
  }
  return ring(points);
}

struct Count {
  int found = 0, everything = 0, outside = 0;
};

/// At some places: is it in the set, and how far out of it?
void compare(const Region& a, const Region& b, PenetrationDepth::Of of, std::int64_t reach, std::mt19937& rng,
             Count& count) {
  const FeatureTree fixed(a), moving(b);
  auto way = PenetrationDepth::make(moving, fixed, of, PenetrationDepth::When::kAlways);
  ASSERT_TRUE(way);
  const bool contact = of == PenetrationDepth::Of::kContact;
  const SignedDistance d = contact ? SignedDistance::gamma1(b, a) : SignedDistance::eta1(b, a);
  for (int k = 0; k < 8; ++k) {
    auto coordinate = [&] {
      return Real::ratio(std::int64_t(rng() % std::uint64_t(4 * reach)) - 2 * reach, k % 2 ? 1 : 3);
    };
    const RealPoint p{coordinate(), coordinate()};
    const auto value = d.value(p);
    const int sign = value ? value->value.sign() : 1;
    ASSERT_EQ(way->holds(p), contact ? sign < 0 : sign > 0);
    if (!contact) {
      const Farthest most(d.base());
      const auto far = way->farthest(p);
      ASSERT_TRUE(far.known);
      ASSERT_EQ(far.nearest.has_value(), most.defined());
      if (far.nearest) {
        EXPECT_EQ(far.nearest->distance, most.value(p)->value);
      }
    }
    if (!way->holds(p)) {
      ++count.outside;
      EXPECT_EQ(closest_pair(fixed, moving, p).distance, abs(value->value));
      continue;
    }
    const auto answer = way->nearest(p);
    ASSERT_TRUE(answer.known);
    ASSERT_EQ(answer.nearest.has_value(), value.has_value());
    if (!value) {
      ++count.everything;
      continue;
    }
    ++count.found;
    EXPECT_EQ(answer.nearest->distance, abs(value->value))
        << answer.nearest->distance.to_double() << " instead of " << value->value.to_double();
    const RealPoint& at = answer.nearest->at;
    EXPECT_EQ((at.x - p.x) * (at.x - p.x) + (at.y - p.y) * (at.y - p.y), value->value * value->value);
    EXPECT_FALSE(way->holds(at));
  }
}

TEST(PenetrationDepth, SquaresWithSlotsAndHoles) {
  Count count;
  for (unsigned seed = 0; seed < 250; ++seed) {
    std::mt19937 rng(seed);
    const std::int64_t side = seed % 2 ? 4 : 1000;
    Region a = squares(rng, 5, 3 + int(rng() % 14), side), b = squares(rng, 3, 1 + int(rng() % 6), side);
    compare(a, b, PenetrationDepth::Of::kContact, 4 * side, rng, count);
    if (plane::LocalSum::containment(a, b)) compare(a, b, PenetrationDepth::Of::kContainment, 4 * side, rng, count);
    if (HasFailure()) FAIL() << "seed " << seed;
  }
  EXPECT_GT(count.found, 300);
  EXPECT_GT(count.everything, 100);
  EXPECT_GT(count.outside, 50);
}

/// A polygon with rounded corners, or grown, or discs united or cut out: arcs, holes, several components.
Region rounded(std::mt19937& rng, std::int64_t size) {
  auto pick = [&](std::int64_t low, std::int64_t high) {
    return low + std::int64_t(rng() % std::uint64_t(high - low + 1));
  };
  std::vector<Region> discs;
  for (int k = 0; k < 4; ++k)
    discs.push_back(plane::region_of_disc(Real(pick(-size, size)), Real(pick(-size, size)), Real(pick(1, size))));
  const Region square = ring({{-size, -size}, {size, -size}, {size, size}, {-size, size}});
  std::vector<const Region*> all;
  for (const Region& d : discs) all.push_back(&d);
  if (rng() % 2) return plane::regularize(plane::unite(all));
  all.insert(all.begin(), &square);
  all.pop_back();
  return plane::regularize(plane::subtract(all));
}

TEST(PenetrationDepth, ArcsAndHoles) {
  Count count;
  for (unsigned seed = 0; seed < 60; ++seed) {
    std::mt19937 rng(seed);
    // On a small lattice discs fit holes exactly and touch each other.
    const std::int64_t size = seed % 2 ? 6 : 1000;
    const Region a = rounded(rng, 2 * size), b = rounded(rng, size);
    if (plane::is_empty(a) || plane::is_empty(b)) continue;
    compare(a, b, PenetrationDepth::Of::kContact, 3 * size, rng, count);
    compare(a, b, PenetrationDepth::Of::kContainment, 3 * size, rng, count);
    if (HasFailure()) FAIL() << "seed " << seed;
  }
  EXPECT_GT(count.found, 100);
  EXPECT_GT(count.outside, 10);
}

TEST(PenetrationDepth, Stars) {
  Count count;
  for (unsigned seed = 0; seed < 24; ++seed) {
    std::mt19937 rng(seed);
    Region a = star(rng, 8 + 2 * int(rng() % 40), 1 << 20),
           b = star(rng, 8 + 2 * int(rng() % 40), seed % 2 ? 1 << 20 : 1 << 18);
    compare(a, b, PenetrationDepth::Of::kContact, 1 << 20, rng, count);
    compare(a, b, PenetrationDepth::Of::kContainment, 1 << 20, rng, count);
    if (HasFailure()) FAIL() << "seed " << seed;
  }
  EXPECT_GT(count.found, 100);
}

/// Chosen by AtPosition where it pays: all distances as from the maps.
TEST(PenetrationDepth, AtAPositionOfLargeShapes) {
  std::mt19937 rng(3);
  auto pair = std::make_shared<ShapePair>(star(rng, 280, 1 << 20), star(rng, 300, 1 << 20));
  for (Which w : {Which::kGamma1, Which::kEta1, Which::kDelta1, Which::kPenetration, Which::kDstar, Which::kEta2,
                  Which::kDelta2}) {
    const RealPoint p{1 << 18, 1 << 19};
    const auto m = AtPosition(pair).measure(w, p);
    const auto whole = ShapePair(pair->moving(), pair->fixed()).distance(w)->value(p);
    ASSERT_EQ(m.has_value(), whole.has_value()) << int(w);
    if (m) {
      EXPECT_EQ(m->value, whole->value) << int(w);
    }
    if (w == Which::kGamma1) {
      ASSERT_TRUE(m && m->nearest && m->witness.size() == 2);
      EXPECT_FALSE(pair->has(w)) << "the map was made";
    }
  }
}

/// Rounded stars: as the map, without it.
TEST(PenetrationDepth, AtAPositionOfRoundedShapes) {
  std::mt19937 rng(4);
  const auto rounded_star = [&] {
    return plane::minkowski_sum(star(rng, 140, 1 << 20), plane::region_of_disc(0, 0, Real(1 << 15)));
  };
  auto pair = std::make_shared<ShapePair>(rounded_star(), rounded_star());
  const RealPoint p{1 << 18, 1 << 19};
  const auto m = AtPosition(pair).measure(Which::kGamma1, p);
  EXPECT_FALSE(pair->has(Which::kGamma1)) << "the map was made";
  ASSERT_TRUE(m && m->nearest && m->witness.size() == 2);
  EXPECT_EQ(m->value, pair->distance(Which::kGamma1)->value(p)->value);
}

/// Teeth of a height, with gaps, on a base below y = 0.
Region comb(int teeth, std::int64_t tooth, std::int64_t gap, std::int64_t height, std::int64_t base) {
  const std::int64_t width = teeth * (tooth + gap);
  std::vector<GridPoint> points{{0, -base}, {width, -base}, {width, 0}};
  for (int k = teeth; k-- > 0;) {
    const std::int64_t x = k * (tooth + gap);
    points.insert(points.end(), {{x + tooth, 0}, {x + tooth, height}, {x, height}, {x, 0}});
  }
  points.pop_back();
  return ring(points);
}

/// How many boxes the last search looked at.
class Boxes : public plane::StageObserver {
 public:
  unsigned long count = 0;
  void cells(std::string_view, const std::string&, const plane::CellComplex&) override {}
  void drawing(std::string_view, const std::string& title, const plane::StageDrawing&) override {
    count = std::stoul(title.substr(title.find(": ") + 2));
  }
};

/// Nowhere does the small comb fit into the large one: as high as the teeth are, boxes can be, but no wider than a gap.
TEST(PenetrationDepth, CombsNeedFewBoxes) {
  const Region large = comb(200, 500'000, 500'000, 60'000'000, 10'000'000),
               small = comb(200, 150'000, 150'000, 18'000'000, 3'000'000);
  const FeatureTree fixed(large), moving(small);
  const auto way = PenetrationDepth::make(moving, fixed, PenetrationDepth::Of::kContainment);
  ASSERT_TRUE(way);
  Boxes boxes;
  const plane::ObserveStages seen(&boxes);
  const auto answer = way->nearest({20'000'000, -3'000'000});
  EXPECT_TRUE(answer.known && !answer.nearest);
  EXPECT_GT(boxes.count, 0u);
  EXPECT_LT(boxes.count, 12'000u);
}

/// Boxes as narrow as a grid step are not divided across it: the half that is left would be the box again.
TEST(PenetrationDepth, CombsOfSingleStepsEnd) {
  const Region large = comb(200, 4, 1, 1000, 1), small = comb(200, 2, 1, 500, 1);
  const FeatureTree fixed(large), moving(small);
  const auto way = PenetrationDepth::make(moving, fixed, PenetrationDepth::Of::kContainment);
  ASSERT_TRUE(way);
  Boxes boxes;
  const plane::ObserveStages seen(&boxes);
  const auto answer = way->nearest({444, -36});
  EXPECT_TRUE(answer.known && !answer.nearest);
  EXPECT_LT(boxes.count, 5'000u);
}

/// Squares and angles that lie apart, on a lattice with gaps of all kinds, some of them exact fits.
Region collection(std::mt19937& rng) {
  std::vector<Region> parts;
  for (int k = 0; k < 2500; ++k) {
    const std::int64_t x = 40 * (k % 50) + std::int64_t(rng() % 4), y = 40 * (k / 50) + std::int64_t(rng() % 4),
                       w = 30 + std::int64_t(rng() % 7), t = 2 + std::int64_t(rng() % 8);
    parts.push_back(ring({{x, y}, {x + w, y}, {x + w, y + w}, {x, y + w}}));
    if (k % 2)  // a frame without a side
      parts.back() = ring({{x, y}, {x + w, y}, {x + w, y + w}, {x + w - t, y + w}, {x + w - t, y + t}, {x, y + t}});
  }
  std::vector<const Region*> all;
  for (const Region& r : parts) all.push_back(&r);
  return plane::unite(all);
}

/// Of a collection only what is near is asked; the map is not made, and the values are its values.
TEST(PenetrationDepth, OfACollectionFromWhatIsNear) {
  std::mt19937 rng(7);
  const Region a = collection(rng);
  const Region square = ring({{-9, -9}, {9, -9}, {9, 9}, {-9, 9}}),
               bar = ring({{-30, -2}, {30, -2}, {30, 2}, {-30, 2}});
  for (const Region& b : {square, plane::region_of_disc(0, 0, 70), bar}) {
    const auto asked = std::make_shared<ShapePair>(b, a), whole = std::make_shared<ShapePair>(b, a);
    const AtPosition at(asked);
    for (int k = 0; k < 12; ++k) {
      const RealPoint p{Real(std::int64_t(rng() % 2000)), Real::ratio(std::int64_t(rng() % 6000), 3)};
      for (const Which which : {Which::kGamma1, Which::kEta1}) {
        const auto value = at.measure(which, p), expected = whole->distance(which)->value(p);
        ASSERT_EQ(value.has_value(), expected.has_value());
        if (value) {
          EXPECT_EQ(value->value, expected->value) << int(which);
        }
      }
      EXPECT_FALSE(asked->has(Which::kGamma1)) << "the map was made";
    }
  }
}

/// What is near B says nothing of B itself: one that is unbounded meets what is far from its boundary. And a point of A
/// alone may lie deep in B.
TEST(PenetrationDepth, OfACollectionOfAnUnboundedShapeAndOfPoints) {
  std::mt19937 rng(7);
  const Region squares = collection(rng), point = plane::region_of_points(std::array{GridPoint{-500, -500}}),
               a = plane::unite(std::array{&squares, &point});
  const Region square = ring({{-9, -9}, {9, -9}, {9, 9}, {-9, 9}}), around = plane::closure(plane::complement(square));
  for (const Region& b : {square, around}) {
    const auto asked = std::make_shared<ShapePair>(b, a), whole = std::make_shared<ShapePair>(b, a);
    const AtPosition at(asked);
    for (const RealPoint& p : {RealPoint{Real(-500), Real(-497)}, RealPoint{Real(-5000), Real(10)}}) {
      const auto value = at.measure(Which::kGamma1, p), expected = whole->distance(Which::kGamma1)->value(p);
      ASSERT_TRUE(value && expected);
      EXPECT_EQ(value->minus_infinity, expected->minus_infinity);
      if (!expected->minus_infinity) {
        EXPECT_EQ(value->value, expected->value);
      }
    }
  }
}

}  // namespace distance_penetration_depth
}  // namespace findspace::distance
