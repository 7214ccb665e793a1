// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Maps of scenes of space as public values: regions of boxes and of convex sets, what is made of them, and pictures.
#include <findspace/findspace.h>
#include <gtest/gtest.h>

namespace findspace {
namespace {

using Found = Answer::Found;

Scene crate_scene(const std::string& more = "", const std::string& where = "inside(crate, room)") {
  return Scene::json(R"json({"findspace": 1, "unit": "mm", "shapes": {"room": {"box": {"min": [0, 0, 0],
    "max": [9, 9, 9]}}, "crate": {"box": {"min": [0, 0, 0], "max": [2, 1, 1]}}}, "moving": "crate",
    "where": ")json" +
                     where + "\"" + more + "}");
}

/// A ball beside a tetrahedron with a corner at the origin.
Scene ball_scene(const std::string& where) {
  return Scene::json(R"json({"findspace": 1, "shapes": {"rock": {"polytope": [[0, 0, 0], [9, 0, 0], [0, 9, 0],
    [0, 0, 9]]}, "ball": {"ball": {"center": [0, 0, 0], "radius": 1}}}, "moving": "ball", "where": ")json" +
                     where + "\"}");
}

ErrorCode code_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const Error& e) {
    return e.code();
  }
  ADD_FAILURE() << "no error";
  return ErrorCode::kUsage;
}

TEST(PublicSpaceMaps, HaveTheRegionOfBoxes) {
  const Answer answer = crate_scene().map();
  EXPECT_EQ(answer.found(), Found::kYes);
  EXPECT_FALSE(answer.region().has_value());
  EXPECT_FALSE(answer.best().has_value());
  const SpaceRegion region = *answer.space_region();
  EXPECT_EQ(region.form(), SpaceRegion::Form::kBoxes);
  EXPECT_EQ(*region.volume(), 7 * 8 * 8);
  EXPECT_TRUE(region.contains(Point3{7, 8, 8}));
  EXPECT_FALSE(region.contains(Point3{"7.000001", 8, 8}));
  EXPECT_EQ(region.query().text(), "inside(crate, room)");
  EXPECT_EQ(answer.json(), region.json());
  EXPECT_NE(answer.text().find("volume  448 mm³"), std::string::npos);
  EXPECT_EQ(answer.endings().size(), 9u);  // JSON and the surfaces
  EXPECT_NE(answer.file(".svg").text.find("Positions of crate"), std::string::npos);
  EXPECT_NE(answer.file(".obj").text.find("v 7 8 8"), std::string::npos);
}

TEST(PublicSpaceMaps, AreMadeIntoWhatIsAskedFor) {
  const Scene scene = crate_scene();
  const SpaceRegion open = *scene.map({.apply = "interior"}).space_region();
  EXPECT_TRUE(open.open());
  EXPECT_FALSE(open.contains(Point3{7, 8, 8}));
  EXPECT_TRUE(open.contains(Point3{"6.9", 7, 7}));
  EXPECT_EQ(open.question().apply, "interior");
  const SpaceRegion rest = *scene.map({.apply = "complement"}).space_region();
  EXPECT_FALSE(rest.bounded());
  EXPECT_TRUE(rest.contains(Point3{-1, 0, 0}));
  EXPECT_EQ(scene.map({.apply = "boundary"}).space_region()->volume(), 0);
  EXPECT_EQ(scene.world().solve_space(scene.where(), {"boundary"}).boxes().size(),
            scene.map({.apply = "boundary"}).space_region()->boxes().size());
  EXPECT_EQ(code_of([&] { scene.map({.apply = "inner"}); }), ErrorCode::kBadValue);
}

