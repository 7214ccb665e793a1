// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Sign maps on rays at any level against the values of the same distances, which a search finds (solid_pair.h): at
// every event, where the value has to be the level, and between events.
#include <gtest/gtest.h>

#include "distance/rays/ray_signs.h"
#include "distance/solid/solid_pair.h"
#include "findspace/error.h"
#include "space/rays/oblique_line.h"
#include "unit/space_bodies.h"

namespace findspace::distance {
namespace distance_ray_signs {

using exact::Real;
using space::Body;
using space::box_body;
using space::RayGrid;
using space::RayRow;
using space::RealVector;

Body ball(std::int64_t x, std::int64_t y, std::int64_t z, std::int64_t r) {
  Body b;
  b.parts.push_back({std::nullopt, {x, y, z}, Real(r)});
  return b;
}

Body hull(std::vector<space::Point> points) {
  Body b;
  b.parts.push_back({space::Polytope::hull(points), {}, Real()});
  return b;
}

Body octahedron(std::int64_t r) { return hull({{r, 0, 0}, {-r, 0, 0}, {0, r, 0}, {0, -r, 0}, {0, 0, r}, {0, 0, -r}}); }

/// Place z on line (i, j).
RealVector place_of(const RayGrid& grid, int i, int j, const Real& z) {
  if (grid.oblique) return space::along(grid.oblique->origin, z, grid.oblique->frame[2]);
  RealVector p;
  const auto axis = static_cast<std::size_t>(grid.axis);
  p[(axis + 1) % 3] = Real::ratio(grid.u_at(i), grid.parts);
  p[(axis + 2) % 3] = Real::ratio(grid.v_at(j), grid.parts);
  p[axis] = z / Real(grid.parts);
  return p;
}

struct Counts {
  int events = 0, places = 0, wrong = 0, unknown = 0;
};

void compare(const char* name, const Body& b, const Body& a, Which which, const Real& level, const RayGrid& grid,
             Counts& counts) {
  const auto rays = ray_sign_map(which, level, b, a, grid);
  const PairDistances pair = solid_pair(space::shared(b), space::shared(a));
  const auto ask = [&](int i, int j, const Real& z, int sign, bool event) {
    const RealVector p = place_of(grid, i, j, z);
    std::optional<Answer> v;
    try {
      v = pair.value(which, p);
    } catch (const Error& e) {
      ASSERT_EQ(e.code(), ErrorCode::kUnsupported) << e.what();
      ++counts.unknown;
      return;
    }
    ++(event ? counts.events : counts.places);
    const int truth = v ? (v->minus_infinity ? -1 : exact::compare(v->value, level)) : 1;
    if (truth == sign || ++counts.wrong > 5) return;
    ADD_FAILURE() << name << " " << static_cast<int>(which) << " at level " << level.text() << ", " << p[0].text()
                  << " " << p[1].text() << " " << p[2].text() << ": " << sign << ", should be " << truth << ", value "
                  << (v ? v->value.text() : "none");
  };
  for (int j = 0; j < grid.nv; ++j) {
    const RayRow row = rays->row(j);
    ASSERT_EQ(row.first.size(), static_cast<std::size_t>(grid.nu) + 1);
    for (int i = 0; i < grid.nu; ++i) {
      int before = row.before[static_cast<std::size_t>(i)];
      Real below(-40 * grid.parts);
      for (int e = row.first[static_cast<std::size_t>(i)]; e < row.first[static_cast<std::size_t>(i) + 1]; ++e) {
        const auto& event = row.events[static_cast<std::size_t>(e)];
        const Real at = event.at.to_real();
        // Between events a place of few digits will do; at events of nested roots the value would take long.
        if (at.is_closed()) ask(i, j, at, event.here, true);
        const double gap = event.at.value - below.to_double();
        if (gap > 0) ask(i, j, Real::from_double(below.to_double() + gap * 0.375), before, false);
        before = event.after;
        below = at;
      }
      ask(i, j, Real::from_double(below.to_double() + 3.25), before, false);
    }
  }
}

const Body kRoom = box_body({{{{0, 0, 0}, {6, 2, 4}}}, {{{0, 0, 0}, {2, 6, 4}}}});
const Body kChannel = box_body({{{{0, 0, 0}, {1, 6, 4}}}, {{{2, 0, 0}, {3, 6, 4}}}, {{{0, 0, -1}, {3, 6, 0}}}});
const Body kRooms = box_body({{{{0, 0, 0}, {4, 4, 4}}}, {{{4, 1, 1}, {7, 3, 2}}}, {{{10, 0, 0}, {11, 1, 1}}}});
const Body kCube = box_body({{{{0, 0, 0}, {1, 1, 1}}}});
const Body kTetrahedron = hull({{0, 0, 0}, {6, 0, 0}, {0, 6, 0}, {0, 0, 6}});

/// Lines at halves and whole numbers, along edges and walls; thirds are in general position.
RayGrid grid_of(int axis, std::int64_t parts, int n) {
  return {axis, parts, -3 * parts + 1 - parts % 2, -2 * parts, 3, 5, n, n};
}

TEST(RaySigns, BoxesAtAllLevels) {
  Counts counts;
  for (const Real& level : {Real(-1), Real::ratio(-1, 2), Real(0), Real(1), Real::ratio(5, 2)}) {
    for (const Which which : {Which::kGamma1, Which::kEta1, Which::kDelta1, Which::kEta2}) {
      compare("channel", kCube, kChannel, which, level, grid_of(2, 3, 5), counts);
      compare("rooms", kCube, kRooms, which, level, grid_of(0, 2, 6), counts);
    }
  }
  EXPECT_GT(counts.events, 100);
  EXPECT_EQ(counts.unknown, 0);
}

TEST(RaySigns, SlantedSolids) {
  Counts counts;
  for (const Real& level : {Real(-1), Real(0), Real(1)}) {
    for (std::size_t k = 0; k < kWhichCount; ++k)
      compare("tetrahedron", octahedron(1), kTetrahedron, Which(k), level, grid_of(1, 2, 4), counts);
    for (const Which which : {Which::kGamma1, Which::kEta1, Which::kDstarBack})
      compare("room", octahedron(1), kRoom, which, level, grid_of(2, 2, 4), counts);
  }
  EXPECT_GT(counts.events, 100);
  EXPECT_EQ(counts.unknown, 0);
}

TEST(RaySigns, Balls) {
  Counts counts;
  Body two = ball(0, 0, 0, 3);
  two.parts.push_back(ball(4, 0, 0, 2).parts[0]);
  for (const Real& level : {Real(-1), Real(0), Real(2)}) {
    for (std::size_t k = 0; k < kWhichCount; ++k) {
      compare("ball in ball", ball(0, 0, 0, 1), ball(0, 1, 0, 3), Which(k), level, grid_of(2, 2, 5), counts);
      if (level.sign() > 0 && (Which(k) == Which::kEta1 || Which(k) == Which::kDstarBack)) continue;
      if (Which(k) == Which::kEta2 || Which(k) == Which::kDelta2) continue;
      compare("cube in ball", kCube, ball(0, 0, 0, 3), Which(k), level, grid_of(2, 2, 5), counts);
    }
    compare("ball, tetrahedron", ball(1, 1, 1, 1), kTetrahedron, Which::kGamma1, level, grid_of(0, 2, 5), counts);
    compare("ball, tetrahedron", ball(1, 1, 1, 1), kTetrahedron, Which::kMu, level, grid_of(0, 2, 5), counts);
    compare("ball, box", ball(0, 0, 0, 1), box_body({{{{-3, -3, -3}, {3, 3, 1}}}}), Which::kEta1, level,
            grid_of(0, 2, 5), counts);
    if (level.sign() >= 0) compare("ball, two", ball(0, 0, 0, 1), two, Which::kGamma1, level, grid_of(1, 2, 5), counts);
  }
  EXPECT_GT(counts.events, 100);
}

/// Lines that are parallel to no axis; some go along faces and through corners.
TEST(RaySigns, LinesInAnyDirection) {
  Counts counts;
  const auto line = [](RealVector through, std::int64_t dx, std::int64_t dy, std::int64_t dz) {
    RayGrid grid{2, 1, 0, 0, 1, 1, 1, 1};
    grid.oblique =
        std::make_shared<const space::ObliqueLine>(std::move(through), RealVector{Real(dx), Real(dy), Real(dz)});
    return grid;
  };
  const std::vector<RayGrid> lines{line({Real(1), Real(0), Real(0)}, 1, 1, 2), line({Real(), Real(), Real()}, 1, 1, -1),
                                   line({Real::ratio(1, 3), Real(3), Real(-2)}, 0, -1, 1),
                                   line({Real(6), Real(), Real()}, -1, 1, 0)};
  for (const RayGrid& grid : lines) {
    for (const Real& level : {Real::ratio(-1, 2), Real(0), Real(1)}) {
      for (const Which which : {Which::kGamma1, Which::kEta1, Which::kGamma2}) {
        compare("channel", kCube, kChannel, which, level, grid, counts);
        compare("room", octahedron(1), kRoom, which, level, grid, counts);
        compare("tetrahedron", octahedron(1), kTetrahedron, which, level, grid, counts);
      }
      compare("ball", kCube, ball(1, 0, 1, 2), Which::kGamma1, level, grid, counts);
    }
  }
  EXPECT_GT(counts.events, 80);
  EXPECT_GT(counts.places, 200);
  EXPECT_EQ(counts.unknown, 0);
}

/// The greatest distance of points between two vertices of a part of B + p to A, a union of balls; negative inside.
double protrudes_about(const Body& b, const Body& a, const space::Vector& p) {
  double most = -100;
  for (const space::BodyPart& part : b.parts) {
    for (const space::Point& v : part.vertices()) {
      for (const space::Point& w : part.vertices()) {
        for (int k = 0; k <= 32; ++k) {
          const space::Vector x = space::plus(
              p, space::plus(space::scaled(k / 32.0, exact::approx(v)), space::scaled(1 - k / 32.0, exact::approx(w))));
          double least = 100;
          for (const space::BodyPart& t : a.parts)
            least = std::min(least, space::length(x - exact::approx(t.center)) - t.radius.to_double());
          most = std::max(most, least);
        }
      }
    }
  }
  return most;
}

/// mu to shapes that are not convex: by a search, which leaves the sign 0 near the level only.
TEST(RaySigns, ProtrudesOfAUnion) {
  Body two = ball(0, 0, 0, 3);
  two.parts.push_back(ball(4, 0, 0, 2).parts[0]);
  const Body bar = hull({{0, 0, 0}, {5, 1, 0}, {5, 0, 1}, {0, 2, 2}});
  int asked = 0, zero = 0, inside = 0;
  const auto check = [&](const char* name, const Body& b, const Body& a, Which which, const Real& level,
                         const RayGrid& grid) {
    const auto rays = ray_sign_map(which, level, b, a, grid);
    const PairDistances pair = solid_pair(space::shared(b), space::shared(a));
    for (int j = 0; j < grid.nv; ++j) {
      const RayRow row = rays->row(j);
      for (int i = 0; i < grid.nu; ++i) {
        std::vector<double> places;
        for (int e = row.first[static_cast<std::size_t>(i)]; e < row.first[static_cast<std::size_t>(i) + 1]; ++e) {
          const double at = row.events[static_cast<std::size_t>(e)].at.value;
          for (const double by : {0.0, 0x1p-20, -0x1p-20, 0.125}) places.push_back(at + by);
        }
        for (double z = -9.5; z < 10; z += 3.25) places.push_back(z);
        for (const double z : places) {
          const RealVector p = place_of(grid, i, j, Real::from_double(z));
          const int sign = space::sign_at(row, i, Real::from_double(z));
          ++asked;
          if (sign < 0) ++inside;
          if (sign == 0) ++zero;
          std::optional<Answer> v;
          try {
            v = pair.value(which, p);
          } catch (const Error&) {  // no depth in round parts: by samples of B less than 0.2 apart
            const double out = protrudes_about(b, a, space::rounded(p));
            EXPECT_TRUE(sign > 0 ? out > -0.2 : out < 0x1p-24) << name << " protrudes by about " << out;
            continue;
          }
          const double over = v->value.to_double() - level.to_double();
          EXPECT_TRUE(sign == 0  ? std::fabs(over) < 0x1p-24
                      : sign < 0 ? over < 0x1p-36
                                 : over > -0x1p-36)
              << name << " level " << level.text() << " at " << p[0].text() << " " << p[1].text() << " " << p[2].text()
              << ": sign " << sign << ", value less level " << over;
        }
      }
    }
  };
  for (const Real& level : {Real::ratio(1, 2), Real(1), Real::ratio(5, 2)}) {
    check("room", bar, kRoom, Which::kMu, level, grid_of(2, 2, 4));
    check("channel", octahedron(2), kChannel, Which::kMu, level, grid_of(0, 2, 4));
    check("channel", octahedron(2), kChannel, Which::kHausdorff, level, grid_of(1, 2, 4));
    check("two balls", bar, two, Which::kMu, level, grid_of(2, 2, 4));
  }
  check("two balls", kCube, two, Which::kMu, Real(), grid_of(1, 2, 6));
  check("ball, room", ball(1, 0, 0, 2), kRoom, Which::kMu, Real(1), grid_of(2, 2, 4));
  check("ball, channel", ball(0, 0, 0, 2), kChannel, Which::kHausdorff, Real(3), grid_of(1, 2, 4));
  check("ball, two balls", ball(1, 1, 0, 2), two, Which::kMu, Real(1), grid_of(0, 2, 4));
  EXPECT_GT(asked, 1000);
  EXPECT_GT(inside, 200);
  EXPECT_GT(zero, 20);
}

/// The ball of radius 1 fits into the corridor of width 2 along its middle only.
TEST(RaySigns, ExactFitOfABall) {
  const RayGrid grid{2, 1, 1, 1, 1, 1, 5, 1};  // x = 1 .. 5, y = 1
  const auto rays = ray_sign_map(Which::kEta1, Real(0), ball(0, 0, 0, 1), kRoom, grid);
  const RayRow row = rays->row(0);
  for (int i = 0; i < 5; ++i) {
    ASSERT_EQ(row.first[static_cast<std::size_t>(i) + 1] - row.first[static_cast<std::size_t>(i)], 2);
    const auto* e = &row.events[static_cast<std::size_t>(row.first[static_cast<std::size_t>(i)])];
    EXPECT_EQ(e[0].at.to_real(), Real(1));
    EXPECT_EQ(e[1].at.to_real(), Real(3));
    EXPECT_EQ(e[0].after, 0);
    EXPECT_EQ(e[1].after, 1);
  }
}

}  // namespace distance_ray_signs
}  // namespace findspace::distance
