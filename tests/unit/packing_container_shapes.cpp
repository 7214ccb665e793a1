// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Containers that are no boxes: what fits them, exactly, what lies about them, and what is packed into them.
#include <findspace/error.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <memory>
#include <numbers>

#include "packing/solid_depth/ball_walls.h"
#include "packing/solid_depth/container_walls.h"
#include "packing/solid_problem/container_shape.h"
#include "packing/solid_proof/solid_bound.h"
#include "packing/solid_proof/verify_solids.h"
#include "packing/solid_search/make_solid_room.h"
#include "packing/solid_search/solid_search.h"
#include "packing_solid_parts.h"
#include "space/mesh/mesh.h"

namespace findspace::packing {
namespace packing_container_shapes {

using space::Point;
using space::Solid;

plane::Shape shape_of(Solid solid) {
  plane::Shape shape;
  shape.solid = std::make_shared<const Solid>(std::move(solid));
  return shape;
}

plane::Shape hull(std::vector<Point> corners) {
  Solid solid;
  solid.mesh.vertices = std::move(corners);
  return shape_of(std::move(solid));
}

plane::Shape prism(plane::Contour ring, std::int64_t height) {
  Solid solid;
  solid.form = Solid::Form::kPrism;
  solid.contours = {std::move(ring)};
  solid.high = height;
  return shape_of(std::move(solid));
}

/// Two by two and a height of one, without the cube at (1, 1).
plane::Shape ell() { return prism({{{0, 0}}, {{2, 0}}, {{2, 1}}, {{1, 1}}, {{1, 2}}, {{0, 2}}}, 1); }

void add_box(space::Mesh& mesh, const Point& low, const Point& high, bool outward) {
  const int first = int(mesh.vertices.size());
  for (int k = 0; k < 8; ++k)
    mesh.vertices.push_back({k & 1 ? high.x : low.x, k & 2 ? high.y : low.y, k & 4 ? high.z : low.z});
  for (const auto& f : {std::array{0, 2, 3, 1}, std::array{4, 5, 7, 6}, std::array{0, 1, 5, 4}, std::array{2, 6, 7, 3},
                        std::array{0, 4, 6, 2}, std::array{1, 3, 7, 5}}) {
    std::vector<int> face;
    for (const int v : f) face.push_back(first + v);
    if (!outward) std::reverse(face.begin(), face.end());
    mesh.faces.push_back(std::move(face));
  }
}

/// A box of sides 5 with a hollow of side 1 in its middle, which is outside.
plane::Shape hollow_box() {
  Solid solid;
  solid.form = Solid::Form::kMesh;
  add_box(solid.mesh, {0, 0, 0}, {5, 5, 5}, true);
  add_box(solid.mesh, {2, 2, 2}, {3, 3, 3}, false);
  space::clean(solid.mesh, 1);
  return shape_of(std::move(solid));
}

plane::Shape ball_at(const Point& center, std::int64_t radius) {
  Solid solid;
  solid.form = Solid::Form::kBall;
  solid.mesh.vertices = {center};
  solid.radius = exact::Real(radius);
  return shape_of(std::move(solid));
}

plane::Shape united(const std::vector<plane::Shape>& shapes, plane::Shape::Kind kind = plane::Shape::Kind::kUnion) {
  plane::Shape result;
  result.kind = kind;
  for (const plane::Shape& shape : shapes) result.children.push_back(std::make_shared<const plane::Shape>(shape));
  return result;
}

plane::Shape box_from(const Point& low, const Point& high) {
  return hull({low,
               high,
               {low.x, low.y, high.z},
               {low.x, high.y, low.z},
               {high.x, low.y, low.z},
               {low.x, high.y, high.z},
               {high.x, low.y, high.z},
               {high.x, high.y, low.z}});
}

/// The L of ell(), as a union of two boxes that touch.
plane::Shape two_boxes() { return united({box_from({0, 0, 0}, {2, 1, 1}), box_from({0, 1, 0}, {1, 2, 1})}); }

/// Under the plane x + z = side, `depth` deep.
plane::Shape ramp(std::int64_t side, std::int64_t depth) {
  return hull({{0, 0, 0}, {side, 0, 0}, {0, 0, side}, {0, depth, 0}, {side, depth, 0}, {0, depth, side}});
}

SolidProblem in_one(const plane::Shape& shape, std::vector<SolidPart> parts, int count = 1) {
  SolidProblem problem;
  problem.containers = {{"shaped", count, {}, 0, 0, 0}};
  set_shape(problem.containers[0], shape, problem.steps());
  problem.parts = std::move(parts);
  return problem;
}

SolidPart ball(const char* name, int demand, std::int64_t radius) {
  return part_of(name, demand, {space::part_of(std::vector<Point>{{radius, radius, radius}}, exact::Real(radius))});
}

SolidLayout one_at(const SolidProblem& problem, std::array<Fraction, 3> at) {
  SolidLayout layout;
  layout.items.push_back({0, 1, 0, at, 0});
  layout.containers = {0};
  layout.height = problem.containers[0].height;
  return layout;
}

/// By how much one is outside; nothing where it is not.
std::optional<double> outside(const SolidProblem& problem, std::array<Fraction, 3> at) {
  const SolidVerdict verdict = verify(problem, one_at(problem, at));
  if (verdict.is_feasible()) return std::nullopt;
  EXPECT_EQ(verdict.faults[0].kind, SolidFault::Kind::kOutside);
  return verdict.faults[0].depth;
}

std::optional<SolidLayout> search(const SolidProblem& problem, double work) {
  const std::atomic<bool> stop = false;
  SolidSearchOptions options;
  options.work = work;
  return search_solids(problem, options, {}, stop);
}

SolidLayout found(const SolidProblem& problem, double work) {
  const auto layout = search(problem, work);
  EXPECT_TRUE(verify(problem, layout.value()).is_feasible());
  return *layout;
}

const Fraction kTiny(1, 1000000000000);

TEST(ContainerShape, BeginsAtTheOrigin) {
  SolidContainer container;
  set_shape(container, hull({{-3, 7, 100}, {1, 7, 100}, {-3, 9, 100}, {-3, 7, 105}}), 10);
  EXPECT_EQ(container.width, Fraction(2, 5));
  EXPECT_EQ(container.depth, Fraction(1, 5));
  EXPECT_EQ(container.height, Fraction(1, 2));
  ASSERT_NE(container.inside, nullptr);
  EXPECT_EQ(space::bounds(container.inside->body).low[2], exact::Real(0));
}

TEST(ContainerShape, ABoxStaysABox) {
  SolidContainer container;
  set_shape(container, prism({{{1, 1}}, {{4, 1}}, {{4, 3}}, {{1, 3}}}, 5), 1);
  EXPECT_EQ(container.inside, nullptr);
  EXPECT_EQ(container.width, Fraction(3));
}

TEST(ContainerShape, WhatIsNone) {
  SolidContainer container;
  EXPECT_THROW(set_shape(container, hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}), 1), Error);
  EXPECT_THROW(set_shape(container, united({ramp(1, 1), ball_at({0, 0, 0}, 3)}), 1), Error);
  plane::Shape outside;
  outside.kind = plane::Shape::Kind::kComplement;
  outside.children = {std::make_shared<const plane::Shape>(ramp(1, 1))};
  EXPECT_THROW(set_shape(container, outside, 1), Error);
}

