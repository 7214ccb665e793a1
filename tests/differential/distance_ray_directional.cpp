// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Sign maps on rays of distances along a direction against their values: of every event and of a place between events
// the value is read off the signs at level 0 on the line through it. Maps of boxes along an axis are asked at the same
// positions.
#include <gtest/gtest.h>

#include <random>

#include "distance/planar/translation_value.h"
#include "distance/rays/ray_directional.h"
#include "distance/rays/ray_directional_least.h"
#include "distance/rays/ray_signs.h"
#include "distance/solid/box_maps.h"
#include "space/rays/oblique_line.h"
#include "unit/space_bodies.h"

namespace findspace::distance {
namespace distance_ray_directional {

using exact::Real;
using space::Body;
using space::box_body;
using space::RayGrid;
using space::RayRow;
using space::RealVector;

struct Case {
  std::string name;
  Which which = Which::kGamma1;
  RealVector direction;
  bool both_ways = true;
  Real level;
};

bool is_farthest(Which which) { return which == Which::kGamma2 || which == Which::kEta2 || which == Which::kDelta2; }

Which base_of(Which which) {
  return which == Which::kGamma2   ? Which::kGamma1
         : which == Which::kEta2   ? Which::kEta1
         : which == Which::kDelta2 ? Which::kDelta1
                                   : which;
}

/// The sign of the value at p less the level.
int sign_of_value(const Case& c, const Body& b, const Body& a, const RealVector& p) {
  RayGrid grid{2, 1, 0, 0, 1, 1, 1, 1};
  grid.oblique = std::make_shared<const space::ObliqueLine>(p, c.direction);
  const auto rays = ray_sign_map(base_of(c.which), Real(), b, a, grid);
  const RayRow row = rays->row(0);
  plane::Section line{row.before[0], {}};
  for (const space::RayEvent& e : row.events) line.stops.push_back({e.at.to_real(), e.here, e.after});
  return sign_of(translation_value(line, is_farthest(c.which), c.both_ways), c.level);
}

struct Counts {
  int asked = 0, wrong = 0, negative = 0, zero = 0;
};

void compare_map(const Case& c, const Body& b, const Body& a, const RayGrid& grid, const space::BoxComplex* boxes,
                 Counts& counts) {
  const auto rays = ray_directional_map(c.which, c.level, c.direction, c.both_ways, {b, a}, grid).or_throw();
  const auto ask = [&](int i, int j, const Real& z, int sign) {
    RealVector p;
    const auto axis = static_cast<std::size_t>(grid.axis);
    p[(axis + 1) % 3] = Real::ratio(grid.u_at(i), grid.parts);
    p[(axis + 2) % 3] = Real::ratio(grid.v_at(j), grid.parts);
    p[axis] = z / Real(grid.parts);
    const int truth = sign_of_value(c, b, a, p), by_boxes = boxes != nullptr ? boxes->mark(p) : truth;
    ++counts.asked;
    if (truth < 0) ++counts.negative;
    if (truth == 0) ++counts.zero;
    if ((truth == sign && by_boxes == truth) || ++counts.wrong > 5) return;
    ADD_FAILURE() << c.name << " " << static_cast<int>(c.which) << (c.both_ways ? " along" : " toward") << " at level "
                  << c.level.text() << ", " << p[0].text() << " " << p[1].text() << " " << p[2].text() << ": " << sign
                  << ", by boxes " << by_boxes << ", should be " << truth;
  };
  for (int j = 0; j < grid.nv; ++j) {
    const RayRow row = rays->row(j);
    for (int i = 0; i < grid.nu; ++i) {
      const auto line = static_cast<std::size_t>(i);
      int before = row.before[line];
      Real below(-20 * grid.parts);
      for (int e = row.first[line]; e < row.first[line + 1]; ++e) {
        const auto& event = row.events[static_cast<std::size_t>(e)];
        const Real at = event.at.to_real();
        ask(i, j, at, event.here);
        ask(i, j, Real::from_double(below.to_double() + (event.at.value - below.to_double()) * 0.375), before);
        before = event.after;
        below = at;
      }
      ask(i, j, Real::from_double(below.to_double() + 3.25), before);
    }
  }
}

using Boxes = std::vector<std::array<std::array<std::int64_t, 3>, 2>>;

space::BoxComplex complex_of(const Boxes& boxes) {
  std::vector<space::IntervalBox> out;
  for (const auto& [low, high] : boxes) {
    space::IntervalBox box;
    for (std::size_t k = 0; k < 3; ++k) box[k] = {Real(low[k]), Real(high[k]), true, true};
    out.push_back(box);
  }
  return space::BoxComplex::of_boxes(out);
}

Body body_of(const Boxes& boxes) {
  Body out;
  for (const auto& [low, high] : boxes) {
    std::vector<space::Point> corners;
    for (int k = 0; k < 8; ++k)
      corners.push_back({(k & 1 ? high : low)[0], (k & 2 ? high : low)[1], (k & 4 ? high : low)[2]});
    out.parts.push_back({space::Polytope::hull(corners), {}, Real()});
  }
  return out;
}

constexpr std::array kAll{Which::kGamma1, Which::kGamma2, Which::kEta1, Which::kEta2, Which::kDelta1, Which::kDelta2};

const Boxes kCube{{{{0, 0, 0}, {1, 1, 1}}}};
const Boxes kChannel{{{{0, 0, 0}, {1, 6, 4}}}, {{{2, 0, 0}, {3, 6, 4}}}, {{{0, 0, -1}, {3, 6, 0}}}};
const Boxes kRoom{{{{0, 0, 0}, {6, 2, 4}}}, {{{0, 0, 0}, {1, 6, 4}}}};  // the cube just fits into a corridor of it

TEST(RayDirectional, BoxesAlongAnAxis) {
  Counts counts;
  for (const auto& [name, boxes] : {std::pair{"channel", kChannel}, std::pair{"room", kRoom}}) {
    const BoxMaps pair(complex_of(kCube), complex_of(boxes));
    for (const Which which : kAll) {
      for (const int axis : {0, 1, 2}) {
        for (const int way : {0, 1, -1}) {
          Case c{name, which, {}, way == 0, Real()};
          c.direction[static_cast<std::size_t>(axis)] = Real(way < 0 ? -2 : 2);
          for (const Real& level : {Real(-1), Real::ratio(-1, 2), Real(0), Real(1), Real(3)}) {
            c.level = level;
            const space::BoxComplex map = pair.directional_map(which, level, axis, way).or_throw();
            compare_map(c, body_of(kCube), body_of(boxes), {1, 2, -3, -2, 4, 5, 3, 3}, &map, counts);
          }
        }
      }
    }
  }
  EXPECT_GT(counts.asked, 3000);
  EXPECT_GT(counts.negative, 300);
  EXPECT_GT(counts.zero, 300);
}

TEST(RayDirectional, SlantedSolidsInAnyDirection) {
  Counts counts;
  Body octahedron, tetrahedron;
  const std::vector<space::Point> tips{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
      corners{{0, 0, 0}, {6, 0, 0}, {0, 6, 0}, {0, 0, 6}};
  octahedron.parts.push_back({space::Polytope::hull(tips), {}, Real()});
  tetrahedron.parts.push_back({space::Polytope::hull(corners), {}, Real()});
  const Body room = body_of(kRoom);
  Body outside = room;
  outside.outside = true;
  for (const Which which : kAll) {
    for (const bool both_ways : {true, false}) {
      for (const RealVector& direction : {RealVector{Real(0), Real(0), Real(1)}, RealVector{Real(1), Real(1), Real(0)},
                                          RealVector{Real(1), Real(-2), Real(2)}}) {
        for (const Real& level : {Real(-1), Real(0), Real::ratio(3, 2)}) {
          const Case c{"slanted", which, direction, both_ways, level};
          compare_map(c, octahedron, tetrahedron, {2, 2, 1, -1, 3, 3, 3, 3}, nullptr, counts);
          compare_map(c, octahedron, room, {0, 1, 0, 1, 1, 1, 3, 3}, nullptr, counts);
          compare_map(c, octahedron, outside, {2, 1, 0, 1, 2, 1, 2, 2}, nullptr, counts);
        }
      }
    }
  }
  EXPECT_GT(counts.asked, 2000);
  EXPECT_GT(counts.negative, 200);
  EXPECT_GT(counts.zero, 100);
}

Body ball_of(const space::Point& center, const Real& radius) {
  Body out;
  out.parts.push_back({std::nullopt, center, radius});
  return out;
}

TEST(RayDirectional, RoundSolids) {
  Counts counts;
  const Body ball = ball_of({0, 0, 0}, Real(1)), other = ball_of({1, 2, 1}, Real(2)), cube = body_of(kCube);
  Body rounded = cube, room = body_of(kRoom), slab = body_of({{{{0, 0, 0}, {4, 1, 3}}}});
  rounded.parts[0].radius = Real(1);
  slab.parts[0].radius = Real::ratio(1, 2);
  for (const Which which : {Which::kGamma1, Which::kGamma2}) {
    for (const bool both_ways : {true, false}) {
      for (const RealVector& direction :
           {RealVector{Real(0), Real(0), Real(1)}, RealVector{Real(-2), Real(0), Real(0)},
            RealVector{Real(1), Real(1), Real(0)}, RealVector{Real(1), Real(-2), Real(2)}}) {
        for (const Real& level : {Real(-1), Real(0), Real(1), Real::ratio(3, 2)}) {
          const Case c{"round", which, direction, both_ways, level};
          const RayGrid grid{2, 1, -2, -1, 1, 1, 5, 5}, halves{0, 2, -3, 0, 2, 3, 3, 3};
          compare_map(c, ball, other, grid, nullptr, counts);
          compare_map(c, ball, cube, grid, nullptr, counts);
          compare_map(c, cube, rounded, halves, nullptr, counts);
          compare_map(c, ball, slab, halves, nullptr, counts);
          if (level.sign() >= 0 || which == Which::kGamma2) compare_map(c, ball, room, halves, nullptr, counts);
        }
      }
    }
  }
  EXPECT_GT(counts.asked, 2000);
  EXPECT_GT(counts.negative, 200);
  EXPECT_GT(counts.zero, 100);
}

/// No place of a lattice has less than the least value; where it is taken it is the value, and a little above it there
/// are such places.
TEST(RayDirectional, LeastOfBoxesAlongAnAxis) {
  int attained = 0, infima = 0;
  for (const Boxes& boxes : {kChannel, kRoom}) {
    const BoxMaps pair(complex_of(kCube), complex_of(boxes));
    const Body a = body_of(boxes), b = body_of(kCube);
    for (const Which which : kAll) {
      for (const int axis : {0, 1, 2}) {
        for (const int way : {0, 1, -1}) {
          const auto least = pair.directional_least(which, axis, way).or_throw();
          if (!least) continue;  // it covers nothing
          Case c{"least", which, {}, way == 0, least->value};
          c.direction[static_cast<std::size_t>(axis)] = Real(way < 0 ? -2 : 2);
          for (int n = 0; n < 40; ++n) {
            const RealVector p = space::place(n * 7 % 19 - 3, n * 5 % 17 - 3, n * 3 % 13 - 3, 2);
            const int sign = sign_of_value(c, b, a, p);
            EXPECT_GE(sign, 0) << static_cast<int>(which) << ' ' << axis << ' ' << way << ' ' << n;
            EXPECT_EQ(sign == 0, least->at.mark(p) != 0) << static_cast<int>(which) << ' ' << axis << ' ' << way;
          }
          ++(least->at.empty() ? infima : attained);
          const auto near = pair.directional_map(which, least->value + Real::ratio(1, 64), axis, way).or_throw();
          EXPECT_FALSE(near.remarked([](space::Mark m) { return space::Mark(m < 0); }).empty());
        }
      }
    }
  }
  EXPECT_GT(attained, 20);
  EXPECT_GT(infima, 5);
}

/// The exact grid of boxes tells the value, and whether a position takes it.
TEST(RayDirectional, LeastOfUnionsOfBoxesAlongAnAxis) {
  std::mt19937 random(7);
  int attained = 0, infima = 0, contacts = 0;
  for (int n = 0; n < 40; ++n) {
    const std::vector<space::Corners> boxes = space::random_boxes(random, 4, 5);
    const std::vector<space::Corners> moving{{{{0, 0, 0}, {1, 1 + n % 2, 1}}}};
    const BoxMaps pair(space::box_set(moving), space::box_set(boxes));
    const Body a = box_body(boxes), b = box_body(moving);
    for (const Which which : {Which::kGamma1, Which::kEta1, Which::kDelta1}) {
      const int axis = n % 3;
      for (const int way : {0, 1, -1}) {
        const auto by_boxes = pair.directional_least(which, axis, way).or_throw();
        RealVector direction;
        direction[static_cast<std::size_t>(axis)] = Real(way < 0 ? -3 : 3);
        const auto least = ray_directional_least(which, direction, way == 0, b, a).or_throw();
        ASSERT_EQ(by_boxes.has_value(), least.has_value()) << n << ' ' << static_cast<int>(which);
        if (!least) continue;
        EXPECT_EQ(least->value, by_boxes->value) << n << ' ' << static_cast<int>(which) << ' ' << way;
        EXPECT_EQ(is_taken(*least), !by_boxes->at.empty()) << n << ' ' << static_cast<int>(which) << ' ' << way;
        if (is_taken(*least)) {
          EXPECT_NE(by_boxes->at.mark(least->at), 0) << n << ' ' << static_cast<int>(which);
        }
        ++(least->value.sign() == 0 ? contacts : is_taken(*least) ? attained : infima);
      }
    }
  }
  EXPECT_GT(attained, 40);
  EXPECT_GT(infima, 80);
  EXPECT_GT(contacts, 10);
}

/// No place of a lattice has less than the least value; where a position takes it that one does.
TEST(RayDirectional, LeastOfSlantedUnions) {
  Body octahedron;
  octahedron.parts.push_back({space::Polytope::hull(std::vector<space::Point>{
                                  {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}),
                              {},
                              Real()});
  std::mt19937 random(3);
  int negative = 0;
  for (int n = 0; n < 12; ++n) {
    const Body a = box_body(space::random_boxes(random, 3, 6));
    const RealVector direction{Real(n % 3 - 1), Real(2), Real(n % 4 - 2)};
    for (const Which which : {Which::kGamma1, Which::kEta1}) {
      const auto least = ray_directional_least(which, direction, true, octahedron, a).or_throw();
      if (!least) continue;
      Case c{"least", which, direction, true, least->value};
      for (int k = 0; k < 150; ++k) {
        const RealVector p = space::place(k * 7 % 29 - 4, k * 5 % 27 - 3, k * 11 % 31 - 4, 4);
        EXPECT_GE(sign_of_value(c, octahedron, a, p), 0) << n << ' ' << static_cast<int>(which);
      }
      if (is_taken(*least)) {
        EXPECT_EQ(sign_of_value(c, octahedron, a, least->at), 0) << n << ' ' << static_cast<int>(which);
      }
      if (least->value.sign() < 0) ++negative;
      c.both_ways = false;
      const auto one_way = ray_directional_least(which, direction, false, octahedron, a).or_throw();
      EXPECT_EQ(one_way->value, Real(2) * least->value);
      EXPECT_EQ(is_taken(*one_way), least->value.sign() == 0);
    }
  }
  EXPECT_GT(negative, 8);
}

/// The bound holds on a lattice, and the place found has nearly as little.
TEST(RayDirectional, LeastOfRoundUnions) {
  std::mt19937 random(11);
  int near = 0, all = 0;
  for (int n = 0; n < 8; ++n) {
    const Body a = box_body(space::random_boxes(random, 3, 6));
    const Body ball = ball_of({0, 0, 0}, n % 2 == 0 ? Real(1) : Real::ratio(1, 2));
    const RealVector direction{Real(1), Real(n % 3 - 1), Real(n % 2)};
    for (const Which which : {Which::kGamma1, Which::kEta1}) {
      const auto tried = ray_directional_least(which, direction, true, ball, a);
      if (!tried || !*tried) continue;
      const Answer& least = **tried;
      const Real lower = *least.bounds().lower, upper = least.value;
      ++all;
      if ((upper - lower).to_double() < 1e-6) ++near;  // no sign: test
      const Case below{"round", which, direction, true, lower};
      for (int k = 0; k < 60; ++k) {
        const RealVector p = space::place(k * 7 % 29 - 4, k * 5 % 27 - 3, k * 11 % 31 - 4, 4);
        EXPECT_GE(sign_of_value(below, ball, a, p), 0) << n << ' ' << static_cast<int>(which);
      }
      const Case above{"round", which, direction, true, upper + Real::from_double(1e-6)};  // no sign: test
      EXPECT_LT(sign_of_value(above, ball, a, least.at), 0) << n << ' ' << static_cast<int>(which);
    }
  }
  EXPECT_GT(all, 8);
  EXPECT_GT(near, all / 2);
}

TEST(RayDirectional, KeepsWhatCoversLeave) {
  using Of = BodiesOnLines::Of;
  const BodiesOnLines pair(body_of({{{{0, 0, 0}, {1, 1, 1}}}}), body_of({{{{0, 0, 0}, {4, 5, 6}}}}));
  for (const Of of : {Of::kOverlap, Of::kOutside, Of::kOutsideBack}) {
    EXPECT_EQ(&pair.cover(of), &pair.cover(of));
    EXPECT_EQ(&pair.rest(of), &pair.rest(of));
  }
  EXPECT_FALSE(pair.cover(Of::kOverlap).beyond);
  EXPECT_TRUE(pair.cover(Of::kOutside).beyond);
  EXPECT_FALSE(pair.cover(Of::kOutside).all);
  EXPECT_TRUE(pair.cover(Of::kOutsideBack).all);  // the larger one does not fit
}

}  // namespace distance_ray_directional
}  // namespace findspace::distance
