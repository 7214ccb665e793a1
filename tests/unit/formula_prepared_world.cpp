// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Who moves in a distance of a prepared world, and which mistakes of its callers are errors.
#include <gtest/gtest.h>

#include "findspace/error.h"
#include "formula/planar/prepared_world.h"
#include "plane_topology_sets.h"

namespace findspace::formula {
namespace formula_prepared_world {

PreparedWorld squares() {
  World world;
  world.shapes.emplace("A", plane::box(0, 0, 10, 10));
  world.shapes.emplace("B", plane::box(0, 0, 2, 2));
  world.moving = {"B"};
  world.step = exact::Real(1);
  return PreparedWorld(std::move(world));
}

Distance distance(Kind kind, std::vector<std::string> first, std::vector<std::string> second) {
  Distance d;
  d.kind = kind;
  d.first = std::move(first);
  d.second = std::move(second);
  return d;
}

TEST(PreparedWorld, TheMovingShapeComesFirst) {
  const PreparedWorld world = squares();
  const Roles given = world.roles(distance(Kind::kGamma1, {"B"}, {"A"}));
  EXPECT_FALSE(given.second_moves);
  EXPECT_EQ(given.names, ShapeNames({"B"}, {"A"}));
  const Roles symmetric = world.roles(distance(Kind::kGamma1, {"A"}, {"B"}));
  EXPECT_FALSE(symmetric.second_moves);
  EXPECT_EQ(symmetric.names, ShapeNames({"B"}, {"A"}));
  const Roles back = world.roles(distance(Kind::kMu, {"A"}, {"B"}));
  EXPECT_TRUE(back.second_moves);
  EXPECT_EQ(back.names, ShapeNames({"B"}, {"A"}));
}

TEST(PreparedWorld, ADistanceWithoutAShapeIsAnError) {
  const PreparedWorld world = squares();
  for (const Distance& wrong :
       {distance(Kind::kGamma1, {}, {"A"}), distance(Kind::kMu, {"B"}, {}), distance(Kind::kHausdorff, {}, {})}) {
    try {
      world.roles(wrong);
      ADD_FAILURE() << "no error";
    } catch (const Error& e) {
      EXPECT_EQ(e.code(), ErrorCode::kBadValue);
      EXPECT_NE(std::string(e.what()).find("names none"), std::string::npos) << e.what();
    }
  }
}

}  // namespace formula_prepared_world
}  // namespace findspace::formula
