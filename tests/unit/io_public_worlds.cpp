// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Worlds that change, queries, values with bounds, and limits, through the public headers alone.

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <numbers>
#include <thread>

#include "findspace/findspace.h"

namespace io_public_worlds {

using namespace findspace;
using namespace findspace::words;

World boxes() { return World({{"A", Shape::box({-4, -3}, {4, 3})}, {"B", Shape::box({-1, -1}, {1, 1})}}, "B"); }

/// A disc far from a lattice of stars, so that values are roots.
World many(int obstacles) {
  std::map<std::string, Shape> shapes{{"peg", Shape::disc({0, 0}, 1)}};
  for (int k = 0; k < obstacles; ++k) {
    std::vector<Position> ring;
    for (int i = 0; i < 40; ++i) {
      const double angle = 2 * std::numbers::pi * i / 40, r = i % 2 ? 2 : 1;
      ring.push_back({8.0 * (k % 10) + r * std::cos(angle), 8.0 * (k / 10) + r * std::sin(angle)});
    }
    shapes.emplace("s" + std::to_string(k), Shape::polygon(ring));
  }
  return World(shapes, "peg");
}

Formula clear_of_all(int obstacles) {
  Formula all = clear("peg", "s0", "0.25");
  for (int k = 1; k < obstacles; ++k) all = all && clear("peg", "s" + std::to_string(k), "0.25");
  return all;
}

TEST(PublicWorld, WordsOfBoards) {
  const World world = boxes();
  const Point at{0, 5};  // B lies from 4 to 6, A ends at 3: the gap is 1, and both are 10 wide or high at most
  EXPECT_TRUE(world.holds(near("B", "A", 1), at));
  EXPECT_FALSE(world.holds(near("B", "A", "0.999"), at));
  EXPECT_TRUE(world.holds(far("B", "A", 1), at));
  EXPECT_FALSE(world.holds(far("B", "A", "1.001"), at));
  EXPECT_TRUE(world.holds(keepout("B", "A"), at) && world.holds(keepout("B", "A", 1), at));
  EXPECT_FALSE(world.holds(keepout("B", "A", "1.001"), at));
  // The corners of A at (4, -3) and of B at (-1, 6) are the root of 106 apart, its own corners that of 100.
  EXPECT_TRUE(world.holds(group("B", "A", "10.2957"), at));
  EXPECT_FALSE(world.holds(group("B", "A", "10.2956"), at));
}

TEST(PublicWorld, GroupsOfShapes) {
  const Shape box = Shape::box({-1, -1}, {1, 1});
  const World plain({{"A", box.translated(Point{5, 0})}, {"B", box.translated(Point{9, 0})}, {"C", box}}, "C");
  const World world = plain.with(
      ShapeGroups{{{"both", {"A", "B"}}, {"none", {}}, {"movers", {"C"}}, {"smd", {"A", "C"}}}, {{"A", "C"}}});
  EXPECT_EQ(world.distance("gap(C, both)", Point{14, 0}).value, 3);
  EXPECT_EQ(world.distance("gap(C, smd)", Point{14, 0}).value, 7);  // to A: C moves
  EXPECT_TRUE(world.holds("clear(C, none, 99) and clear(C, movers, 99)", Point{0, 0}));
  EXPECT_TRUE(world.holds("clear(C, others, 4)", Point{12, 0}));
  EXPECT_FALSE(world.holds("clear(C, both, 4)", Point{12, 0}));
  EXPECT_FALSE(world.holds("between(smd, smd) >= 3.5", Point{0, 0}));
  EXPECT_EQ(world.solve("clear(C, both)"), plain.solve("clear(C, A) and clear(C, B)"));
  EXPECT_EQ(world.groups().groups.size(), 4u);
  EXPECT_EQ(world.groups().all, (std::vector<std::string>{"A", "C"}));
  EXPECT_TRUE(plain.groups().groups.empty());
  EXPECT_THROW(plain.with(ShapeGroups{{{"both", {"A", "D"}}}}), Error);
}

TEST(PublicWorld, ChangesAndItsCopiesDoNot) {
  World world = boxes();
  const World before = world;
  const Query query = world.query("gap(B, A) >= 1");
  world.move("A", Point{10, 0});
  EXPECT_EQ(*world.distance("gap(B, A)", {0, 0}).value, 5);
  EXPECT_EQ(*before.distance("gap(B, A)", {0, 0}).value, -4);
  EXPECT_FALSE(query.holds(Point{0, 0}));
  EXPECT_TRUE(world.query("gap(B, A) >= 1").holds(Point{0, 0}));
  world.set("C", Shape::disc({0, 0}, 2));
  EXPECT_EQ(*world.distance(gap("B", "C"), {5, 0}).value, 2);
  world.set("B", Shape::box({-2, -1}, {2, 1}));
  EXPECT_EQ(*world.distance(gap("B", "C"), {5, 0}).value, 1);
  world.remove("C");
  EXPECT_THROW(world.distance("gap(B, C)", Point{5, 0}), Error);
  EXPECT_THROW(world.remove("C"), Error);
  EXPECT_THROW(world.remove("B"), Error);
  EXPECT_THROW(world.set("D", Shape::box({0, 0, 0}, {1, 1, 1})), Error);
}

TEST(PublicWorld, ChangedIsAsMadeAnew) {
  World changed({{"A", Shape::box({-4, -3}, {4, 3})}, {"B", Shape::disc({0, 0}, 1)}, {"C", Shape::disc({9, 0}, 2)}},
                "B");
  const Formula f = gap("B", "A") >= "0.5" && gap("B", "C") >= 1 && reach("B", "A + C") <= 20;
  changed.solve(f);
  EXPECT_EQ(changed.minimize("reach(B, A)").value, changed.minimize("reach(B, A)").value);
  changed.set("A", Shape::box({-4, -3}, {3, 3}));
  const World anew({{"A", Shape::box({-4, -3}, {3, 3})}, {"B", Shape::disc({0, 0}, 1)}, {"C", Shape::disc({9, 0}, 2)}},
                   "B");
  EXPECT_EQ(changed.solve(f), anew.solve(f));
  EXPECT_EQ(changed.minimize("reach(B, A)").value, anew.minimize("reach(B, A)").value);
  // A finer grid makes all of it anew.
  changed.set("C", Shape::disc({"9.00000005", 0}, 2, {"0.00000001"}));
  EXPECT_EQ(*changed.distance("gap(B, C)", {0, 0}).value, 6.00000005);
}

TEST(PublicWorld, ValuesHaveBounds) {
  const DistanceValue root = boxes().distance("gap(B, A)", {6, 5});  // corners (5, 4) and (4, 3)
  EXPECT_TRUE(root.exact);
  EXPECT_EQ(root.closed_form, "sqrt(2)");
  EXPECT_LE(root.lower, std::sqrt(2));
  EXPECT_GE(root.upper, std::sqrt(2));
  EXPECT_LE(root.upper - root.lower, 4e-16);
  ASSERT_EQ(root.features.size(), 2u);
  EXPECT_EQ(root.features[0].shape, "B");
  ASSERT_EQ(root.points.size(), 2u);
  EXPECT_EQ(root.points[1], (Place{4, 3}));
  const DistanceValue whole = boxes().distance("gap(B, A)", {6, 0});
  EXPECT_EQ(whole.lower, 1);
  EXPECT_EQ(whole.upper, 1);
  EXPECT_EQ(boxes().distance("cover(B, A)", {0, 0}).value, -INFINITY);
}

TEST(PublicWorld, TheLeastBetweenBoundsIsEnclosed) {
  // |p - C| - |p - A| >= 2: a branch of a hyperbola, whose vertex is (1, 0).
  const World world({{"A", Shape::disc({6, 0}, 1)},
                     {"C", Shape::disc({-6, 0}, 3)},
                     {"B", Shape::points({{0, 0}})},
                     {"W", Shape::box({-20, -20}, {20, 20})}},
                    "B");
  const Formula nearer = "inside(B, W) and gap(B, A) <= gap(B, C)";
  EXPECT_THROW(world.solve(nearer), Error);
  const Optimum best = world.minimize("x", nearer);
  ASSERT_TRUE(best.value);
  EXPECT_FALSE(best.exact);
  EXPECT_EQ(best.side, "inner");
  EXPECT_LE(best.lower, 1);
  EXPECT_GE(best.upper, 1);
  EXPECT_LT(best.upper - best.lower, 0.1);
  EXPECT_FALSE(best.at.empty());
}

TEST(PublicWorld, ChecksAtomByAtom) {
  const Check check = boxes().check("gap(B, A) >= 1.5 or touches(B, A)", {6, 0});
  EXPECT_FALSE(check.holds);
  ASSERT_EQ(check.atoms.size(), 2u);
  EXPECT_EQ(check.atoms[0].text, "gap(B, A) >= 1.5");
  EXPECT_EQ(check.atoms[0].lacks, 0.5);
  EXPECT_EQ(check.atoms[1].distance.value, 1);
}

TEST(PublicWorld, AtomsHaveTheValueOfTheirWord) {
  const Check check = boxes().check("margin(B, A) >= -3 and eta1(B, A) <= 3 and inside(B, A)", {1, 0});
  ASSERT_EQ(check.atoms.size(), 3u);
  EXPECT_EQ(check.atoms[0].distance.value, boxes().distance("margin(B, A)", {1, 0}).value);
  EXPECT_EQ(check.atoms[0].distance.value, -*check.atoms[1].distance.value);
  EXPECT_EQ(check.atoms[2].distance.value, check.atoms[0].distance.value);
}

TEST(PublicWorld, AtomsOfWhatFitsNowhereAreMinusInfinity) {
  const Check check = boxes().check("cover(B, A) >= -3 or delta1(B, A) <= 3", {0, 0});
  ASSERT_EQ(check.atoms.size(), 2u);
  EXPECT_EQ(check.atoms[0].distance.value, -INFINITY);
  EXPECT_EQ(check.atoms[0].distance.value, boxes().distance("cover(B, A)", {0, 0}).value);
  EXPECT_FALSE(check.atoms[1].distance.value);
  EXPECT_FALSE(check.holds);
}

TEST(PublicQuery, ValuesOfManyPositions) {
  const World world = boxes();
  const std::vector<Position> at{{6, 0}, {6, 5}, {0, 0}, {0, -8}};
  std::vector<double> gaps(at.size()), margins(at.size()), covers(at.size());
  world.query("gap(B, A)").values(at, gaps);
  world.query(margin("B", "A")).values(at, margins);
  world.query("cover(B, A)").values(at, covers);
  EXPECT_EQ(gaps, (std::vector<double>{1, std::sqrt(2), -4, 4}));
  for (std::size_t k = 0; k < at.size(); ++k) {
    EXPECT_EQ(margins[k], world.distance("margin(B, A)", {at[k][0], at[k][1]}).value);
    EXPECT_EQ(covers[k], -INFINITY);
  }
  std::vector<double> few(2);
  EXPECT_THROW(world.query("gap(B, A)").values(at, few), Error);
  EXPECT_THROW(world.query("gap(B, A) > 0").values(at, gaps), Error);
  EXPECT_THROW(world.query("gap(B, A)").holds(Point{0, 0}), Error);
  EXPECT_THROW(world.query("x").value(Point{0, 0}), Error);
}

TEST(PublicQuery, IsAskedFromManyThreads) {
  const World world = many(12);
  const Query query = world.query(clear_of_all(12));
  std::vector<Position> at;
  for (int k = 0; k < 400; ++k) at.push_back({k % 40 * 2.0, k / 40 * 1.7});
  std::vector<char> expected;
  for (const Position& p : at) expected.push_back(world.holds(query.text(), {p[0], p[1]}));
  std::atomic<int> wrong = 0;
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([&] {
      const auto answers = std::make_unique<bool[]>(at.size());
      query.holds(at, {answers.get(), at.size()});
      for (std::size_t k = 0; k < at.size(); ++k) wrong += bool(expected[k]) != answers[k];
    });
  for (std::thread& t : threads) t.join();
  EXPECT_EQ(wrong, 0);
}

TEST(PublicLimits, EndAQuestionAndSayWhich) {
  const World world = many(60);
  const auto limit = [&](const Options& options) -> std::optional<Limit> {
    try {
      world.with(options).solve(clear_of_all(60));
    } catch (const Stopped& e) {
      return e.limit();
    }
    return std::nullopt;
  };
  EXPECT_EQ(limit({.seconds = 1e-9}), Limit::kTime);
  EXPECT_EQ(limit({.memory = 1}), Limit::kMemory);
  const Cancel cancel;
  cancel.request();
  EXPECT_EQ(limit({.cancel = cancel}), Limit::kCancelled);
  cancel.reset();
  EXPECT_EQ(limit({.threads = 1, .seconds = 1000, .memory = std::size_t(1) << 40, .cancel = cancel}), std::nullopt);
  const CancelScope scope(cancel);
  cancel.request();
  EXPECT_EQ(limit({}), Limit::kCancelled);
}

TEST(PublicLimits, OneAnswerForAnyNumberOfThreads) {
  const World world = many(20);
  EXPECT_EQ(world.with({.threads = 1}).solve(clear_of_all(20)).exact_json(),
            world.with({.threads = 2}).solve(clear_of_all(20)).exact_json());
}

/// A search in space may look at more, or at less; limits that say nothing of it keep what was said before.
TEST(PublicLimits, WorkOfSearchesIsRaised) {
  const Shape bowl = Shape::subtract({Shape::ball({0, 0, 0}, 5), Shape::ball({0, 0, 2}, 3)});
  const World world({{"A", bowl}, {"B", Shape::box({0, 0, 0}, {2, 2, 2})}}, "B");
  const auto width = [](const World& asked) {
    const DistanceValue v = asked.distance("protrusion(A, B)", {1, 1, 1});
    return v.upper - v.lower;
  };
  EXPECT_GT(width(world.with({.work_limit = 1000})), 0.1);
  EXPECT_GT(width(world.with({.work_limit = 1000}).with({.threads = 1})), 0.1);
  EXPECT_LT(width(world), 1e-6);
  EXPECT_LT(width(world.with({.work_limit = 1000}).with({.work_limit = kUsualWork})), 1e-6);
  const Scene scene = Scene::json(R"({"findspace": 1, "shapes": {"B": {"box": {"min": [0, 0, 0], "max": [2, 2, 2]}},
    "A": {"difference": [{"ball": {"center": [0, 0, 0], "radius": 5}}, {"ball": {"center": [0, 0, 2], "radius": 3}}]}},
    "moving": "B"})",
                                  ".", {.work_limit = 2000});
  EXPECT_GT(width(scene.world()), 0.1);
  EXPECT_LT(width(scene.world().with({.work_limit = kUsualWork})), 1e-6);
}

