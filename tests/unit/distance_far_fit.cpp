// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// How far a union of tetrahedra is from fitting into another: a position far from all that fit takes few cells, and a
// search that may look at too few says what it knows.
#include <gtest/gtest.h>

#include <random>

#include "distance/solid/solid_pair.h"
#include "plane/base/search_work.h"
#include "unit/space_bodies.h"

namespace findspace::distance {
namespace distance_far_fit {

using exact::Real;
using space::Body;
using space::place;
using space::RealVector;

/// Tetrahedra about places of a cube.
Body tetrahedra(int count, std::int64_t cube, std::int64_t reach, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<std::int64_t> middle(0, cube), off(-reach, reach);
  Body out;
  while (static_cast<int>(out.parts.size()) < count) {
    const space::Point at{middle(random), middle(random), middle(random)};
    std::vector<space::Point> corners;
    for (int k = 0; k < 4; ++k) corners.push_back(at + space::Point{off(random), off(random), off(random)});
    space::BodyPart part = space::part_of(corners, Real());
    if (part.core) out.parts.push_back(std::move(part));
  }
  return out;
}

struct Asked {
  TriedAnswer answer;
  long cells;
};

Asked fit_at(const PairDistances& pair, const RealVector& p, long cells = plane::kMostCellsOfQuestion) {
  plane::SearchWork work{cells};
  const plane::ScopedSearchWork here(&work);
  TriedAnswer answer = pair.try_value(Which::kEta1, p);
  return {std::move(answer), cells - work.left};
}

PairDistances crowded() {
  return solid_pair(shared(tetrahedra(20, 1200, 800, 3)), shared(tetrahedra(60, 30000, 20000, 5)));
}

TEST(FarFit, OfManyTetrahedraTakesFewCells) {
  const PairDistances pair = crowded();
  const RealVector p = place(100000, 0, 0);
  const Asked far = fit_at(pair, p);
  ASSERT_TRUE(far.answer && *far.answer);
  EXPECT_LT(far.cells, 60000);
  const Answer& v = **far.answer;
  ASSERT_TRUE(v.proven && v.nearest);
  const RealVector off = space::minus(*v.nearest, p);
  EXPECT_EQ(v.value * v.value, space::dot(off, off));
  EXPECT_EQ((*pair.try_value(Which::kH, *v.nearest))->value.sign(), 0);  // it fits there
  // And nowhere on the way.
  for (int k = 1; k < 40; ++k) {
    const RealVector q = space::along(p, Real::ratio(k, 40), off);
    EXPECT_GT((*pair.try_value(Which::kH, q))->value.sign(), 0) << k;
  }
}

TEST(FarFit, AShortSearchSaysWhatItKnows) {
  const PairDistances pair = crowded();
  const RealVector p = place(100000, 0, 0);
  const Asked all = fit_at(pair, p);
  ASSERT_TRUE(all.answer && *all.answer);
  const Real value = (*all.answer)->value;
  int enclosed = 0;
  for (long cells = 1; cells < all.cells; cells = 1 + cells * 9 / 8) {
    const Asked some = fit_at(pair, p, cells);
    EXPECT_LE(some.cells, cells + 20000) << cells;
    if (!some.answer) {
      EXPECT_NE(std::string(some.answer.refusal().error.what()).find("--work-limit"), std::string::npos);
      continue;
    }
    ASSERT_TRUE(*some.answer) << cells;
    const Enclosure ends = (*some.answer)->bounds();
    EXPECT_LE(*ends.lower, value) << cells;
    EXPECT_GE(*ends.upper, value) << cells;
    enclosed += (*some.answer)->enclosed.has_value();
  }
  EXPECT_GT(enclosed, 0);
}

/// The nearest face of one set is taken where the question may look at no more, too.
TEST(FarFit, AFaceIsTakenWhereNothingIsLeft) {
  const auto block = [](std::int64_t size, int radius) {
    const space::Corners corners{{{0, 0, 0}, {size, size, size}}};
    Body out = space::box_body(std::vector{corners});
    out.parts[0].radius = Real(radius);
    return shared(out);
  };
  const PairDistances pair = solid_pair(block(100, 10), block(1000, 0));
  plane::SearchWork none{0};
  const plane::ScopedSearchWork here(&none);
  const TriedAnswer v = pair.try_value(Which::kGamma1, place(450, 20, 450));
  ASSERT_TRUE(v && *v);
  EXPECT_EQ((*v)->value, Real(-130));
}

}  // namespace distance_far_fit
}  // namespace findspace::distance