TEST(ContainerShape, AUnionThatIsABox) {
  SolidContainer container;
  set_shape(container, united({box_from({3, 0, 0}, {5, 2, 1}), box_from({1, 0, 0}, {4, 2, 1})}), 1);
  EXPECT_EQ(container.inside, nullptr);
  EXPECT_EQ(container.width, Fraction(4));
}

TEST(ContainerShape, AUnionLacksCells) {
  const SolidProblem problem = in_one(two_boxes(), {});
  const SolidContainer& c = problem.containers[0];
  ASSERT_NE(c.lacks, nullptr);
  ASSERT_EQ(c.lacks->body.parts.size(), 1U);
  EXPECT_DOUBLE_EQ(volume_of(problem, c), 3);
  EXPECT_DOUBLE_EQ(volume_below(problem, c, 0.5), 1.5);
  const ContainerWalls walls = container_walls(problem, c);
  ASSERT_EQ(walls.cells.size(), 1U);
  EXPECT_EQ(walls.cells[0].open, (OpenSides{{{false, true}, {false, true}, {true, true}}}));
}

TEST(ContainerShape, AMeshGoesOnAcrossAWallWithin) {
  Solid solid;
  solid.form = Solid::Form::kMesh;
  add_box(solid.mesh, {0, 0, 0}, {2, 1, 1}, true);
  add_box(solid.mesh, {0, 1, 0}, {1, 2, 1}, true);
  space::clean(solid.mesh, 1);
  const SolidProblem one = in_one(shape_of(std::move(solid)), {box("brick", 1, 1, 2, 1)});
  EXPECT_FALSE(outside(one, {0, 0, 0}));
  EXPECT_TRUE(outside(one, {1, 0, 0}));
}

