// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Height fields: closed surfaces by themselves, of the volume that their triangles have, whatever heights are missing.
#include <findspace/error.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <functional>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "space/convolution/mesh_crossing.h"
#include "space/mesh/height_field.h"
#include "space/mesh/mesh.h"

namespace findspace::space {
namespace space_height_field {

using exact::Real;
using Heights = std::vector<std::vector<std::optional<std::int64_t>>>;

const std::optional<std::int64_t> kNone;

struct Made {
  Solid solid;
  plane::RoundingLog log;
  std::vector<std::string> notes;
};

HeightField field_of(const Heights& heights, std::array<Real, 2> step, Real floor, std::array<Real, 2> at = {}) {
  HeightField field({heights[0].size(), heights.size(), at, step, floor}, plane::Grid(1));
  for (std::size_t j = 0; j < heights.size(); ++j)
    for (std::size_t i = 0; i < heights[j].size(); ++i)
      if (heights[j][i]) field.put(i, j, *heights[j][i], 0);
  return field;
}

Made made(const Heights& heights, std::array<Real, 2> step = {Real(1), Real(1)}, const Real& floor = 0) {
  Made out;
  out.solid = field_of(heights, step, floor).solid(out.log, out.notes);
  return out;
}

/// Six times the volume of the columns below the triangles.
Real six_columns(const Heights& h, std::int64_t dx, std::int64_t dy, std::int64_t floor) {
  Real sum;
  for (std::size_t j = 0; j + 1 < h.size(); ++j)
    for (std::size_t i = 0; i + 1 < h[j].size(); ++i) {
      const auto a = h[j][i], b = h[j][i + 1], c = h[j + 1][i + 1], d = h[j + 1][i];
      if (a && b && c && d) sum += Real((2 * *a + *b + 2 * *c + *d - 6 * floor) * dx * dy);
    }
  return sum;
}

std::string refused(const std::function<void()>& act) {
  try {
    act();
  } catch (const Error& e) {
    return e.what();
  }
  return "";
}

/// Reading checks change nothing, and no face crosses another or lies on it.
void expect_closed(const Solid& solid) {
  Mesh cleaned = solid.mesh;
  EXPECT_EQ(clean(cleaned, 1), std::vector<std::string>{});
  EXPECT_EQ(cleaned.vertices.size(), solid.mesh.vertices.size());
  EXPECT_EQ(cleaned.faces.size(), solid.mesh.faces.size());
  EXPECT_EQ(six_volumes(cleaned).text(), six_volumes(solid.mesh).text());
  EXPECT_TRUE(solid.simple);
  const exact::Tried<RayBody> body = RayBody::of(triangles(solid.mesh));
  ASSERT_TRUE(body);
  const SelfContact contact = self_contact(RaySheet(*body));
  EXPECT_FALSE(contact.crossing);
  EXPECT_FALSE(contact.inner_walls);
}

TEST(HeightField, LevelGroundIsABox) {
  const Made box = made({{3, 3}, {3, 3}}, {Real(2), Real(5)}, -1);
  EXPECT_TRUE(is_convex(box.solid.mesh));
  EXPECT_EQ(box.solid.mesh.vertices.size(), 8u);
  EXPECT_EQ(six_volumes(box.solid.mesh).text(), "240");
  EXPECT_TRUE(box.notes.empty());
  expect_closed(box.solid);
}

TEST(HeightField, TheDiagonalGoesFromTheLeastCornerToTheGreatest) {
  EXPECT_EQ(six_volumes(made({{1, 1}, {1, 2}}).solid.mesh).text(), "8");  // both triangles have that corner
  EXPECT_EQ(six_volumes(made({{2, 1}, {1, 1}}).solid.mesh).text(), "8");
  EXPECT_EQ(six_volumes(made({{1, 2}, {1, 1}}).solid.mesh).text(), "7");
  EXPECT_EQ(six_volumes(made({{1, 1}, {2, 1}}).solid.mesh).text(), "7");
}

TEST(HeightField, BelowThereAreFewFaces) {
  const Heights level(41, std::vector<std::optional<std::int64_t>>(31, 2));
  const Solid solid = made(level).solid;
  EXPECT_EQ(solid.mesh.vertices.size(), 31u * 41u + 2 * (30 + 40));
  // A row of squares has two triangles below it, and one for each square beside a wall.
  EXPECT_EQ(solid.mesh.faces.size(), 2u * 30 * 40 + 2 * (30 + 40) + 2 * 40 + 2 * 29);
}

TEST(HeightField, NoTriangleBelowIsLong) {
  Heights wide(7, std::vector<std::optional<std::int64_t>>(150, 2));
  for (const std::size_t i : {31, 32, 64, 70, 96}) wide[i % 5][i] = kNone;
  const Made made_of_it = made(wide);
  expect_closed(made_of_it.solid);
  const Mesh& mesh = made_of_it.solid.mesh;
  EXPECT_EQ(six_volumes(mesh).text(), six_columns(wide, 1, 1, 0).text());
  for (const std::vector<int>& face : mesh.faces)
    for (const int v : face)
      EXPECT_LE(std::abs(mesh.vertices[std::size_t(v)].x - mesh.vertices[std::size_t(face[0])].x), 32);
}

TEST(HeightField, PartsMayTouchInAnUprightEdge) {
  const Heights crossed{{1, 2, kNone}, {1, 3, 1}, {kNone, 2, 1}};
  const Made two = made(crossed);
  EXPECT_EQ(two.notes, std::vector<std::string>{"2 of 4 squares of the height field have a corner without a height: "
                                                "nothing stands there"});
  expect_closed(two.solid);
  EXPECT_EQ(six_volumes(two.solid.mesh).text(), six_columns(crossed, 1, 1, 0).text());
}

TEST(HeightField, AShaftGoesThrough) {
  Heights ring(5, std::vector<std::optional<std::int64_t>>(5, 4));
  ring[2][2] = kNone;
  const Made made_of_it = made(ring);
  EXPECT_EQ(six_volumes(made_of_it.solid.mesh).text(), "288");  // 12 squares of 16
  expect_closed(made_of_it.solid);
}

TEST(HeightField, AnyHeightsMayBeMissing) {
  std::mt19937 random(3);
  const auto below = [&](std::uint32_t n) { return std::int64_t(random() % n); };
  for (int round = 0; round < 300; ++round) {
    Heights heights(std::size_t(2 + below(7)), std::vector<std::optional<std::int64_t>>(std::size_t(2 + below(7))));
    const std::int64_t missing = below(4), dx = 1 + below(3), dy = 1 + below(3);
    for (auto& row : heights)
      for (auto& height : row)
        if (below(8) >= missing) height = -4 + below(5);
    const Real six = six_columns(heights, dx, dy, -5);
    if (six.sign() == 0) {
      EXPECT_NE(refused([&] { made(heights); }), "");
      continue;
    }
    const Solid solid = made(heights, {Real(dx), Real(dy)}, -5).solid;
    expect_closed(solid);
    EXPECT_EQ(six_volumes(solid.mesh).text(), six.text());
  }
}

TEST(HeightField, LinesAndHeightsAreRoundedOnce) {
  HeightField field({3, 2, {Real(), Real()}, {Real::ratio(3, 2), Real(1)}, Real::ratio(-1, 4)}, plane::Grid(1));
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 2; ++j) field.put(i, j, 1, i == 2 && j == 0 ? 0.5 : 0);
  Made out;
  out.solid = field.solid(out.log, out.notes);
  EXPECT_EQ(out.log.points, 4);  // the middle column, the height, and the floor
  EXPECT_EQ(out.log.largest, 0.5);
  EXPECT_EQ(six_volumes(out.solid.mesh).text(), "18");
}

TEST(HeightField, WhatIsNoFieldIsRefused) {
  const auto of = [](std::size_t columns, std::size_t rows, Real dx, Real dy) {
    return [=] { HeightField({columns, rows, {Real(), Real()}, {dx, dy}, Real()}, plane::Grid(1)); };
  };
  EXPECT_EQ(refused(of(2, 2, 1, 1)), "");
  EXPECT_EQ(refused(of(1, 2, 1, 1)), "a height field has 2 columns and 2 rows at least, not 1 and 2");
  EXPECT_EQ(refused(of(2, 0, 1, 1)), "a height field has 2 columns and 2 rows at least, not 2 and 0");
  EXPECT_EQ(refused(of(2, 2, 0, 1)), "the step of a height field must be more than 0, in x and in y");
  EXPECT_EQ(refused(of(2, 2, 1, -1)), "the step of a height field must be more than 0, in x and in y");
  EXPECT_NE(refused(of(std::size_t{1} << 40, std::size_t{1} << 40, 1, 1)).find("more than 268435456 heights"),
            std::string::npos);
  EXPECT_EQ(
      refused(of(3, 2, Real::ratio(1, 4), 1)),
      "columns 0 and 1 of the height field fall together on the grid: the step 0.25 is finer than the grid step 1");
  EXPECT_NE(refused(of(2, 2, 1, Real(std::int64_t{1} << 41))).find("2^40"), std::string::npos);
  EXPECT_EQ(refused([] {
              made({{1, 1}, {1, 0}});
            }),
            "the floor must lie below every height: it is 0, and this height is 0");
  EXPECT_EQ(refused([] {
              made({{1, 1, 1}, {1, kNone, 1}});
            }),
            "no square of the height field has a height at each of its corners");
}

}  // namespace space_height_field
}  // namespace findspace::space