TEST(PublicLimits, ProgressGrows) {
  double last = 0;
  int calls = 0;
  const World world = boxes().with({.progress = [&](double part) {
    EXPECT_GT(part, last);
    last = part;
    ++calls;
  }});
  const std::vector<Position> at(1000, Position{6, 5});
  std::vector<double> out(at.size());
  world.query("gap(B, A)").values(at, out);
  EXPECT_EQ(last, 1);
  EXPECT_GT(calls, 3);
}

World solids() {
  return World({{"room", Shape::box({0, 0, 0}, {10, 10, 10})},
                {"ball", Shape::ball({5, 5, 5}, 1)},
                {"crate", Shape::box({-1, -1, -1}, {1, 1, 1})}},
               "crate", {.unit = "mm"});
}

TEST(PublicSpace, IsAsked) {
  const World world = solids();
  EXPECT_EQ(world.dimension(), 3);
  EXPECT_EQ(*world.distance("gap(crate, ball)", {5, 5, 9}).value, 2);
  EXPECT_EQ(*world.distance("margin(crate, room)", {5, 5, 8}).value, 1);
  const DistanceValue slanted = world.distance(gap("crate", "ball"), {8, 8, 5});
  EXPECT_EQ(slanted.closed_form, "-1+2*sqrt(2)");
  const Formula f = inside("crate", "room") && clear("crate", "ball", "2 mm");
  EXPECT_TRUE(world.holds(f, {5, 5, 9}));
  EXPECT_FALSE(world.holds(f, {5, 5, "8.999999"}));
  EXPECT_EQ(world.check(f, {5, 5, 8}).atoms[1].lacks, 1);
  EXPECT_THROW(world.holds(f, {5, 5}), Error);
  EXPECT_THROW(world.solve(f), Error);
}

