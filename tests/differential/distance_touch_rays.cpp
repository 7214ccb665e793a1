// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Depths, how far a shape is from fitting and the farthest fit from the positions at which solids touch
// (space/surface/touch_rays.h) against those from the convex parts of both (ray_signs.h): the same sign everywhere on
// every line, in general position and along walls and edges, in slits and exact fits. And how far one protrudes from
// the other by the triangles of its surface.
#include <gtest/gtest.h>

#include <algorithm>

#include "differential/space_voxels.h"
#include "distance/rays/protrusion_rays.h"
#include "distance/rays/ray_signs.h"
#include "space/convolution/ray_ball.h"
#include "space/convolution/ray_pair.h"
#include "space/rays/piece_rays.h"
#include "space/rays/ray_sources.h"
#include "space/surface/touch_rays.h"

namespace findspace::distance {
namespace distance_touch_rays {

using exact::Real;
using space::Cells;
using space::LinearMap;
using space::PairRays;
using space::RayGrid;
using space::RayRow;
using space::RaySourcePointer;
using space::TouchPair;
using space::TouchSide;

/// A solid by its surface and by its parts.
struct Both {
  Both(const Cells& cells, const LinearMap& map)
      : surface(space::surface(cells, map)),
        sheet(std::make_shared<const space::RaySheet>(surface)),
        body(space::body_of(cells, map)) {}
  space::Triangles surface;
  std::shared_ptr<const space::RaySheet> sheet;
  space::Body body;
};

struct Counts {
  int events = 0, differences = 0, inside = 0;
};

void compare(const space::RaySource& p, const space::RaySource& q, Counts& counts) {
  for (int j = 0; j < p.grid().nv; ++j) {
    const RayRow rows[2] = {p.row(j), q.row(j)};
    counts.events += static_cast<int>(rows[0].events.size());
    for (const space::RayEvent& e : rows[0].events) counts.inside += e.here < 0 || e.after < 0;
    const RayRow same = space::combined(rows, [](std::span<const std::int8_t> s) { return std::int8_t(s[0] != s[1]); });
    for (const std::int8_t before : same.before) counts.differences += before;
    counts.differences += static_cast<int>(same.events.size());
  }
}

/// gamma1 at -level, eta1 at the level, eta2 at ten times the level.
void compare(const Both& a, const Both& b, const Real& level, const RayGrid& grid, Counts& depths, Counts& fits,
             Counts& farthest) {
  std::vector<RaySourcePointer> both;
  both.push_back(std::make_unique<PairRays>(a.surface, b.surface, grid));
  both.push_back(near_touching({a.sheet, b.sheet, TouchSide::kOutside}, level, grid));
  const RaySourcePointer depth = space::combined_rays(
      std::move(both), [](std::span<const std::int8_t> s) { return std::int8_t(s[0] < 0 ? -s[1] : 1); });
  compare(*ray_sign_map(Which::kGamma1, -level, b.body, a.body, grid), *depth, depths);
  both.clear();
  const TouchPair inside{a.sheet, b.sheet, TouchSide::kInside};
  both.push_back(std::make_unique<PairRays>(a.surface, b.surface, grid, PairRays::Side::kComplement));
  both.push_back(near_touching(inside, level, grid));
  const RaySourcePointer fit = space::combined_rays(
      std::move(both), [](std::span<const std::int8_t> s) { return s[0] <= 0 ? std::int8_t{-1} : s[1]; });
  compare(*ray_sign_map(Which::kEta1, level, b.body, a.body, grid), *fit, fits);
  compare(*ray_sign_map(Which::kEta2, level * Real(10), b.body, a.body, grid),
          *all_touching_near(inside, level * Real(10), grid), farthest);
}

const LinearMap kSkew{{{100, 17, 3}, {-9, 90, 11}, {5, -13, 120}}}, kTilt{{{50, 3, -8}, {7, 40, 9}, {-5, 2, 60}}};

TEST(TouchRays, BracketsOnALattice) {
  Counts depths, fits, farthest;
  const Both u(space::extruded({"#.#", "###"}, 2), space::stretch(10)),
      cube(space::extruded({"#"}, 1), space::stretch(10)), bracket(space::extruded({"##", "#."}, 1), space::stretch(5)),
      room(space::around(space::extruded({"##", "#."}, 2), 1), space::stretch(10));
  for (const Real& level : {Real(5), Real::ratio(7, 2)}) {
    for (int axis = 0; axis < 3; ++axis) {
      const RayGrid walls{axis, 1, -20, -20, 5, 5, 10, 10}, between{axis, 3, -61, -59, 23, 17, 9, 12};
      for (const RayGrid& grid : {walls, between}) {
        compare(u, cube, level, grid, depths, fits, farthest);  // the cube just fits into the slot
        compare(u, bracket, level, grid, depths, fits, farthest);
        compare(room, cube, level, grid, depths, fits, farthest);  // and just into the room
        compare(room, bracket, level, grid, depths, fits, farthest);
      }
    }
  }
  for (const Counts& counts : {depths, fits, farthest}) {
    EXPECT_EQ(counts.differences, 0);
    EXPECT_GT(counts.events, 500);
    EXPECT_GT(counts.inside, 200);
  }
}

TEST(TouchRays, RandomSolidsInGeneralPosition) {
  std::mt19937 random(8);
  Counts depths, fits, farthest;
  for (int k = 0; k < 3; ++k) {
    const Both a(space::random_cells(random, 5, 3), kSkew), b(space::random_cells(random, 3, 2), kTilt),
        room(space::around(space::random_cells(random, 5, 3), 1), kSkew);
    const RayGrid grid{k % 3, 1, -100, -120, 67, 53, 6, 7};
    compare(a, b, Real(9 + 7 * k), grid, depths, fits, farthest);
    compare(room, b, Real(5 + 6 * k), grid, depths, fits, farthest);
  }
  EXPECT_EQ(depths.differences + fits.differences + farthest.differences, 0);
  EXPECT_GT(depths.events, 300);
  EXPECT_GT(fits.events, 20);
}

/// The events of a line, to the last digit, are those that it has among others.
TEST(TouchRays, OneLineAlone) {
  std::mt19937 random(11);
  int events = 0;
  for (int k = 0; k < 3; ++k) {
    const Both a(space::random_cells(random, 6, 3), kSkew), b(space::random_cells(random, 3, 2), kTilt);
    const RayGrid grid{k, 1, -100, -120, 13, 17, 20, 18};
    const TouchPair pair{a.sheet, b.sheet, TouchSide::kOutside};
    const RaySourcePointer all = near_touching(pair, Real(6), grid);
    for (int j = 0; j < grid.nv; j += 3) {
      const RayRow row = all->row(j);
      for (int i = 1; i < grid.nu; i += 4) {
        const RaySourcePointer one = near_touching(pair, Real(6), {k, 1, grid.u_at(i), grid.v_at(j), 13, 17, 1, 1});
        const RayRow alone = one->row(0);
        const auto from = row.events.begin() + row.first[static_cast<std::size_t>(i)];
        ASSERT_EQ(static_cast<int>(alone.events.size()),
                  row.first[static_cast<std::size_t>(i) + 1] - row.first[static_cast<std::size_t>(i)]);
        const auto same = [](const space::RayEvent& e, const space::RayEvent& f) {
          return e.at.value == f.at.value && e.here == f.here && e.after == f.after;
        };
        EXPECT_TRUE(std::equal(alone.events.begin(), alone.events.end(), from, same));
        events += static_cast<int>(alone.events.size());
      }
    }
  }
  EXPECT_GT(events, 200);
}

space::Body with_ball(space::Body body, const space::Point& center, const Real& radius) {
  body.parts.push_back({std::nullopt, center, radius});
  return body;
}

/// mu by the triangles of A against mu by its parts: no place on a line is certainly on different sides. The last ones
/// have a ball each.
TEST(TouchRays, ProtrudesOfTheSurface) {
  std::mt19937 random(5);
  int known = 0, unknown = 0, inside = 0, different = 0, by_surface = 0;
  for (int k = 0; k < 6; ++k) {
    const Both a(k == 0 ? space::extruded({"#.#", "###"}, 2) : space::random_cells(random, 5, 3),
                 k == 0 ? space::stretch(100) : kSkew),
        b(space::random_cells(random, 3, 2), kTilt);
    const RayGrid grid{k % 3, 1, -90, -110, 71, 57, 4, 5};
    const Real level(30 + 25 * k);
    const space::Point at{40, 30, 90};
    std::vector<space::RaySolid> solids{space::RaySolid{a.surface, {}}};
    space::Body of_a = a.body, of_b = b.body;
    if (k > 3) {
      solids.push_back({{}, at, Real(70)});
      of_a = with_ball(of_a, at, Real(70));
      of_b = with_ball(of_b, {10, -20, 5}, Real(25));
    }
    const auto parts = ray_sign_map(Which::kMu, level, of_b, of_a, grid);
    const auto corners = [&](const Real& l) {
      std::vector<RaySourcePointer> all;
      for (const space::BodyPart& part : of_b.parts) {
        for (const space::Point& v : part.vertices()) {
          std::vector<RaySourcePointer> near;
          near.push_back(std::make_unique<space::BallRays>(space::moved(a.surface, -v), l, grid));
          if (k > 3)
            near.push_back(std::make_unique<space::PieceRays>(
                std::vector{space::ball_piece(space::real(at - v), Real(70) + l)}, 1, grid));
          all.push_back(space::combined_rays(
              std::move(near), [](std::span<const std::int8_t> s) { return *std::min_element(s.begin(), s.end()); }));
        }
      }
      return space::greatest_rays(std::move(all));
    };
    const std::shared_ptr<const ProtrusionField> field = field_of_surfaces(solids);
    const ProtrusionRays surface(
        protrusion_parts(of_b), field, level, [&](const Real& l) { return stretches_of(corners(l)); }, grid, 1);
    // B by its surface alone, its corners by one offset surface.
    std::optional<ProtrusionParts> flat;
    if (k <= 3) flat = protrusion_parts({space::RaySolid{b.surface, {}}}, *field, level.to_double());
    by_surface += flat.has_value();
    const ProtrusionRays outline(
        flat ? *std::move(flat) : protrusion_parts(of_b), field, level,
        [&](const Real& l) {
          const double most = l.to_double() - 1;
          std::vector<space::Point> of = k <= 3 ? b.surface.points : std::vector<space::Point>();
          return of.empty() ? stretches_of(corners(l))
                            : corner_stretches(of, solids, l, grid, [field, most](const space::Extent& box) {
                                return field->within(box, most);
                              });
        },
        grid, 1);
    for (int j = 0; j < grid.nv; ++j) {
      const RayRow rows[3] = {parts->row(j), surface.row(j), outline.row(j)};
      for (int i = 0; i < grid.nu; ++i) {
        for (int z = -700; z < 900; z += 9) {
          const int s = space::sign_at(rows[0], i, Real(z)), t = space::sign_at(rows[1], i, Real(z));
          (s != 0 && t != 0 ? known : unknown) += 1;
          different += s * t < 0 || s * space::sign_at(rows[2], i, Real(z)) < 0;
          inside += t < 0;
        }
      }
    }
  }
  EXPECT_EQ(different, 0);
  EXPECT_GT(inside, 200);
  EXPECT_GT(known, 100 * unknown);
  EXPECT_GE(by_surface, 3);
}

/// Two bars on a plate pass through the middle of a room, one above the other and beside it. Only one of them can hold
/// the place that stands for the room, and where that bar has left it the other one protrudes: nothing is left between.
TEST(TouchRays, ProtrudesBesideTheVoid) {
  const Both room(space::around(space::extruded({"###", "###", "###"}, 6), 1), space::stretch(100));
  Cells cells;
  for (int y = 0; y < 3; ++y) {
    for (int z = 0; z < 13; ++z) cells.insert({0, y, z});
  }
  cells.insert({1, 0, 2});
  cells.insert({1, 2, 10});
  space::Triangles bars = space::surface(cells, {{{150, 0, 0}, {0, 24, 0}, {0, 0, 20}}});
  for (space::Point& p : bars.points) {  // but for the top of the lower bar no face is along one of the room
    if (p.z <= 40) p.z -= p.x / 15 + p.y / 12;
    if (p.z >= 200) p.z += p.x / 15 + p.y / 12;
  }
  const std::vector<space::RaySolid> solids{space::RaySolid{room.surface, {}}};
  const std::shared_ptr<const ProtrusionField> field = field_of_surfaces(solids);
  std::optional<ProtrusionParts> flat = protrusion_parts({space::RaySolid{bars, {}}}, *field, 90);
  ASSERT_TRUE(flat);
  ASSERT_EQ(flat->voids.size(), 1U);
  const RayGrid grid{2, 1, -82, static_cast<std::int64_t>(flat->voids[0].middle.y) - 12, 2, 2, 3, 3};
  const ProtrusionRays rays(
      *std::move(flat), field, Real(90),
      [&](const Real& l) {
        return corner_stretches(bars.points, solids, l, grid, [](const space::Extent&) { return false; });
      },
      grid, 1);
  for (int j = 0; j < grid.nv; ++j) {
    const RayRow row = rays.row(j);
    for (int i = 0; i < grid.nu; ++i) {
      std::vector<double> found;
      for (int e = row.first[std::size_t(i)]; e < row.first[std::size_t(i) + 1]; ++e) {
        const space::RayEvent& event = row.events[std::size_t(e)];
        if (found.size() % 2 == 0 ? event.here <= 0 : event.after > 0) found.push_back(event.at.value);
      }
      ASSERT_EQ(found.size(), 4U);
      EXPECT_LT(found[1], -120);
      EXPECT_GT(found[2], 440);
    }
  }
}

/// A step that holds all of a room while its surface lies in the walls, on the line on which the place that stands for
/// the room is in the plane of the step's face.
TEST(TouchRays, ProtrudesIntoTheVoidBelowAFace) {
  const Both room(space::around(Cells{{0, 0, 0}}, 3), space::stretch(100));
  const space::Triangles step =
      space::surface({{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}, {{{150, 0, 0}, {0, 150, 0}, {0, 0, 200}}});
  const std::vector<space::RaySolid> solids{space::RaySolid{room.surface, {}}};
  const std::shared_ptr<const ProtrusionField> field = field_of_surfaces(solids);
  std::optional<ProtrusionParts> flat = protrusion_parts({space::RaySolid{step, {}}}, *field, 20);
  ASSERT_TRUE(flat);
  ASSERT_EQ(flat->voids.size(), 1U);
  constexpr std::int64_t kParts = 1 << 26;
  const double u = (flat->voids[0].middle.x - 150) * double(kParts);
  ASSERT_EQ(u, std::floor(u));
  const RayGrid grid{2, kParts, std::int64_t(u), -25 * kParts, kParts, kParts, 1, 1};
  const ProtrusionRays rays(
      *std::move(flat), field, Real(20),
      [&](const Real& l) {
        return corner_stretches(step.points, solids, l, grid, [](const space::Extent&) { return false; });
      },
      grid, 1);
  EXPECT_TRUE(rays.row(0).events.empty());
}

/// Two slabs that overlap hold all of a room together: a line enters the second one before it leaves the first.
TEST(TouchRays, ProtrudesWhereTwoOverlap) {
  const Both room(space::around(Cells{{0, 0, 0}}, 3), space::stretch(100));
  const Cells one{{0, 0, 0}};
  space::Triangles low = space::surface(one, {{{240, 0, 9}, {0, 240, 5}, {7, 3, 150}}}), high = low;
  for (space::Point& p : high.points) p = p + space::Point{2, 3, 60};
  const std::vector<space::RaySolid> solids{space::RaySolid{room.surface, {}}},
      both{space::RaySolid{low, {}}, space::RaySolid{high, {}}};
  const std::shared_ptr<const ProtrusionField> field = field_of_surfaces(solids);
  std::optional<ProtrusionParts> flat = protrusion_parts(both, *field, 20);
  ASSERT_TRUE(flat);
  ASSERT_EQ(flat->voids.size(), 1U);
  std::vector<space::Point> corners = low.points;
  corners.insert(corners.end(), high.points.begin(), high.points.end());
  const RayGrid grid{2, 1, -70, -70, 1, 1, 1, 1};
  const ProtrusionRays rays(
      *std::move(flat), field, Real(20),
      [&](const Real& l) {
        return corner_stretches(corners, solids, l, grid, [](const space::Extent&) { return false; });
      },
      grid, 1);
  const RayRow row = rays.row(0);
  EXPECT_LT(space::sign_at(row, 0, Real(-270)), 0);
  for (int z = -120; z <= 20; z += 10) EXPECT_GT(space::sign_at(row, 0, Real(z)), 0) << z;
  EXPECT_LT(space::sign_at(row, 0, Real(150)), 0);
}

}  // namespace distance_touch_rays
}  // namespace findspace::distance