/// The walls of a box are 1 thick.
plane::Shape room_in(std::int64_t side) {
  plane::Shape room = united({box_from({0, 0, 0}, {side, side, side})}, plane::Shape::Kind::kOffset);
  room.amount = exact::Real(-1);
  return room;
}

/// The pillar leaves the room through floor and ceiling; what is outside counts for nothing.
TEST(ContainerShape, ARoomLessAPillar) {
  const plane::Shape shape = united({room_in(12), box_from({5, 5, -5}, {7, 7, 20})}, plane::Shape::Kind::kDifference);
  const SolidProblem problem = in_one(shape, {box("brick", 480, 1, 1, 2)}, 2);
  EXPECT_DOUBLE_EQ(volume_of(problem, problem.containers[0]), 960);
  EXPECT_EQ(lower_bound(problem), Fraction(1));
  EXPECT_EQ(lower_bound(in_one(shape, {box("brick", 481, 1, 1, 2)}, 2)), Fraction(2));
  const SolidProblem one = in_one(shape, {box("brick", 1, 1, 1, 2)});
  EXPECT_FALSE(outside(one, {3, 4, 0}));
  EXPECT_TRUE(outside(one, {Fraction(3) + kTiny, 4, 0}));
}

TEST(ContainerShape, ARoomCutToABoxIsABox) {
  const plane::Shape shape = united({room_in(10), box_from({0, 0, 0}, {8, 8, 8})}, plane::Shape::Kind::kIntersection);
  const SolidProblem problem = in_one(shape, {box("brick", 1, 1, 1, 2)});
  EXPECT_EQ(problem.containers[0].inside, nullptr);
  EXPECT_EQ(problem.containers[0].width, Fraction(7));
  EXPECT_EQ(lower_bound(problem), Fraction(1));
}

TEST(ContainerShape, RoomsThatHaveNothingInCommon) {
  SolidContainer container;
  const plane::Shape pillar = box_from({0, 0, 0}, {12, 12, 12});
  EXPECT_THROW(set_shape(container, united({room_in(12), pillar}, plane::Shape::Kind::kDifference), 1), Error);
}

/// The corners of its parts are no whole numbers, but cells are exact.
TEST(ContainerShape, SlopesThatCrossOffTheGrid) {
  const SolidProblem problem =
      in_one(united({hull({{0, 0, 0}, {3, 0, 0}, {0, 0, 2}, {0, 1, 0}, {3, 1, 0}, {0, 1, 2}}),
                     hull({{3, 0, 0}, {0, 0, 0}, {3, 0, 2}, {3, 1, 0}, {0, 1, 0}, {3, 1, 2}})}),
             {box("cube", 1, 1, 1, 1)});
  EXPECT_NEAR(volume_of(problem, problem.containers[0]), 4.5, 1e-12);
  // Under the line from (0, 2) to (3, 0) that is met at 1.5.
  EXPECT_FALSE(outside(problem, {Fraction(1, 2), 0, 0}));
  EXPECT_TRUE(outside(problem, {1, 0, Fraction(1, 2)}));
}