TEST(PublicSpace, ManyPositionsAndLines) {
  World world = solids();
  const std::vector<Position3> at{{5, 5, 9}, {5, 5, 8.5}, {1, 1, 1}};
  const auto answers = std::make_unique<bool[]>(3);
  world.query("inside(crate, room) and clear(crate, ball, 2)").holds(at, {answers.get(), 3});
  EXPECT_TRUE(answers[0] && !answers[1] && answers[2]);
  std::vector<double> gaps(3);
  world.query("gap(crate, ball)").values(at, gaps);
  EXPECT_EQ(gaps[1], 1.5);
  const OnLine line = world.on_line("inside(crate, room) and disjoint(crate, ball)", {5, 5, 0}, {0, 0, 1});
  ASSERT_EQ(line.intervals.size(), 2u);
  EXPECT_TRUE(line.exact);
  EXPECT_EQ(line.intervals[0].from, 1);
  EXPECT_EQ(line.intervals[0].to, 3);
  EXPECT_TRUE(line.intervals[0].from_belongs);
  EXPECT_FALSE(line.intervals[0].to_belongs);
  const auto nearest = world.query("inside(crate, room)").nearest(Position3{0, 5, 12});
  ASSERT_TRUE(nearest);
  EXPECT_EQ(nearest->at, (Position3{1, 5, 9}));
  EXPECT_FALSE(world.query("inside(crate, room, 6)").nearest(Position3{0, 5, 12}));  // feasible nowhere
  try {
    // It is feasible, far out.
    (void)world.query("clear(crate, room, 1) or gap(crate, room) = 0.5").nearest(Position3{0, 5, 5});
    FAIL() << "an answer";
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ErrorCode::kUnsupported);
  }
  world.move("ball", Point3{0, 0, 1});
  EXPECT_EQ(*world.distance("gap(crate, ball)", {5, 5, 9}).value, 1);
  EXPECT_EQ(*world.distance("margin(crate, room)", {5, 5, 8}).value, 1);
}

