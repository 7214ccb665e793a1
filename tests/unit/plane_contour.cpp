// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Rings: what is refused and why, what is normalised, nesting. Degenerate input first.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <random>

#include "findspace/error.h"
#include "plane/contour/alike.h"
#include "plane/contour/contour.h"
#include "plane/contour/nesting_depths.h"

namespace findspace::plane {
namespace plane_contour {

using exact::Real;

Contour ring(std::initializer_list<GridPoint> points) {
  Contour contour;
  for (GridPoint p : points) contour.push_back({.start = p});
  return contour;
}

Contour square(std::int64_t x0, std::int64_t y0, std::int64_t x1, std::int64_t y1) {
  return ring({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}});
}

/// The error of a set of rings, or an empty one.
Error refusal(std::vector<Contour> rings) {
  try {
    make_rings(std::move(rings), 1);
  } catch (const Error& e) {
    return e;
  }
  return Error(ErrorCode::kUsage, "");
}

void expect_refused(std::vector<Contour> rings, const std::string& words) {
  Error e = refusal(std::move(rings));
  EXPECT_EQ(e.code(), ErrorCode::kGeometry);
  EXPECT_NE(e.message().find(words), std::string::npos) << e.message();
}

TEST(Contour, RefusesRingsWithoutArea) {
  expect_refused({{}}, "fewer than three");
  expect_refused({ring({{1, 1}})}, "fewer than three");
  expect_refused({ring({{1, 1}, {1, 1}, {1, 1}, {1, 1}})}, "fewer than three");
  expect_refused({ring({{0, 0}, {5, 0}})}, "fewer than three");
  expect_refused({ring({{0, 0}, {5, 0}, {2, 0}})}, "one line");
  expect_refused({ring({{0, 0}, {1, 1}, {2, 2}, {3, 3}})}, "one line");
  std::int64_t far = std::int64_t{1} << 40;
  expect_refused({ring({{-far, -far}, {far, far}, {0, 0}})}, "one line");
}

TEST(Contour, SaysWhereARingCrossesItself) {
  Error e = refusal({ring({{0, 0}, {4, 4}, {4, 0}, {0, 4}})});
  EXPECT_EQ(e.message(),
            "the ring touches or crosses itself: edge 0 from (0, 0) to (4, 4) and edge 2 from (4, 0) to (0, 4) meet at "
            "(2, 2)");
  ASSERT_EQ(e.geometry().size(), 1u);
  EXPECT_DOUBLE_EQ(e.geometry()[0][0], 2);
}

TEST(Contour, EdgesCountAsGivenAlsoBehindRepeatedPoints) {
  Error e = refusal({ring({{0, 0}, {0, 0}, {4, 4}, {4, 4}, {4, 0}, {0, 4}})});
  EXPECT_NE(e.message().find("edge 1 from (0, 0) to (4, 4) and edge 4 from (4, 0)"), std::string::npos) << e.message();
}

TEST(Contour, RefusesTouchingItself) {
  expect_refused({ring({{0, 0}, {4, 0}, {2, 2}, {4, 4}, {0, 4}, {2, 2}})}, "meet at (2, 2)");  // vertex on vertex
  expect_refused({ring({{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}})}, "meet at (2, 0)");          // vertex on edge
  expect_refused({ring({{0, 0}, {6, 0}, {6, 4}, {4, 4}, {4, 0}, {2, 0}, {2, 4}, {0, 4}})}, "touches or crosses itself");
  expect_refused({ring({{0, 0}, {4, 0}, {4, 2}, {4, 4}, {4, 1}, {0, 4}})}, "run along each other");  // a spike
}

/// Seen whole from the mean of their corners or nearly so, near the origin and where products need 128 bits.
TEST(Contour, StarsFarOffAreAsNear) {
  for (const std::int64_t far : {std::int64_t(0), (std::int64_t(1) << 30) - 20, std::int64_t(1) << 31}) {
    for (const std::int64_t size : {std::int64_t(1), (std::int64_t(1) << 39) / 10}) {
      auto star = [&](std::initializer_list<GridPoint> points) {
        Contour contour;
        for (GridPoint p : points) contour.push_back({.start = {far + size * p.x, -far + size * p.y}});
        return std::vector<Contour>{contour};
      };
      EXPECT_EQ(make_rings(star({{0, 0}, {9, 3}, {10, 0}, {9, 9}, {0, 10}, {3, 3}}), 1).reversed_rings, 0);
      EXPECT_EQ(make_rings(star({{0, 0}, {0, 10}, {10, 10}, {10, 0}}), 1).reversed_rings, 1);
      EXPECT_EQ(make_rings(star({{0, 0}, {0, 9}, {9, 9}, {9, 8}, {1, 8}, {1, 0}}), 1).reversed_rings, 1);  // no star
      expect_refused(star({{0, -10}, {6, 8}, {-10, -3}, {10, -3}, {-6, 8}}), "itself");  // round twice
      expect_refused(star({{0, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 0}, {10, 0}, {10, 10}, {0, 10}}), "itself");
    }
  }
}

TEST(Contour, NearMissesOfOneStepAreFine) {
  std::int64_t far = std::int64_t{1} << 40;
  EXPECT_NO_THROW(make_rings({ring({{-far, 0}, {far, -1}, {far, 0}, {-far, 1}})}, 1));
  EXPECT_NO_THROW(make_rings({ring({{0, 0}, {far, far - 1}, {far, far}})}, 1));
  EXPECT_NO_THROW(make_rings({ring({{-far, -far}, {far - 1, far - 2}, {far, far}, {far - 1, far - 1}})}, 1));
}

TEST(Contour, Normalises) {
  RingSet set = make_rings({ring({{0, 4}, {4, 4}, {4, 4}, {4, 0}, {0, 0}}), ring({{1, 1}, {3, 1}, {3, 3}, {1, 3}})}, 1);
  EXPECT_EQ(set.reversed_rings, 1);
  EXPECT_EQ(set.repeated_points, 1);
  ASSERT_EQ(set.contours.size(), 2u);
  EXPECT_EQ(set.contours[0].size(), 4u);
  EXPECT_EQ(orientation(set.contours[0]), 1);
  EXPECT_EQ(orientation(set.contours[1]), -1);
}

TEST(Contour, KeepsCollinearPoints) {
  EXPECT_EQ(make_rings({ring({{0, 0}, {2, 0}, {4, 0}, {4, 4}, {0, 4}})}, 1).contours[0].size(), 5u);
}

TEST(Contour, RefusesHoles) {
  Contour outer = square(0, 0, 10, 10);
  expect_refused({outer, square(20, 1, 22, 3)}, "hole 0 is not inside the ring: its vertex (20, 1)");
  expect_refused({outer, square(8, 4, 12, 6)}, "hole 0 touches or crosses the ring");
  expect_refused({outer, square(0, 4, 2, 6)}, "hole 0 touches or crosses the ring");
  expect_refused({outer, ring({{0, 5}, {2, 4}, {2, 6}})}, "meet at (0, 5)");
  expect_refused({outer, square(1, 1, 9, 9), square(3, 3, 5, 5)}, "hole 1 is inside hole 0");
  expect_refused({outer, square(3, 3, 5, 5), square(1, 1, 9, 9)}, "hole 0 is inside hole 1");
  expect_refused({outer, square(1, 1, 3, 3), square(3, 3, 5, 5)}, "hole 1 touches or crosses hole 0");
  expect_refused({outer, square(-5, -5, 20, 20)}, "hole 0 is not inside the ring");
  expect_refused({outer, outer}, "run along each other");
  EXPECT_NO_THROW(make_rings({outer, square(1, 1, 3, 3), square(4, 4, 5, 5)}, 1));
}

TEST(Contour, NestsByEvenOdd) {
  std::vector<RingSet> sets =
      nest_rings({square(4, 4, 6, 6), square(0, 0, 10, 10), square(20, 0, 30, 10), square(2, 2, 8, 8)}, 1);
  ASSERT_EQ(sets.size(), 3u);
  EXPECT_EQ(sets[0].contours.size(), 1u);  // the island
  EXPECT_EQ(sets[1].contours.size(), 2u);
  EXPECT_EQ(sets[1].contours[1][0].start, (GridPoint{2, 2}));
  EXPECT_EQ(orientation(sets[1].contours[1]), -1);
  EXPECT_EQ(sets[2].contours.size(), 1u);
  EXPECT_THROW(nest_rings({square(0, 0, 4, 4), square(4, 0, 8, 4)}, 1), Error);
  EXPECT_TRUE(nest_rings({}, 1).empty());
}

TEST(Contour, ChainsDropRepeatedPoints) {
  std::int64_t repeated = 0;
  EXPECT_EQ(make_chain(ring({{0, 0}, {0, 0}, {1, 0}, {1, 0}, {0, 0}}), repeated).size(), 3u);
  EXPECT_EQ(repeated, 2);
  EXPECT_THROW(make_chain(ring({{0, 0}, {0, 0}}), repeated), Error);
  EXPECT_THROW(make_chain({}, repeated), Error);
}

TEST(Contour, EnclosesWithPointsLevelWithVertices) {
  Contour diamond = ring({{0, -4}, {4, 0}, {0, 4}, {-4, 0}});
  EXPECT_TRUE(encloses(diamond, {0, 0}));
  EXPECT_TRUE(encloses(diamond, {-3, 0}));
  EXPECT_FALSE(encloses(diamond, {-5, 0}));
  EXPECT_FALSE(encloses(diamond, {5, 0}));
  EXPECT_FALSE(encloses(diamond, {-1, 4}));
  EXPECT_FALSE(encloses(diamond, {-1, -4}));
}

/// A star-shaped ring about (cx, cy).
Contour star(std::size_t n, std::int64_t cx, std::int64_t cy, double size, std::mt19937& random) {
  std::uniform_real_distribution<double> radius(size / 2, size);
  Contour contour;
  for (std::size_t i = 0; i < n; ++i) {
    double angle = 2 * 3.14159265358979 * double(i) / double(n), r = radius(random);
    contour.push_back({.start = {cx + std::llround(r * std::cos(angle)), cy + std::llround(r * std::sin(angle))}});
  }
  return contour;
}

TEST(Contour, ThreeThousandVerticesTakeMilliseconds) {
  std::mt19937 random(7);
  std::vector<Contour> rings{star(3000, 0, 0, 1e9, random)};
  auto start = std::chrono::steady_clock::now();
  make_rings(rings, 1);
  double ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  RecordProperty("milliseconds", std::to_string(ms));
  EXPECT_LT(ms, 100);  // 3 ms where it was written; room for sanitizers
}

TEST(Contour, FindsTheCrossingsAmongThousands) {
  std::mt19937 random(11);
  Contour contour = star(3000, 0, 0, 1e9, random);
  std::swap(contour[1000], contour[1500]);
  EXPECT_THROW(make_rings({contour}, 1), Error);
}

TEST(Contour, ManyHolesInAnyOrder) {
  std::vector<Contour> rings{square(-1, -1, 1000, 1000)};
  for (std::int64_t i = 0; i < 900; ++i) {
    std::int64_t k = i * 523 % 900, x = k % 30 * 30, y = k / 30 * 30;
    rings.push_back(square(x, y, x + 20, y + 20));
  }
  EXPECT_EQ(make_rings(rings, 1).contours.size(), 901u);
  rings.push_back(square(10, 10, 12, 12));
  expect_refused(rings, "is inside hole");
}

/// In each of 40 places up to four squares in each other, in no order; `around`: those about each, by their numbers.
std::vector<Contour> nested_squares(std::vector<std::vector<std::size_t>>& around) {
  constexpr std::size_t kSquares = 160;  // 157 is prime to it
  std::vector<Contour> rings;
  for (std::size_t k = 0; k < kSquares; ++k) {
    const std::size_t at = k * 157 % kSquares;
    const auto x = std::int64_t(at / 4 * 100), in = std::int64_t(at % 4 * 10);
    rings.push_back(square(x + in, in, x + 90 - in, 90 - in));
  }
  around.resize(kSquares);
  for (std::size_t i = 0; i < kSquares; ++i)
    for (std::size_t j = 0; j < kSquares; ++j)
      if (i * 157 % kSquares / 4 == j * 157 % kSquares / 4 && j * 157 % kSquares < i * 157 % kSquares)
        around[i].push_back(j);
  return rings;
}

GridPoint first_corner(const Contour& contour) {
  const auto before = [](const ContourEdge& e, const ContourEdge& f) { return e.start < f.start; };
  return std::min_element(contour.begin(), contour.end(), before)->start;
}

TEST(Contour, ManyRingsAreNestedInTheirOrder) {
  std::vector<std::vector<std::size_t>> around;
  const std::vector<Contour> rings = nested_squares(around);
  EXPECT_EQ(rings_around(rings), around);
  const std::vector<RingSet> sets = nest_rings(rings, 1);
  ASSERT_EQ(sets.size(), 80u);
  std::size_t k = 0;
  for (const RingSet& set : sets) {
    while (around[k].size() % 2 != 0) ++k;
    ASSERT_EQ(set.contours.size(), 2u);
    const GridPoint outer = first_corner(rings[k++]), hole{outer.x + 10, outer.y + 10};
    EXPECT_EQ(first_corner(set.contours[0]), outer);
    EXPECT_EQ(first_corner(set.contours[1]), hole);
  }
}

TEST(Contour, RingsAroundOneWithTheSameCorners) {
  const Real r(50);
  const auto circle = std::make_shared<const ArcCircle>(ArcCircle{Real(0), Real(0), r});
  const std::vector<GridPoint> corners{{50, 0}, {0, 50}, {-50, 0}, {0, -50}};
  Contour arcs, inscribed;
  for (const GridPoint& p : corners) {
    arcs.push_back({p, circle, true});
    inscribed.push_back({p});
    inscribed.push_back({p});  // given twice
  }
  using Around = std::vector<std::vector<std::size_t>>;
  EXPECT_EQ(rings_around({arcs, inscribed}), (Around{{}, {0}}));
  EXPECT_EQ(rings_around({reversed(inscribed), arcs}), (Around{{1}, {}}));
  EXPECT_EQ(rings_around({arcs, arcs}), (Around{{}, {}}));
  // Beside each other, with one edge in common, and with a corner of one pulled in.
  const Contour half = ring({{50, 0}, {0, 50}, {-50, 0}});
  Contour cap = arcs;
  cap.pop_back();
  cap.back() = {.start = {-50, 0}};
  EXPECT_EQ(rings_around({cap, half}), (Around{{}, {0}}));
  EXPECT_EQ(rings_around({reversed(cap), reversed(half)}), (Around{{}, {0}}));
  const Contour left = ring({{-50, 0}, {0, -50}, {0, 50}}), right = ring({{50, 0}, {0, 50}, {0, -50}});
  EXPECT_EQ(rings_around({left, right, inscribed}), (Around{{2}, {2}, {}}));
  const Contour notched = ring({{0, 0}, {90, 0}, {90, 90}, {30, 60}}), whole = ring({{0, 0}, {90, 0}, {90, 90}});
  EXPECT_EQ(rings_around({whole, notched}), (Around{{1}, {}}));
}

TEST(Contour, AHundredThousandRingsAreNotComparedInPairs) {
  std::vector<Contour> rings;
  for (std::int64_t k = 0; k < 100000; ++k) {
    const std::int64_t x = k % 400 * 30, y = k / 400 * 30;
    rings.push_back(square(x, y, x + 20, y + 20));
  }
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(nest_rings(rings, 1).size(), 100000u);
  EXPECT_EQ(rings_around(rings).size(), 100000u);
  rings.insert(rings.begin(), square(-1, -1, 12000, 12000));
  EXPECT_EQ(make_rings(std::move(rings), 1).contours.size(), 100001u);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  RecordProperty("seconds", std::to_string(seconds.count()));
  EXPECT_LT(seconds.count(), 10);  // all pairs take longer; room for sanitizers
}

ShapePtr rings(std::vector<Contour> contours) {
  Shape shape;
  shape.kind = Shape::Kind::kRings;
  shape.contours = make_rings(std::move(contours), 1).contours;
  return std::make_shared<const Shape>(std::move(shape));
}

ShapePtr disc(GridPoint center, std::int64_t radius) {
  Shape shape;
  shape.kind = Shape::Kind::kDisc;
  shape.points = {center};
  shape.amount = Real(radius);
  return std::make_shared<const Shape>(std::move(shape));
}

TEST(Alike, IsTheSameButForATranslation) {
  const Contour lens = {{.start = {0, 0}, .arc = std::make_shared<const ArcCircle>(ArcCircle{5, 0, 5}), .ccw = false},
                        {.start = {10, 0}}};
  const Contour fuller = {
      {.start = {0, 0}, .arc = std::make_shared<const ArcCircle>(ArcCircle{5, 0, 5}), .ccw = false},
      {.start = {10, 0}, .arc = std::make_shared<const ArcCircle>(ArcCircle{5, 0, 5}), .ccw = false}};
  const Contour moved = {
      {.start = {17, 3}},
      {.start = {7, 3}, .arc = std::make_shared<const ArcCircle>(ArcCircle{12, 3, 5}), .ccw = false}};
  Shape line;
  line.kind = Shape::Kind::kPolyline;
  line.contours = {ring({{0, 0}, {1, 0}})};
  const ShapePtr open = std::make_shared<const Shape>(line);
  const std::vector<ShapePtr> all{rings({square(0, 0, 9, 9), square(1, 1, 2, 2), square(4, 4, 6, 6)}),
                                  rings({ring({{29, 9}, {29, 0}, {20, 0}, {20, 9}}), square(24, 4, 26, 6),
                                         square(21, 1, 22, 2)}),  // from elsewhere
                                  rings({square(0, 0, 9, 9), square(1, 1, 2, 2), square(4, 4, 6, 7)}),
                                  rings({square(0, 0, 9, 9)}),
                                  rings({lens}),
                                  rings({moved}),
                                  rings({fuller}),
                                  disc({0, 0}, 5),
                                  disc({40, 40}, 5),
                                  disc({0, 0}, 6),
                                  open,
                                  open,
                                  rings({ring({{0, 0}, {9, 0}, {9, 3}, {0, 3}})}),
                                  rings({ring({{0, 0}, {3, 0}, {3, 9}, {0, 9}})})};
  EXPECT_EQ(first_alike(all), (std::vector<std::size_t>{0, 0, 2, 3, 4, 4, 6, 7, 7, 9, 10, 11, 12, 13}));
}

}  // namespace plane_contour
}  // namespace findspace::plane