TEST(ContainerShape, ABall) {
  const SolidProblem problem = in_one(ball_at({7, -2, 1}, 3), {});
  const SolidContainer& c = problem.containers[0];
  EXPECT_EQ(c.width, Fraction(6));
  EXPECT_EQ(c.height, Fraction(6));
  EXPECT_DOUBLE_EQ(volume_of(problem, c), 36 * std::numbers::pi);
  EXPECT_DOUBLE_EQ(volume_below(problem, c, 3), 18 * std::numbers::pi);
  EXPECT_DOUBLE_EQ(volume_below(problem, c, 0), 0);
}

TEST(ContainerShape, ADome) {
  const SolidProblem problem =
      in_one(united({ball_at({0, 0, 0}, 6), box_from({-9, -9, 0}, {9, 9, 9})}, plane::Shape::Kind::kIntersection),
             {box("slab", 1, 4, 8, 4)});
  const SolidContainer& c = problem.containers[0];
  EXPECT_EQ(c.width, Fraction(12));
  EXPECT_EQ(c.height, Fraction(6));
  EXPECT_NEAR(volume_of(problem, c) / (144 * std::numbers::pi), 1, 1e-3);
  // Its corners are (2, 4, 4) from the middle of the floor.
  EXPECT_FALSE(outside(problem, {4, 2, 0}));
  EXPECT_TRUE(outside(problem, {4, 2 + kTiny, 0}));
  EXPECT_NEAR(*outside(problem, {4, 2, 1}), std::sqrt(45) - 6, 1e-12);
}

/// A box about a ball, which is clear of its sides.
TEST(ContainerShape, WithARoundObstacle) {
  SolidProblem problem =
      in_one(united({box_from({0, 0, 0}, {10, 10, 10}), ball_at({5, 5, 5}, 3)}, plane::Shape::Kind::kDifference),
             {box("cube", 1, 1, 1, 1)});
  EXPECT_NEAR(volume_of(problem, problem.containers[0]) / (1000 - 36 * std::numbers::pi), 1, 1e-3);
  EXPECT_FALSE(outside(problem, {6, 7, 7}));
  EXPECT_TRUE(outside(problem, {6, 7, 7 - kTiny}));
  EXPECT_TRUE(outside(problem, {5, 5, 5}));
  problem.edge = 1;
  EXPECT_TRUE(outside(problem, {6, 7, 7}));
  EXPECT_FALSE(outside(problem, {7, 7, 8}));
  EXPECT_FALSE(outside(problem, {1, 1, 1}));
}

/// The rim is 4 from the line through both centres.
TEST(ContainerShape, WhatBallsHaveInCommon) {
  const SolidProblem problem =
      in_one(united({ball_at({0, 0, 0}, 5), ball_at({6, 0, 0}, 5)}, plane::Shape::Kind::kIntersection),
             {box("plate", 1, 2, 4, 4)});
  EXPECT_EQ(problem.containers[0].width, Fraction(4));
  EXPECT_EQ(problem.containers[0].depth, Fraction(10));
  // Its corners are (4, 2, 2) from the centre that is farther.
  EXPECT_FALSE(outside(problem, {1, 3, 3}));
  EXPECT_TRUE(outside(problem, {2, 4, 4}));
  EXPECT_TRUE(outside(problem, {0, 4, 4}));
}

TEST(ContainerShape, VolumeBelow) {
  const SolidProblem problem = in_one(ramp(2, 3), {});
  const SolidContainer& c = problem.containers[0];
  EXPECT_DOUBLE_EQ(volume_of(problem, c), 6);
  EXPECT_DOUBLE_EQ(volume_below(problem, c, 1), 4.5);
  EXPECT_DOUBLE_EQ(volume_below(problem, c, 0), 0);
  EXPECT_DOUBLE_EQ(volume_below(problem, c, 9), 6);
  const SolidProblem hollow = in_one(hollow_box(), {});
  EXPECT_DOUBLE_EQ(volume_of(hollow, hollow.containers[0]), 124);
  EXPECT_DOUBLE_EQ(volume_below(hollow, hollow.containers[0], 2.5), 62);
}

TEST(ContainerWalls, OfAConvexOneAreHalfSpaces) {
  const SolidProblem problem = in_one(ramp(4, 2), {});
  const ContainerWalls walls = container_walls(problem, problem.containers[0]);
  ASSERT_EQ(walls.planes.size(), 1U);
  EXPECT_TRUE(walls.cells.empty());
  EXPECT_DOUBLE_EQ(walls.planes[0].normal.x, -std::sqrt(0.5));
  EXPECT_DOUBLE_EQ(walls.planes[0].offset, 4 * std::sqrt(0.5));
}