TEST(PublicSurface, IsAFileAndAScene) {
  const Shape crate = Shape::box({0, 0, 0}, {1, 2, 3});
  const Surface surface = crate.surface();
  EXPECT_TRUE(surface.lost.empty());
  for (const std::string& ending : Surface::endings()) EXPECT_FALSE(surface.text(ending, "mm", "crate").empty());
  EXPECT_NE(surface.text(".3mf", "mm", "crate").find("PK"), std::string::npos);
  EXPECT_NE(surface.text(".svg", "mm", "a crate").find("a crate"), std::string::npos);
  EXPECT_THROW(surface.text(".doc"), Error);
  const Scene again = Scene::json(surface.scene_json("crate", "mm"));
  EXPECT_EQ(again.unit(), "mm");
  EXPECT_EQ(again.shapes().at("crate").surface().vertices.size(), 8u);
  const Shape sheet =
      Shape::unite({crate, Shape::intersect({Shape::box({5, 0, 0}, {6, 2, 3}), Shape::box({6, 0, 0}, {7, 2, 3})})});
  EXPECT_NE(sheet.surface().lost.find("sheets"), std::string::npos);
  EXPECT_EQ(sheet.surface().faces.size(), 6u);
}

TEST(PublicSpace, RegionsOfBoxesAndPolytopes) {
  const World world = solids();
  const SpaceRegion free = world.solve_space("inside(crate, room, 1)");
  EXPECT_EQ(free.form(), SpaceRegion::Form::kBoxes);
  EXPECT_EQ(*free.volume(), 216);
  EXPECT_EQ(free.bounds()->low, (Position3{2, 2, 2}));
  EXPECT_TRUE(free.closed());
  EXPECT_TRUE(free.contains({2, 2, 2}));
  EXPECT_FALSE(free.contains({"1.999999", 2, 2}));
  ASSERT_EQ(free.boxes().size(), 1u);
  EXPECT_TRUE(free.boxes()[0].low_belongs[0]);
  EXPECT_EQ(free.surface().faces.size(), 6u);
  EXPECT_EQ(free.surface().vertices.size(), 8u);
  EXPECT_NE(free.json().find("216"), std::string::npos);
  const std::vector<Position3> tip{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}};
  const World tips({{"A", Shape::polytope(tip)}, {"B", Shape::polytope(tip)}}, "B");
  const SpaceRegion meets = tips.solve_space("gap(B, A) <= 0");
  EXPECT_EQ(meets.form(), SpaceRegion::Form::kConvex);
  EXPECT_EQ(meets.surface().faces.size(), 14u);
  EXPECT_THROW(world.solve_space("clear(crate, ball) and inside(crate, room)"), Error);
}

