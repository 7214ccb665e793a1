// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What moving windows see (plane/build/swept.h), cell by cell, against looking: the marks of the complex along each
// window, one at a time (plane/query/section.h). And sums with closed and open segments against the convolution
// (plain_sum.h), which knows nothing of windows.
#include <gtest/gtest.h>

#include "findspace/error.h"
#include "law/plane_random.h"
#include "plane/build/swept.h"
#include "plane/offset/plain_sum.h"
#include "plane/query/locate.h"
#include "plane/query/section.h"

namespace findspace::plane {
namespace plane_swept_oracle {

using exact::Real;

/// Marks -1, 0, 1 in no order a distance would have: two random sets laid over each other.
CellComplex random_map(Random& random) {
  const Region a = region_of(random_shape(random, {})), b = region_of(random_shape(random, {}));
  std::vector<const CellComplex*> both{&a, &b};
  const Mark rotation = random.pick(0, 1) ? 1 : -1;
  return overlay(both, [rotation](std::span<const Mark> m) { return Mark(rotation * (m[0] + m[1] - 1)); });
}

Window random_window(Random& random, bool rational) {
  const std::int64_t size = 4;
  GridPoint d{0, 0};
  while (d == GridPoint{0, 0}) d = {random.pick(-size, size), random.pick(-size, size)};
  if (!rational) {
    exact::make_primitive(d.x, d.y);
    const Real from = Real::ratio(random.pick(-6, 6), 2);
    return window_along(d.x, d.y, from, from + Real::ratio(random.pick(1, 12), 2));
  }
  const RealVector from{Real::ratio(random.pick(-8, 8), 2), Real::ratio(random.pick(-8, 8), 2)};
  return window_between(from, from + RealVector{Real::ratio(d.x, 2), Real::ratio(d.y, 2)});
}

Sight look(const CellComplex& m, const Window& w, const RealVector& p) {
  const Section s = section(m, p + w.from, w.to - w.from).between(Real(0), Real(1));
  Sight sight{s.stops.front().at, s.stops.back().at, s.stops.front().after};
  for (std::size_t k = 1; k + 1 < s.stops.size(); ++k)
    sight.inside = std::min({sight.inside, s.stops[k].at, s.stops[k].after});
  return sight;
}

Mark code(const Sight& s) { return Mark(s.start + 1 + 3 * (s.end + 1) + 9 * (s.inside + 1)); }

/// A point inside an edge.
RealVector middle(const CellComplex& c, Index e) {
  auto end = [&](Index v) { return c.geometry.exact(c.vertices[v].point); };
  const RealVector p = end(c.edges[e].v0), q = end(c.edges[e].v1), m = Real::ratio(1, 2) * (p + q);
  if (!c.is_arc(e)) return m;
  const exact::SupportingCurve& k = c.supporting_curve(e);
  const Real dx = m.x - k.center_x();
  return {m.x, k.center_y() + Real(int(c.edges[e].half)) * sqrt(k.w() * k.w() - dx * dx)};
}

std::vector<RealVector> probes(const CellComplex& result, Random& random) {
  std::vector<RealVector> out;
  for (const Vertex& v : result.vertices) out.push_back(result.geometry.exact(v.point));
  for (Index e = 0; e < result.edges.size(); ++e) out.push_back(middle(result, e));
  for (int k = 0; k < 10; ++k)
    out.push_back({Real::ratio(random.pick(-40, 80), 8), Real::ratio(random.pick(-40, 80), 8)});
  std::vector<RealVector> few;
  for (int k = 0; k < 24; ++k) few.push_back(out[std::size_t(random.pick(0, std::int64_t(out.size()) - 1))]);
  return few;
}

void compare_with_looking(bool rational, std::uint64_t rounds) {
  for (std::uint64_t seed = 1; seed <= rounds; ++seed) {
    Random random(seed + (rational ? 0 : 100000));
    const CellComplex m = random_map(random);
    const Window w = random_window(random, rational);
    const CellComplex seen = swept(m, w, code);
    ASSERT_EQ(fault(seen), "") << "seed " << seed;
    for (const RealVector& p : probes(seen, random)) {
      ASSERT_EQ(int(mark_of(seen, locate(seen, p))), int(code(look(m, w, p))))
          << "seed " << seed << " window along " << w.dx << "," << w.dy << " at " << p.x.text() << ", " << p.y.text();
    }
  }
}

TEST(Swept, SeesWhatIsThere) { compare_with_looking(true, 300); }
TEST(Swept, SeesWhatIsThereAtIrrationalEnds) { compare_with_looking(false, 80); }

TEST(Swept, IsThePlainSumWithASegment) {
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    Random random(seed + 500);
    const Region s = region_of(random_shape(random, {}));
    const GridPoint p = random.point(3), q{p.x + random.pick(-2, 2), p.y + random.pick(1, 3)};
    const Region segment = region_of(chain_of({p, q}));
    const RealVector from{Real(-q.x), Real(-q.y)}, to{Real(-p.x), Real(-p.y)};
    // {s + x : x in [p, q]} = {y : y - x in s}: the window from y - q to y - p.
    const bool open = random.pick(0, 1);
    const Region ends = region_of(points_of({p, q}));
    const Region other = open ? subtract(std::vector<const Region*>{&segment, &ends}) : segment;
    const CellComplex rotated = remark(s, [](Mark m) { return Mark(-m); });
    const Region mine = swept(rotated, window_between(from, to),
                              [open](const Sight& k) { return Mark((open ? k.inside : k.least()) < 0); });
    const Region theirs = plain_sum(s, other);
    ASSERT_TRUE(same_set(mine, theirs)) << "seed " << seed;
    ASSERT_TRUE(same_counts(mine, theirs)) << "seed " << seed;
  }
}

TEST(Swept, AlongAChainSeesTheLeastOfItsLegs) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Random random(seed + 900);
    const CellComplex m = random_map(random);
    std::vector<RealVector> path;
    for (std::int64_t k = random.pick(1, 4); k > 0; --k)
      path.push_back({Real(random.pick(-3, 3)), Real::ratio(random.pick(-6, 6), 2)});
    const CellComplex seen = least_along(m, path);
    for (const RealVector& p : probes(seen, random)) {
      Mark least = mark_of(m, locate(m, p + path[0]));
      for (std::size_t k = 0; k + 1 < path.size(); ++k) {
        if (path[k] == path[k + 1]) continue;
        least = std::min(least, look(m, window_between(path[k], path[k + 1]), p).least());
      }
      ASSERT_EQ(int(mark_of(seen, locate(seen, p))), int(least)) << "seed " << seed;
    }
  }
}

TEST(Swept, RefusesADirectionWithTooManyDigits) {
  const RealVector to{Real(int64_t(1) << 60), Real(1)};
  EXPECT_THROW(window_between({Real(0), Real(0)}, to), Error);
}

}  // namespace plane_swept_oracle
}  // namespace findspace::plane