TEST(ContainerWalls, CellsAreOpenAtTheBox) {
  const SolidProblem problem = in_one(ell(), {});
  const ContainerWalls walls = container_walls(problem, problem.containers[0]);
  EXPECT_TRUE(walls.planes.empty());
  double volume = 0;
  OpenSides open{};
  for (const ContainerWalls::Cell& cell : walls.cells) {
    volume += cell.body.parts[0].core->volume() / std::pow(double(cell.body.scale), 3);
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t side = 0; side < 2; ++side) open[k][side] |= cell.open[k][side];
  }
  EXPECT_DOUBLE_EQ(volume, 1);
  EXPECT_EQ(open, (OpenSides{{{false, true}, {false, true}, {true, true}}}));
}

TEST(Containment, TouchingTheSlopeIsInside) {
  const SolidProblem problem = in_one(ramp(4, 2), {box("cube", 1, 1, 1, 1)});
  EXPECT_FALSE(outside(problem, {1, 0, 1}));
  EXPECT_FALSE(outside(problem, {Fraction(5, 3), 1, Fraction(1, 3)}));
  EXPECT_TRUE(outside(problem, {1 + kTiny, 0, 1}));
  EXPECT_NEAR(*outside(problem, {2, 0, 1}), std::sqrt(0.5), 1e-12);
}

/// The plane is 4 x + 3 z = 24: its distance is a fraction.
TEST(Containment, EdgesOfRationalDistance) {
  SolidProblem problem =
      in_one(hull({{0, 0, 0}, {6, 0, 0}, {0, 0, 8}, {0, 4, 0}, {6, 4, 0}, {0, 4, 8}}), {box("cube", 1, 1, 1, 1)});
  problem.edge = 1;
  // (2 + 1, 1 + 1, z + 1) is (24 - 12 - 3 z - 3) / 5 from the plane.
  EXPECT_FALSE(outside(problem, {2, 1, Fraction(4, 3)}));
  EXPECT_TRUE(outside(problem, {2, 1, Fraction(4, 3) + kTiny}));
  problem.edge = 1 + kTiny;
  EXPECT_TRUE(outside(problem, {2, 1 + kTiny, Fraction(4, 3)}));
}

/// Distances with a root: a cube at x is (8 - x - 3) / sqrt(2) from the slope.
TEST(Containment, EdgesOfIrrationalDistance) {
  SolidProblem problem = in_one(ramp(8, 8), {box("cube", 1, 1, 1, 1)});
  problem.edge = 1;
  EXPECT_FALSE(outside(problem, {Fraction(3585786, 1000000), 1, 1}));
  EXPECT_TRUE(outside(problem, {Fraction(3585787, 1000000), 1, 1}));
}

TEST(Containment, ABallTouchesTheSlope) {
  SolidProblem problem =
      in_one(hull({{0, 0, 0}, {6, 0, 0}, {0, 0, 8}, {0, 9, 0}, {6, 9, 0}, {0, 9, 8}}), {ball("ball", 1, 1)});
  // Its centre (2, 1, c) is (24 - 8 - 3 c) / 5 from the plane.
  EXPECT_FALSE(outside(problem, {1, 0, Fraction(11, 3) - 1}));
  EXPECT_TRUE(outside(problem, {1, 0, Fraction(11, 3) - 1 + kTiny}));
  EXPECT_NEAR(*outside(problem, {1, 0, Fraction(14, 3) - 1}), 0.6, 1e-12);
}

TEST(Containment, InOneThatIsNotConvex) {
  const SolidProblem problem = in_one(ell(), {box("cube", 1, 1, 1, 1)});
  EXPECT_FALSE(outside(problem, {0, 0, 0}));
  EXPECT_FALSE(outside(problem, {1, 0, 0}));
  EXPECT_FALSE(outside(problem, {0, Fraction(1, 3), 0}));
  EXPECT_TRUE(outside(problem, {1, kTiny, 0}));
  EXPECT_DOUBLE_EQ(*outside(problem, {1, 1, 0}), 1);
}