TEST(PublicSpace, ShapesAsTextComeBack) {
  const Shape part = Shape::subtract({Shape::box({0, 0, 0}, {4, 4, 4}), Shape::interior(Shape::ball({2, 2, 2}, "1.5"))})
                         .translated(Point3{"0.25", 0, 1});
  const Shape again = Shape::json(part.exact_json(), part.grid());
  EXPECT_EQ(again.exact_json(), part.exact_json());
  const Shape dot = Shape::box({-1, -1, -1}, {1, 1, 1});
  const World a({{"A", part}, {"B", dot}}, "B"), b({{"A", again}, {"B", dot}}, "B");
  for (int k = 0; k < 5; ++k)
    EXPECT_EQ(a.holds("overlaps(B, A)", {2 + k, 2, 3}), b.holds("overlaps(B, A)", {2 + k, 2, 3}));
}

TEST(PublicWorld, Rotates) {
  // A bar along x above which a point of A stands: it meets it at a quarter turn alone.
  const World world({{"A", Shape::points({{0, 4}})}, {"B", Shape::polyline({{0, 0}, {5, 0}})}}, "B");
  const auto touching = world.angles("gap(B, A) <= 0", {0, 0});
  ASSERT_EQ(touching.size(), 1u);
  EXPECT_EQ(touching[0].from, 90);
  EXPECT_EQ(touching[0].to, 90);
  const auto clear_of_it = world.angles("gap(B, A) > 0", {0, 0});
  ASSERT_EQ(clear_of_it.size(), 1u);
  EXPECT_EQ(*clear_of_it[0].to - *clear_of_it[0].from, 360);
  EXPECT_FALSE(clear_of_it[0].from_belongs);
  EXPECT_TRUE(world.check_rotated("touches(B, A)", {0, 0}, 90).holds);
  EXPECT_EQ(*world.check_rotated("touches(B, A)", {0, 0}, 180).atoms[0].distance.value, 4);
}