TEST(PublicSpaceMaps, HaveTheBestPositions) {
  const Answer answer = crate_scene(R"(, "maximize": "z")").map();
  EXPECT_EQ(*answer.best()->value, 8);
  EXPECT_TRUE(answer.best()->at.empty());
  const SpaceRegion top = *answer.space_region();
  EXPECT_EQ(*top.volume(), 0);
  EXPECT_TRUE(top.contains(Point3{3, 3, 8}));
  EXPECT_FALSE(top.contains(Point3{3, 3, 7}));
  const World world = crate_scene().world();
  EXPECT_TRUE(
      world.solve_space("inside(crate, room)", {.minimize = "distance to [20, 4, 4]"}).contains(Point3{7, 4, 4}));
  EXPECT_EQ(code_of([&] { world.solve_space("inside(crate, room)", {{}, "x", "y"}); }), ErrorCode::kBadValue);
  EXPECT_EQ(code_of([&] {
              world.solve_space("inside(crate, room)", {{}, "gap(crate, room)"});
            }),
            ErrorCode::kUnsupported);
}

TEST(PublicSpaceMaps, SayThatNothingIsFound) {
  const Answer none = crate_scene("", "inside(room, crate)").map();
  EXPECT_EQ(none.found(), Found::kNo);
  EXPECT_TRUE(none.space_region()->empty());
  EXPECT_FALSE(none.space_region()->contains(Point3{0, 0, 0}));
}

TEST(PublicSpaceMaps, AreConvexAndRound) {
  const Answer answer = ball_scene("gap(ball, rock) <= 1").map();
  const SpaceRegion region = *answer.space_region();
  EXPECT_EQ(region.form(), SpaceRegion::Form::kConvex);
  const auto both = [&](const Point3& p) {
    EXPECT_EQ(region.contains(p), region.query().holds(p));
    return region.contains(p);
  };
  EXPECT_TRUE(both({-2, 0, 0}));  // gap 1, beside a corner
  EXPECT_FALSE(both({"-2.000001", 0, 0}));
  EXPECT_TRUE(both({"-1.2", "-1.2", "-1"}));
  EXPECT_FALSE(both({"-1.2", "-1.2", "-1.2"}));
  EXPECT_TRUE(both({1, 1, 1}));
  const SpaceRegion skin = *ball_scene("gap(ball, rock) <= 1").map({.apply = "boundary"}).space_region();
  EXPECT_TRUE(skin.contains(Point3{-2, 0, 0}));
  EXPECT_FALSE(skin.contains(Point3{"-1.9", 0, 0}));
  EXPECT_FALSE(skin.contains(Point3{1, 1, 1}));
  const bool out = ball_scene("gap(ball, rock) > 1").map().space_region()->contains(Point3{-2, 0, 0});
  EXPECT_FALSE(out);
  EXPECT_EQ(code_of([&] { ball_scene("gap(ball, rock) <= 1").map({.surface = true}); }), ErrorCode::kUnsupported);
}

TEST(PublicSpaceMaps, AreConvexAndFlat) {
  const Scene scene = Scene::json(R"json({"findspace": 1, "shapes": {"hole": {"polytope": [[0, 0, 0], [6, 0, 0],
    [0, 6, 0], [0, 0, 6]]}, "plug": {"polytope": [[0, 0, 0], [6, 0, 0], [0, 6, 0], [0, 0, 6]]}}, "moving": "plug",
    "where": "inside(plug, hole)"})json");
  const SpaceRegion region = *scene.map().space_region();  // an exact fit
  EXPECT_EQ(region.form(), SpaceRegion::Form::kConvex);
  EXPECT_TRUE(region.contains(Point3{0, 0, 0}));
  EXPECT_FALSE(region.contains(Point3{"0.000001", 0, 0}));
  const Position3 at[2]{{0, 0, 0}, {1, 0, 0}};
  bool inside[2]{};
  region.contains(at, inside);
  EXPECT_TRUE(inside[0]);
  EXPECT_FALSE(inside[1]);
}

TEST(PublicSpaceMaps, OfSeveralOrientationsAreAskedOneByOne) {
  const Scene scene = crate_scene(R"(, "free": "pose", "angles": [{"axis": "z", "degrees": 90}])");
  EXPECT_EQ(code_of([&] { scene.map(); }), ErrorCode::kUnsupported);
  EXPECT_EQ(*scene.rotated(scene.free().rotations[0]).map().space_region()->volume(), 8 * 7 * 8);
}

}  // namespace
}  // namespace findspace