/// All of its corners lie in the container; its middle does not.
TEST(Containment, BridgesAreOutside) {
  const SolidProblem problem =
      in_one(prism({{{0, 0}}, {{3, 0}}, {{3, 2}}, {{2, 2}}, {{2, 1}}, {{1, 1}}, {{1, 2}}, {{0, 2}}}, 1),
             {box("beam", 1, 3, 1, 1)});
  EXPECT_FALSE(outside(problem, {0, 0, 0}));
  EXPECT_TRUE(outside(problem, {0, 1, 0}));
}

TEST(Containment, HollowsAreOutside) {
  SolidProblem problem = in_one(hollow_box(), {box("cube", 1, 1, 1, 1)});
  EXPECT_TRUE(outside(problem, {2, 2, 2}));
  EXPECT_FALSE(outside(problem, {1, 2, 2}));
  EXPECT_TRUE(outside(problem, {1 + kTiny, 2, 2}));
  problem.parts[0] = box("block", 1, 3, 2, 2);
  EXPECT_DOUBLE_EQ(*outside(problem, {1, Fraction(3, 2), Fraction(3, 2)}), 0.5);  // the hollow lies in it
  problem.parts[0] = box("cube", 1, 1, 1, 1);
  problem.edge = Fraction(1, 2);
  EXPECT_FALSE(outside(problem, {Fraction(1, 2), 2, 2}));
  EXPECT_TRUE(outside(problem, {Fraction(1, 2) + kTiny, 2, 2}));
}

/// Over the seam of two parts, but not into the corner.
TEST(Containment, InAUnion) {
  SolidProblem problem = in_one(two_boxes(), {box("cube", 1, 1, 1, 1)});
  EXPECT_FALSE(outside(problem, {1, 0, 0}));
  EXPECT_FALSE(outside(problem, {0, Fraction(1, 3), 0}));
  EXPECT_TRUE(outside(problem, {1, kTiny, 0}));
  EXPECT_DOUBLE_EQ(*outside(problem, {1, 1, 0}), 1);
}

TEST(Containment, EdgesInAUnion) {
  SolidProblem problem =
      in_one(united({box_from({0, 0, 0}, {6, 3, 3}), box_from({0, 0, 0}, {3, 6, 3})}), {box("cube", 1, 1, 1, 1)});
  problem.edge = 1;
  // The corner that is lacking begins at (3, 3).
  EXPECT_FALSE(outside(problem, {1, 4, 1}));
  EXPECT_FALSE(outside(problem, {Fraction(7, 5), Fraction(6, 5), 1}));
  EXPECT_TRUE(outside(problem, {Fraction(7, 5) + kTiny, Fraction(6, 5), 1}));
}

/// A corner at the distance of a radius, which is a root for others.
TEST(Containment, InABall) {
  SolidProblem problem = in_one(ball_at({0, 0, 0}, 7), {box("slab", 1, 2, 3, 6)});
  // From (2, 3, 6) about the middle at (7, 7, 7).
  EXPECT_FALSE(outside(problem, {7, 7, 7}));
  EXPECT_FALSE(outside(problem, {5, 4, 1}));
  EXPECT_TRUE(outside(problem, {7, 7, 7 + kTiny}));
  EXPECT_NEAR(*outside(problem, {7, 7, 8}), std::sqrt(62) - 7, 1e-12);
  problem.edge = kTiny;
  EXPECT_TRUE(outside(problem, {7, 7, 7}));
}

TEST(Containment, ABallInABall) {
  SolidProblem problem = in_one(ball_at({0, 0, 0}, 9), {ball("ball", 1, 2)});
  // Its centre is at (4, 5, 2), (4, 4, 7) and so on about the middle.
  EXPECT_FALSE(outside(problem, {7 + 6, 7 + 3, 7 + 2}));
  EXPECT_TRUE(outside(problem, {7 + 6, 7 + 3, 7 + 2 + kTiny}));
  problem.edge = 1;
  EXPECT_FALSE(outside(problem, {7 + 4, 7 + 4, 7 + 2}));
  EXPECT_TRUE(outside(problem, {7 + 4, 7 + 4, 7 + 2 + kTiny}));
}