TEST(PublicPhi, OfThePlane) {
  const Phi phi(Shape::box({0, 0}, {4, 2}), Shape::disc({0, 0}, 1));
  const Phi::Value beside = phi.at(Point{7, 1});
  EXPECT_EQ(beside.value, 2);
  EXPECT_EQ(beside.state, Phi::State::kApart);
  EXPECT_EQ(beside.gradient, (Place{1, 0}));
  EXPECT_EQ(phi.at(Point{5, 1}).state, Phi::State::kContact);
  EXPECT_EQ(phi.at(Point{4, 1}).value, -1);
  EXPECT_EQ(phi.compare({7, 1}, 2), 0);
  EXPECT_EQ(phi.compare({7, 1}, "2.0000001"), -1);
  EXPECT_THROW(phi.compare({7, 1}, -1), Error);
  EXPECT_THROW(phi.at(Point3{0, 0, 0}), Error);
  const std::vector<Position> at{{7, 1}, {5, 1}, {2, 7}};
  std::vector<double> values(3);
  std::vector<Position> gradients(3);
  phi.evaluate(at, values, gradients);
  EXPECT_EQ(values, (std::vector<double>{2, 0, 4}));
  EXPECT_EQ(gradients[2], (Position{0, 1}));
}

TEST(PublicPhi, AsText) {
  PhiQuestion question{.a = "plate", .b = "peg", .at = {7, 1}, .least = 2};
  const Phi parts(Shape::box({0, 0}, {4, 2}), Shape::disc({0, 0}, 1));
  EXPECT_EQ(parts.text(".txt", question).rfind("Phi-function of plate and peg", 0), 0u);
  EXPECT_NE(parts.text(".json", question).find("\"adjusted\""), std::string::npos);
  EXPECT_EQ(parts.text(".json").find("\"at\""), std::string::npos);
  EXPECT_NE(parts.text(".svg", question).find("<svg"), std::string::npos);
  EXPECT_THROW(parts.text(".obj"), Error);
  const Phi curves(Shape::intersect({Shape::disc({0, 0}, 2), Shape::box({0, 0}, {4, 2})}), Shape::disc({0, 0}, 1));
  ASSERT_EQ(curves.form(), Phi::Form::kCurves);
  EXPECT_NE(curves.text(".json", question).find("\"form\":\"curves\""), std::string::npos);
  EXPECT_NE(curves.text(".txt", question).find("at (7, 1): "), std::string::npos);
  const Phi solids(Shape::box({0, 0, 0}, {1, 1, 1}), Shape::box({0, 0, 0}, {2, 1, 1}));
  EXPECT_THROW(solids.text(".json", question), Error);  // two coordinates
  question.at = {0, 0, 3};
  EXPECT_NE(solids.text(".json", question).find("\"at\""), std::string::npos);
  EXPECT_NE(solids.text(".obj").find("v "), std::string::npos);
  question.at = {};
  EXPECT_THROW(solids.text(".json", question), Error);  // a limit without a position
  EXPECT_EQ(solids.rounded_of_a().points, 0u);
}

