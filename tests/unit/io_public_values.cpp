// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Typed shapes, regions that are walked, and compiled queries, through the public headers alone.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <random>

#include "findspace/findspace.h"

namespace io_public_values {

using namespace findspace;
using namespace findspace::words;

std::string message_of(const std::function<void()>& act) {
  try {
    act();
  } catch (const Error& e) {
    return e.what();
  }
  return "nothing was thrown";
}

const std::vector<Position> kSquare{{0, 0}, {10, 0}, {10, 10}, {0, 10}};

TEST(PublicShape, PolygonsFromArrays) {
  const std::vector<Position> hole{{2, 2}, {4, 2}, {4, 4}, {2, 4}};
  const Shape s = Shape::polygon(kSquare, {hole});
  EXPECT_EQ(s.region().area(), 96);
  EXPECT_EQ(s.region().holes(), 1u);
  EXPECT_EQ(s.rounded().points, 0u);
  EXPECT_EQ(s.dimension(), 2);
}

TEST(PublicShape, PolygonsFromIntegers) {
  using Steps = std::array<std::int64_t, 2>;
  const std::vector<Steps> ring{{0, 0}, {4'000'000'001, 0}, {0, 2}}, flat{{1, 1}, {2, 1}, {3, 1}};
  EXPECT_EQ(*Shape::polygon(std::span<const Steps>(ring), {}, {1}).region().area(), 4'000'000'001);
  EXPECT_THROW(Shape::polygon(std::span<const Steps>(ring), {flat}, {1}), Error);
}

TEST(PublicShape, DoublesStandForTheirDecimals) {
  const std::vector<Position> tenths{{0.1, 0.2}, {0.3, 0.2}, {0.3, 0.7}};
  const Shape from_doubles = Shape::polygon(tenths);
  EXPECT_EQ(from_doubles.rounded().points, 0u);
  EXPECT_EQ(from_doubles.region(), Shape::polygon({{"0.1", "0.2"}, {"0.3", "0.2"}, {"0.3", "0.7"}}).region());
  const Shape thirds = Shape::polygon(std::vector<Position>{{0, 0}, {1.0 / 3, 0}, {0, 1}});
  EXPECT_EQ(thirds.rounded().points, 1u);
  EXPECT_NEAR(thirds.rounded().largest, 1e-6 / 3, 1e-12);
}

TEST(PublicShape, ErrorsNameRingAndVertex) {
  std::vector<Position> bad = kSquare;
  bad[2][0] = NAN;
  EXPECT_NE(message_of([&] { Shape::polygon(bad); }).find("ring, vertex 2"), std::string::npos);
  bad[2][0] = 1e300;
  EXPECT_NE(message_of([&] { Shape::polygon(kSquare, {bad}); }).find("hole 0, vertex 2"), std::string::npos);
  const std::vector<Position> bow{{0, 0}, {10, 10}, {10, 0}, {0, 10}};
  EXPECT_NE(message_of([&] { Shape::polygon(bow); }).find("edge"), std::string::npos);
  EXPECT_NE(message_of([&] { Shape::disc({0, 0}, 0); }).find("radius"), std::string::npos);
}

TEST(PublicShape, ContoursWithArcs) {
  const double pi = std::numbers::pi;
  const Shape by_bulge = Shape::polygon(Contour({-1, 0}).bulge_to(1, {1, 0}).bulge_to(1, {-1, 0}));
  const Shape by_point = Shape::polygon(Contour({-1, 0}).arc_through({0, -1}, {1, 0}).arc_through({0, 1}, {-1, 0}));
  const Shape by_center = Shape::polygon(Contour({-1, 0}).arc_about({0, 0}, {1, 0}).arc_about({0, 0}, {-1, 0}));
  for (const Shape& s : {by_bulge, by_point, by_center}) {
    EXPECT_NEAR(*s.region().area(), pi, 1e-14);
    EXPECT_EQ(s.region(), Shape::disc({0, 0}, 1).region());
  }
  const Shape half = Shape::polygon(Contour({-1, 0}).arc_about({0, 0}, {1, 0}, false).line_to({-1, 0}));
  EXPECT_NEAR(*half.region().area(), pi / 2, 1e-14);
  EXPECT_NE(message_of([] {
              Shape::polygon(Contour({-1, 0}).arc_about({0, 0}, {2, 0}));
            }).find("edge 0"),
            std::string::npos);
}

TEST(PublicShape, GridsComeTogether) {
  const Shape coarse = Shape::box({0, 0}, {3, 3}, {"0.1"}), fine = Shape::disc({"0.25", 0}, "0.125", {"0.001"});
  const Shape both = Shape::unite({coarse, fine});
  EXPECT_EQ(both.grid().step.text(), "0.001");
  EXPECT_NEAR(*both.region().area(), 9 + std::numbers::pi * 0.125 * 0.125 / 2, 1e-12);
  const World world({{"a", coarse}, {"b", fine}}, "b");
  EXPECT_EQ(world.distance("gap(b, a)", {0, -1}).value, 0.875);
}

TEST(PublicRegion, IsWalked) {
  const Shape plate = Shape::subtract({Shape::box({0, 0}, {10, 6}), Shape::disc({5, 3}, 1)});
  const Region& region = plate.region();
  ASSERT_EQ(region.components().size(), 1u);
  const Region::Component& part = region.components()[0];
  EXPECT_NEAR(*part.area, 60 - std::numbers::pi, 1e-12);
  ASSERT_EQ(part.rings.size(), 2u);
  EXPECT_EQ(part.rings[0].size(), 4u);
  EXPECT_EQ(part.rings[1].size(), 1u);
  const Region::Edge& circle = region.edges()[part.rings[1][0].edge];
  EXPECT_TRUE(circle.arc);
  EXPECT_FALSE(circle.belongs);
  EXPECT_EQ(circle.radius, 1);
  EXPECT_EQ(circle.center, (Position{5, 3}));
  // Around the outer ring the area comes out by the shoelace formula.
  double twice = 0;
  for (const Region::Side& s : part.rings[0]) {
    const Region::Edge& e = region.edges()[s.edge];
    EXPECT_TRUE(s.forward ? e.left_belongs : e.right_belongs);
    const Position a = region.vertices()[s.forward ? e.start : e.end].at;
    const Position b = region.vertices()[s.forward ? e.end : e.start].at;
    twice += a[0] * b[1] - a[1] * b[0];
  }
  EXPECT_EQ(twice, 120);
}

TEST(PublicRegion, KeepsSlotsAndPoints) {
  // A peg of width 2 in a slot of width 2, and one that fits a hole in a single place.
  const Shape holder = Shape::subtract({Shape::box({-10, -10}, {10, 10}), Shape::interior(Shape::box({-5, -1}, {5, 1})),
                                        Shape::interior(Shape::box({-1, 4}, {1, 6}))});
  const World world({{"holder", holder}, {"peg", Shape::box({-1, -1}, {1, 1})}}, "peg");
  const Region fits = world.solve("gap(peg, holder) >= 0") & Shape::box({-9, -9}, {9, 9}).region();
  ASSERT_EQ(fits.components().size(), 2u);
  EXPECT_EQ(fits.components()[0].dimension, 1);
  ASSERT_EQ(fits.components()[0].curves.size(), 1u);
  EXPECT_EQ(fits.components()[1].dimension, 0);
  ASSERT_EQ(fits.components()[1].isolated.size(), 1u);
  const std::size_t v = fits.components()[1].isolated[0];
  EXPECT_EQ(fits.exact(v).x.text(), "0");
  EXPECT_EQ(fits.exact(v).y.text(), "5");
}

TEST(PublicRegion, ExactCoordinates) {
  const Region lens = (Shape::disc({0, 0}, 2).region() & Shape::disc({2, 0}, 2).region());
  ASSERT_EQ(lens.vertices().size(), 2u);
  EXPECT_EQ(lens.exact(0).x.text(), "1");
  EXPECT_EQ(lens.exact(1).y.text(), "sqrt(3)");
  EXPECT_TRUE(lens.exact(0).y < lens.exact(1).y);
  EXPECT_TRUE(lens.exact(0).x == lens.exact(1).x);
}

TEST(PublicShape, ManyPolygonsAreThoseMadeOneByOne) {
  std::vector<std::vector<Position>> rings;
  for (int k = 0; k < 300; ++k) rings.push_back({{0., 0.}, {k + 1., 0.}, {k + 0.1, k + 0.25}});
  std::vector<std::span<const Position>> spans(rings.begin(), rings.end());
  const std::vector<Shape> made = Shape::polygons(spans);
  ASSERT_EQ(made.size(), 300u);
  for (std::size_t k = 0; k < 300; k += 77) EXPECT_EQ(made[k].region(), Shape::polygon(rings[k]).region());
  rings[299] = {{0, 0}, {4, 4}, {4, 0}, {0, 4}};
  spans[299] = rings[299];
  EXPECT_NE(message_of([&] { return Shape::polygons(spans); }).find("polygon 299: the ring"), std::string::npos);
  EXPECT_TRUE(Shape::polygons({}).empty());
}

TEST(PublicRegion, ExactCoordinatesInFullAreReadBack) {
  const Region lens = Shape::disc({0, 0}, 2).region() & Shape::disc({2, 0}, 2).region();
  const Region grown = lens.offset("0.5") & Shape::box({-9, -9}, {9, "2.2"}).region();
  int nested = 0;
  for (std::size_t v = 0; v < grown.vertices().size(); ++v)
    for (const Exact& c : {grown.exact(v).x, grown.exact(v).y}) {
      EXPECT_EQ(Exact::read(c.full_text()), c);
      nested += c.text().starts_with('~');
    }
  EXPECT_GT(nested, 0);
  EXPECT_THROW(Exact::read("#0"), Error);
  EXPECT_THROW(Exact::read("2*"), Error);
}

TEST(PublicRegion, SetAlgebra) {
  const Region a = Shape::box({0, 0}, {4, 4}).region(), b = Shape::disc({4, 2}, 1).region();
  EXPECT_EQ((a | b) - b, a - b);
  EXPECT_EQ(a.interior().closure(), a);
  EXPECT_EQ(a.complement().complement(), a);
  EXPECT_TRUE((a & b.complement() & b).empty());
  EXPECT_NEAR(*a.offset(1).area(), 16 + 16 + std::numbers::pi, 1e-12);
  EXPECT_EQ(Shape(a - b).region(), a - b);
  EXPECT_NE(message_of([&] {
              return a | Shape::box({0, 0}, {1, 1}, {"0.1"}).region();
            }).find("grids"),
            std::string::npos);
}

TEST(PublicRegion, NearestAndSamples) {
  const Region open = Shape::interior(Shape::box({0, 0}, {4, 4})).region();
  const auto near = open.nearest(Position{7, 8});
  ASSERT_TRUE(near);
  EXPECT_EQ(near->at, (Position{4, 4}));
  EXPECT_EQ(near->distance, 5);
  EXPECT_FALSE(near->attained);
  EXPECT_TRUE(open.closure().nearest(Position{7, 8})->attained);
  EXPECT_EQ(open.nearest(Position{1, 1})->distance, 0);
  const Region ring = Shape::subtract({Shape::disc({0, 0}, 2), Shape::disc({0, 0}, 1)}).region();
  const std::vector<Position> drawn = ring.sample(2000, {.seed = 7});
  double right = 0;
  for (const Position& p : drawn) {
    EXPECT_TRUE(ring.contains(p));
    right += p[0] > 0;
  }
  EXPECT_NEAR(right, 1000, 120);
  EXPECT_EQ(drawn, ring.sample(2000, {.seed = 7}));
  EXPECT_NE(drawn, ring.sample(2000));
  Options options;
  options.cancel.request();
  EXPECT_THROW(ring.sample(1, options), Stopped);
}

TEST(PublicRegion, FlatteningStaysOnItsSide) {
  const Region ring = Shape::subtract({Shape::disc({0, 0}, 2), Shape::disc({0, 0}, 1)}).region();
  for (const auto side : {Region::Towards::kInside, Region::Towards::kOutside}) {
    const auto rings = ring.flattened(1e-3, side);
    ASSERT_EQ(rings.size(), 2u);
    const Shape flat = Shape::polygon(rings[0], {rings[1]}, {"0.00000000001"});
    const double difference = *flat.region().area() - *ring.area();
    EXPECT_EQ(difference > 0, side == Region::Towards::kOutside);
    EXPECT_LT(std::abs(difference), 1e-3 * 6 * std::numbers::pi);
  }
}

TEST(PublicQuery, ManyPositionsAgreeWithSingleOnes) {
  const Shape plate = Shape::polygon(std::vector<Position>{{25, 12}, {75, 12}, {75, 48}, {25, 48}});
  const World world({{"plate", plate},
                     {"hole", Shape::disc({50, 30}, 5)},
                     {"peg", Shape::box({-6, -4}, {6, 4})},
                     {"table", Shape::box({0, 0}, {100, 60})}},
                    "peg");
  const Query query = world.query("inside(peg, table) and clear(peg, plate, 0.5) and gap(peg, hole) <= 30");
  std::mt19937 random(3);
  std::vector<Position> positions;
  for (int k = 0; k < 3000; ++k) positions.push_back({double(random() % 1000) / 10, double(random() % 600) / 10});
  for (double x = 0; x <= 100; x += 0.5) positions.push_back({x, 7.5});  // along a boundary
  const auto answers = std::make_unique<bool[]>(positions.size());
  query.holds(positions, {answers.get(), positions.size()});
  long inside = 0;
  for (std::size_t k = 0; k < positions.size(); ++k) {
    ASSERT_EQ(answers[k], query.holds(positions[k])) << positions[k][0] << " " << positions[k][1];
    inside += answers[k];
  }
  EXPECT_GT(inside, 100);
  EXPECT_EQ(query.nearest(Position{50, 30})->at, (Position{50, 7.5}));
}

TEST(PublicQuery, NearestWhereAStrictConditionIsExactlyAtItsLevel) {
  const World room({{"A", Shape::box({-2, -2}, {2, 2})}, {"B", Shape::box({-1, -1}, {1, 1})}}, "B");
  const Position middle{0, 0};
  EXPECT_FALSE(room.query("margin(B, A) > 1").nearest(middle));  // 1 in the middle, and less elsewhere
  const auto beside = room.query("margin(B, A) < 1").nearest(middle);
  ASSERT_TRUE(beside);
  EXPECT_EQ(beside->at, middle);
  EXPECT_EQ(beside->distance, 0);
  EXPECT_FALSE(beside->attained);
  const Shape frame = Shape::subtract({Shape::box({-10, -10}, {10, 10}), Shape::box({-3, -3}, {3, 3})});
  const World ring({{"A", frame}, {"B", Shape::box({-1, -1}, {1, 1})}}, "B");
  // In the hole the gap is 2 in the middle, and less elsewhere; outside it is more than 2 where B is beyond 12.
  const auto out = ring.query("gap(B, A) > 2").nearest(middle);
  ASSERT_TRUE(out);
  EXPECT_EQ(out->distance, 13);
  EXPECT_FALSE(out->attained);
  const auto edge = ring.query("gap(B, A) > 2").nearest(Position{13, 0});
  ASSERT_TRUE(edge);
  EXPECT_EQ(edge->distance, 0);
  EXPECT_FALSE(edge->attained);
}

TEST(PublicFormula, ObjectsSayWhatTextSays) {
  const World world({{"A", Shape::box({0, 0}, {10, 10})}, {"the \"B\"", Shape::box({-1, -1}, {1, 1})}}, "the \"B\"",
                    {.unit = "mm"});
  const Formula f = gap("the \"B\"", "A") >= "0.2 cm" && !(reach("the \"B\"", "A") > 20);
  EXPECT_EQ(world.solve(f), world.solve("clear(\"the \\\"B\\\"\", A, 2) and reach(\"the \\\"B\\\"\", A) <= 20"));
  EXPECT_EQ(world.solve(gap("A", "the \"B\"").along({1, 0}) == 1),
            world.solve("gap(A, \"the \\\"B\\\"\", along=(1, 0)) = 1"));
  EXPECT_EQ(world.solve(inside("the \"B\"", "A", 1) || touches("A", "the \"B\"")).components().size(), 2u);
  EXPECT_NE(message_of([] { return gap("a", "b") >= "2 parsecs"; }).find("parsecs"), std::string::npos);
  EXPECT_NE(message_of([] { return Distance("gapp", "a", "b"); }).find("gap"), std::string::npos);
  EXPECT_NE(message_of([] { return clear("a", ""); }).find("empty"), std::string::npos);
  EXPECT_NE(message_of([&] { return world.solve(clear("a", "A")); }).find("unknown"), std::string::npos);
}

TEST(PublicSpace, ShapesAreCheckedWhereTheyAreMade) {
  EXPECT_EQ(Shape::box({0, 0, 0}, {1, 2, 3}).dimension(), 3);
  EXPECT_EQ(Shape::prism(Shape::polygon(kSquare), 0, 5).dimension(), 3);
  const std::vector<Position3> flat{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  EXPECT_NE(message_of([&] { Shape::polytope(flat); }), "nothing was thrown");
  const std::vector<std::array<std::int32_t, 3>> open{{0, 1, 2}};
  EXPECT_NE(message_of([&] { Shape::mesh(flat, open); }), "nothing was thrown");
  const std::vector<std::array<std::int32_t, 3>> wrong{{0, 1, 9}};
  EXPECT_NE(message_of([&] { Shape::mesh(flat, wrong); }).find("face 0"), std::string::npos);
  EXPECT_NE(message_of([&] { Shape::box({0, 0, 0}, {1, 1, 1}).region(); }), "nothing was thrown");
  EXPECT_NE(message_of([&] {
              Shape::unite({Shape::box({0, 0, 0}, {1, 1, 1}), Shape::box({0, 0}, {1, 1})});
            }),
            "nothing was thrown");
}

TEST(PublicSpace, GroundOverAGridOfHeights) {
  const std::vector<double> heights{1, 1, 2, 1, 3, NAN};
  const HeightField two{.heights = std::span(heights).first(4), .columns = 2, .step = {"0.5", 2}, .floor = "-0.5"};
  const Shape ground = Shape::height_field(two);
  EXPECT_EQ(ground.surface().vertices.size(), 8u);
  EXPECT_EQ(ground.rounded().points, 0u);
  const World world({{"ground", ground}, {"ball", Shape::ball({0, 2, 5}, 1)}}, "ball");
  EXPECT_EQ(world.distance("gap(ball, ground)", Point3{0, 0, 0}).value, 2);
  HeightField all{.heights = heights, .columns = 2};
  EXPECT_NE(message_of([&] { Shape::height_field(all); }).find("row 2, column 1"), std::string::npos);
  all.missing = NAN;
  EXPECT_EQ(Shape::height_field(all).surface().vertices.size(), 8u);
  all.missing = 3;
  EXPECT_NE(message_of([&] { Shape::height_field(all); }).find("finite"), std::string::npos);
  all.columns = 4;
  EXPECT_EQ(message_of([&] { Shape::height_field(all); }), "6 heights are no rows of 4 each");
  all.columns = 0;
  EXPECT_NE(message_of([&] { Shape::height_field(all); }), "nothing was thrown");
}

}  // namespace io_public_values