/// They hold what they promise: where all half-spaces are free, the part lies in the ball, and little is lost.
TEST(BallWalls, LieWithin) {
  const SolidProblem problem = in_one(ball_at({0, 0, 0}, 10), {box("slab", 1, 4, 6, 2), ball("ball", 1, 3)});
  const ContainerWalls walls = container_walls(problem, problem.containers[0]);
  for (std::size_t part = 0; part < 2; ++part) {
    const space::Body& body = problem.parts[part].forms[0].body;
    const auto planes = ball_walls(body, 1, walls.balls[0], 0.5);
    int free = 0, inside = 0;
    for (int k = 0; k < 8000; ++k) {
      const Vector at{k % 20 * 0.8, k / 20 % 20 * 0.8, k / 400 * 0.8};
      const bool is_free = std::all_of(planes.begin(), planes.end(), [&](const ContainerWalls::Plane& p) {
        return space::dot(p.normal, at) <= p.offset;
      });
      const bool is_inside =
          std::all_of(body.parts[0].vertices().begin(), body.parts[0].vertices().end(), [&](const Point& p) {
            return space::length(exact::approx(p) + at - walls.balls[0].center) + body.parts[0].radius.to_double() <=
                   9.5;
          });
      EXPECT_LE(is_free, is_inside);
      free += is_free;
      inside += is_inside;
    }
    EXPECT_GT(free, 0.93 * inside);
  }
}

/// No place is free of all where a part does not fit.
TEST(BallWalls, WhatFitsNowhere) {
  const SolidProblem problem = in_one(ball_at({0, 0, 0}, 3), {box("slab", 1, 4, 4, 3)});
  const auto planes = ball_walls(problem.parts[0].forms[0].body, 1, {{3, 3, 3}, 3}, 0);
  ASSERT_EQ(planes.size(), 6U);
  EXPECT_LT(planes[0].offset + planes[1].offset, 0);
}

/// Less than their boxes do.
TEST(ShapedContainers, BoundsCountWhatTheyHold) {
  EXPECT_EQ(lower_bound(in_one(two_boxes(), {box("cube", 3, 1, 1, 1)}, 9)), Fraction(1));
  EXPECT_EQ(lower_bound(in_one(two_boxes(), {box("cube", 4, 1, 1, 1)}, 9)), Fraction(2));
  // 113.1 cubic units.
  EXPECT_EQ(lower_bound(in_one(ball_at({0, 0, 0}, 3), {box("cube", 113, 1, 1, 1)}, 9)), Fraction(1));
  EXPECT_EQ(lower_bound(in_one(ball_at({0, 0, 0}, 3), {box("cube", 114, 1, 1, 1)}, 9)), Fraction(2));
}

/// At one place alone.
TEST(ShapedContainers, FitsOfNoPlay) {
  const SolidLayout layout =
      found(in_one(ball_at({0, 0, 0}, 3), {box("brick", 1, 4, 4, 2), ball("ball", 1, 3)}, 2), 4e6);
  EXPECT_EQ(layout.items.size(), 2U);
}

/// Eight balls of radius 1 about the middle, at (1, 1, 1) and so on, reach out to 1 + root of 3.
TEST(ShapedContainers, BallsFillABall) {
  const SolidLayout layout = found(in_one(ball_at({0, 0, 0}, 3), {ball("ball", 9, 1)}), 20e6);
  EXPECT_GE(layout.items.size(), 8U);
}

TEST(ShapedContainers, CubesFillAUnion) {
  const SolidLayout layout = found(in_one(two_boxes(), {box("cube", 4, 1, 1, 1)}), 4e6);
  EXPECT_EQ(layout.items.size(), 3U);
  EXPECT_EQ(layout.left_out.size(), 1U);
}

TEST(ShapedContainers, ThreeCubesFillAnEll) {
  const SolidLayout layout = found(in_one(ell(), {box("cube", 4, 1, 1, 1)}), 4e6);
  EXPECT_EQ(layout.items.size(), 3U);
  ASSERT_EQ(layout.left_out.size(), 1U);
  EXPECT_EQ(layout.left_out[0].copies, 1);
}