TEST(PublicNumber, IsComparedByItsValue) {
  EXPECT_EQ(Number("1.50"), Number(1.5));
  EXPECT_LT(Number("17/3"), Number("5.7"));
  EXPECT_GT(Number("0.30000000000000000000000000000000000001"), Number(0.3));
  EXPECT_EQ(Number("17/4").value(), 4.25);
  EXPECT_THROW(Number("x").value(), Error);
  EXPECT_THROW(Number("1/0").value(), Error);
}

TEST(PublicPhi, AdjustedForLimitsOfTheDistance) {
  const Phi phi(Shape::box({0, 0}, {4, 2}), Shape::box({0, 0}, {1, 1}));
  const Phi::Value corner = phi.at(Point{7, 6});  // (3, 4) beyond the corner of the contacts
  EXPECT_EQ(corner.value, 4);
  EXPECT_EQ(corner.gradient, (Place{0, 1}));
  EXPECT_EQ(corner.normalised, 5);
  EXPECT_EQ(corner.normalised_gradient, (Place{0.6, 0.8}));
  const AdjustedPhi least = phi.at_least(5), greatest = phi.at_most("4.5");
  EXPECT_EQ(least.at(Point{7, 6}).sign, 0);
  EXPECT_EQ(least.at(Point{7, "6.0000001"}).sign, 1);
  EXPECT_EQ(greatest.at(Point{7, 6}).value, -0.5);
  EXPECT_EQ(greatest.at(Point{7, 6}).sign, -1);
  EXPECT_EQ(greatest.at(Point{7, 6}).gradient, (Place{-0.6, -0.8}));
  EXPECT_EQ(greatest.at(Point{0, 0}).sign, 1);  // overlap is near
  EXPECT_EQ(phi.at_least(0).at(Point{4, 0}).sign, 0);
  EXPECT_EQ(phi.at_most(0).at(Point{4, 0}).sign, 0);
  EXPECT_THROW(phi.at_least(-1), Error);
  const std::vector<Position> at{{7, 6}, {2, 7}};
  std::vector<double> values(2);
  std::vector<Position> gradients(2);
  least.evaluate(at, values, gradients);
  EXPECT_EQ(values, (std::vector<double>{0, 0}));
  EXPECT_EQ(gradients, (std::vector<Position>{{0.6, 0.8}, {0, 1}}));
}

TEST(PublicPhi, TheNearestPairHasTheNormalisedGradient) {
  const Shape b = Shape::box({0, 0}, {1, 1});
  const Phi phi(Shape::unite({Shape::box({0, 0}, {1, 1}), Shape::box({-9, 9}, {9, 10})}), b);
  const Phi::Value found = phi.at(Point{4, 4});  // 3 beyond the corner each way; 4 below the bar
  EXPECT_EQ(found.pair, 0u);
  EXPECT_EQ(found.value, 3);
  EXPECT_EQ(found.normalised, 4);
  EXPECT_EQ(found.normalised_gradient, (Place{0, -1}));
}

TEST(PublicPhi, AdjustedInSpace) {
  const Phi phi(Shape::box({0, 0, 0}, {1, 1, 1}), Shape::box({0, 0, 0}, {1, 1, 1}));
  const AdjustedPhi least = phi.at_least(2), greatest = phi.at_most(3);
  EXPECT_EQ(least.at(Point3{2, 3, 3}).sign, 1);
  EXPECT_EQ(greatest.at(Point3{2, 3, 3}).sign, 0);  // 1, 2, 2 apart
  const Place steep = least.at(Point3{2, 3, 3}).gradient;
  const AdjustedPhi far = phi.at_least(5), near = phi.at_most(5);
  const Point3 corner{4, 5, 0};  // gaps 3 and 4
  EXPECT_EQ(far.at(corner).sign, 0);
  EXPECT_EQ(near.at(corner).sign, 0);
  EXPECT_EQ(far.at(corner).value, 0);
  EXPECT_EQ(far.at(Point3{5, 5, 0}).sign, 1);
  EXPECT_EQ(near.at(Point3{5, 5, 0}).sign, -1);
  EXPECT_EQ(far.at(Point3{0, 0, 0}).sign, -1);
  EXPECT_EQ(near.at(Point3{0, 0, 0}).sign, 1);
  EXPECT_THROW(phi.at_least(-1), Error);
  ASSERT_EQ(steep.size(), 3u);
  EXPECT_NEAR(steep[0], 1 / 3., 1e-15);
  EXPECT_NEAR(steep[2], 2 / 3., 1e-15);
}

TEST(PublicPhi, OfArcsThatBoundNoDiscByCurves) {
  const Shape half = Shape::subtract({Shape::disc({0, 0}, 2), Shape::box({-3, -3}, {3, 0})});
  const Shape box = Shape::box({0, 0}, {1, 1});
  const Phi phi(half, box);
  EXPECT_EQ(phi.form(), Phi::Form::kCurves);
  EXPECT_EQ(phi.parts_of_a(), 0u);
  const Phi::Value above = phi.at(Point{"-0.5", 3});
  EXPECT_EQ(above.value, 1);
  EXPECT_EQ(above.state, Phi::State::kApart);
  EXPECT_EQ(above.gradient, (Place{0, 1}));
  EXPECT_TRUE(above.active.empty());
  EXPECT_EQ(phi.at(Point{"-0.5", 2}).state, Phi::State::kContact);
  EXPECT_EQ(phi.at(Point{"-0.5", 2}).gradient, (Place{0, 0}));
  const Phi::Value within = phi.at(Point{"-0.5", 0});
  EXPECT_EQ(within.value, -1);
  EXPECT_EQ(within.state, Phi::State::kOverlap);
  EXPECT_EQ(within.gradient, (Place{0, -1}));
  EXPECT_EQ(phi.compare({"-0.5", 3}, 1), 0);
  EXPECT_EQ(phi.compare({"-0.5", 3}, "1.0000001"), -1);
  const World world({{"A", half}, {"B", box}}, "B");
  for (int x = -3; x < 4; ++x)
    for (int y = -3; y < 4; ++y) EXPECT_EQ(phi.at(Point{x, y}).value, *world.distance("gap(B, A)", Point{x, y}).value);
  EXPECT_EQ(Phi(box, box).form(), Phi::Form::kParts);
}

TEST(PublicPhi, OfSpaceAgreesWithGap) {
  const Shape a = Shape::unite({Shape::box({0, 0, 0}, {2, 2, 2}), Shape::box({2, 0, 0}, {4, 1, 1})});
  const Shape b = Shape::box({0, 0, 0}, {1, 1, 1});
  const Phi phi(a, b);
  EXPECT_EQ(phi.dimension(), 3);
  EXPECT_EQ(phi.parts_of_b(), 1u);
  const World world({{"A", a}, {"B", b}}, "B");
  for (int x = -3; x < 7; ++x)
    for (int y = -3; y < 5; ++y) {
      const double gap = *world.distance("gap(B, A)", Point3{x, y, 1}).value,
                   value = phi.at(Point3{x, y, 1}).normalised;
      EXPECT_EQ(gap > 0, value > 0);
      EXPECT_EQ(gap < 0, value < 0);
      if (gap > 0) {
        EXPECT_NEAR(gap, value, 1e-12);
      }
    }
}

}  // namespace io_public_worlds