/// Another container has to take the fourth.
TEST(ShapedContainers, FewAreUsed) {
  const SolidLayout layout = found(in_one(ell(), {box("cube", 4, 1, 1, 1)}, 3), 4e6);
  EXPECT_EQ(layout.items.size(), 4U);
  EXPECT_EQ(layout.containers.size(), 2U);
}

/// Cubes lie under the slope as 2 + 1.
TEST(ShapedContainers, CubesUnderASlope) {
  const SolidLayout layout = found(in_one(ramp(3, 1), {box("cube", 4, 1, 1, 1)}), 4e6);
  EXPECT_EQ(layout.items.size(), 3U);
}

/// Four slabs turn about it.
TEST(ShapedContainers, GoRoundAHollow) {
  const SolidProblem problem = in_one(hollow_box(), {with_turns(box("slab", 4, 2, 3, 5))});
  EXPECT_EQ(found(problem, 20e6).items.size(), 4U);
}

TEST(ShapedContainers, EdgesHoldAtSlopes) {
  SolidProblem problem = in_one(ramp(10, 3), {box("cube", 6, 1, 1, 1)});
  problem.edge = 1;
  const SolidLayout layout = found(problem, 4e6);
  EXPECT_EQ(layout.items.size(), 6U);
}

TEST(ShapedContainers, FixedSolidsStandInThem) {
  SolidProblem problem = in_one(ell(), {box("cube", 3, 1, 1, 1)});
  problem.fixed = {{.placed = {.part = 0, .at = {1, 0, 0}}}};
  const SolidLayout layout = found(problem, 4e6);
  EXPECT_EQ(layout.items.size(), 3U);
}

/// The slab fits the box only, the cubes fill the other.
TEST(ShapedContainers, BesideBoxes) {
  SolidProblem problem = in_one(ell(), {box("cube", 3, 1, 1, 1), box("slab", 1, 2, 2, 1)});
  problem.containers.push_back({"box", 1, {}, 2, 2, 1});
  const SolidLayout layout = found(problem, 10e6);
  EXPECT_EQ(layout.items.size(), 4U);
  EXPECT_EQ(layout.containers.size(), 2U);
  EXPECT_DOUBLE_EQ(verify(problem, layout).density, 1);
}

TEST(ShapedContainers, AMoveByHandStaysWithin) {
  const SolidProblem problem = in_one(ramp(4, 2), {box("cube", 1, 1, 1, 1)});
  const auto moved = with_room(problem, one_at(problem, {0, 0, 0}), 0, {3, 0, 1});
  ASSERT_TRUE(moved);
  EXPECT_TRUE(verify(problem, *moved).is_feasible());
}

TEST(ShapedContainers, AMoveByHandStaysInABall) {
  const SolidProblem problem = in_one(ball_at({0, 0, 0}, 4), {box("cube", 1, 2, 2, 2)});
  const auto moved = with_room(problem, one_at(problem, {3, 3, 3}), 0, {6, 6, 6});
  ASSERT_TRUE(moved);
  EXPECT_TRUE(verify(problem, *moved).is_feasible());
}

/// Over the seam of the union, with another in the way.
TEST(ShapedContainers, FixedSolidsStandInUnions) {
  SolidProblem problem = in_one(two_boxes(), {box("cube", 3, 1, 1, 1)});
  problem.fixed = {{.placed = {.part = 0, .at = {1, 0, 0}}}};
  EXPECT_EQ(found(problem, 4e6).items.size(), 3U);
}

TEST(ShapedContainers, OneSeedOneLayout) {
  const SolidProblem problem = in_one(ramp(7, 4), {box("cube", 9, 1, 2, 1), ball("ball", 2, 1)});
  const SolidLayout first = found(problem, 4e6), second = found(problem, 4e6);
  ASSERT_EQ(first.items.size(), second.items.size());
  for (std::size_t k = 0; k < first.items.size(); ++k) EXPECT_EQ(first.items[k].at, second.items[k].at);
}

}  // namespace packing_container_shapes
}  // namespace findspace::packing
