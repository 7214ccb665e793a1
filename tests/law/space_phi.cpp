// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The properties of Phi-functions (phi.md 9) on random pairs. Numbers in the names are those of that section.
#include <findspace/error.h>
#include <gtest/gtest.h>

#include <cmath>

#include "differential/space_oracle.h"
#include "space/phi/axis_scan.h"
#include "space/phi/depth_grid.h"
#include "space/phi/phi_exact.h"
#include "space/phi/phi_union.h"
#include "space/phi/plane_scan.h"

namespace findspace::space {
namespace space_phi {

constexpr int kRounds = 300;

/// A position on a quarter grid about A - B: many exact contacts, many ties.
Vector draw(RandomPolytopes& random, const PhiFunction& phi) {
  const auto count = phi.surface().vertex_count();
  const Point p = phi.surface().vertices()[random.pick(0, count - 1)],
              q = phi.surface().vertices()[random.pick(0, count - 1)];
  const auto mix = [&](std::int64_t a, std::int64_t b) {
    return (static_cast<double>(a) + static_cast<double>(b)) / 2 + static_cast<double>(random.pick(-4, 4)) / 4;
  };
  return {mix(p.x, q.x), mix(p.y, q.y), mix(p.z, q.z)};
}

RealVector real(const Vector& u) {
  return {exact::Real::from_double(u.x), exact::Real::from_double(u.y), exact::Real::from_double(u.z)};
}

Vector minus(const Vector& u) { return {-u.x, -u.y, -u.z}; }

TEST(PhiLaws, SwapAndTransposedContacts_3_4) {
  RandomPolytopes random(11);
  for (int round = 0; round < kRounds; ++round) {
    const auto [a, b] = random.pair();
    const PhiFunction ab(a, b), ba(b, a);
    auto there = plain(ab.surface(), true), back = plain(ba.surface(), true);
    for (PlainFacet& f : back) {
      f.plane.normal = -f.plane.normal;
      for (Point& p : f.circuit) p = -p;
      std::reverse(f.circuit.begin(), f.circuit.end());  // reflection rotates the sense about the outward normal
      std::reverse(f.contact.begin(), f.contact.end());
      f.circuit = from_smallest(f.circuit);
    }
    std::sort(back.begin(), back.end());
    ASSERT_TRUE(there == back);
    for (int i = 0; i < 20; ++i) {
      const Vector u = draw(random, ab);
      ASSERT_EQ(ab.sign(u), ba.sign(minus(u)));
      ASSERT_NEAR(ab.max_form(u), ba.max_form(minus(u)), 2 * ab.error_bound(u));
      ASSERT_NEAR(ab.normalised(u), ba.normalised(minus(u)), 0x1p-40 * (1 + ab.error_bound(u) * 0x1p49));
    }
  }
}

TEST(PhiLaws, TranslationOfBothBodies_1) {
  RandomPolytopes random(12);
  for (int round = 0; round < kRounds; ++round) {
    const auto [a, b] = random.pair();
    const Point t{random.pick(-99, 99), random.pick(-99, 99), random.pick(-99, 99)};
    ASSERT_EQ(plain(ContactSurface(a, b), true), plain(ContactSurface(a.translated(t), b.translated(t)), true));
  }
}

TEST(PhiLaws, MirrorImageDoubles_13) {
  RandomPolytopes random(13);
  for (int round = 0; round < kRounds; ++round) {
    const Polytope a = random.next();
    const ContactSurface s(a, a.mirrored());
    ASSERT_EQ(s.facet_count(), a.facet_count());
    for (int f = 0; f < s.facet_count(); ++f) ASSERT_EQ(s.contact(f), Contact::kFF);
  }
}

TEST(PhiLaws, ExactAndFastAgree_FormsOrdered_9) {
  RandomPolytopes random(14);
  int contacts = 0;
  for (int round = 0; round < kRounds; ++round) {
    const auto [a, b] = random.pair();
    const PhiFunction phi(a, b);
    for (int i = 0; i < 20; ++i) {
      const Vector u =
          i < 15 ? draw(random, phi) : phi.vertex(static_cast<int>(random.pick(0, phi.surface().vertex_count() - 1)));
      const PhiAt at = phi_at(phi, real(u));
      const double form = phi.max_form(u), normal = phi.normalised(u);
      ASSERT_EQ(phi.sign(u), at.state == State::kOverlap ? -1 : at.state == State::kApart ? 1 : 0);
      ASSERT_EQ(phi.active(u), at.active);
      ASSERT_NEAR(form, at.max_form, phi.error_bound(u));
      ASSERT_LE(form, normal);
      if (at.state == State::kApart) {
        ASSERT_NEAR(normal, at.distance, 0x1p-40 * (1 + phi.error_bound(u) * 0x1p49));
      }
      contacts += at.state == State::kContact;
      const Vector g = phi.gradient(u), h = phi.normalised_gradient(u);
      ASSERT_NEAR(dot(g, g), 1, 1e-12);
      ASSERT_NEAR(dot(h, h), 1, 1e-12);
    }
  }
  EXPECT_GT(contacts, 500);
}

TEST(PhiLaws, LipschitzAndConvex_8) {
  RandomPolytopes random(15);
  for (int round = 0; round < kRounds; ++round) {
    const auto [a, b] = random.pair();
    const PhiFunction phi(a, b);
    for (int i = 0; i < 10; ++i) {
      const Vector u = draw(random, phi), v = draw(random, phi);
      const Vector half{(u.x + v.x) / 2, (u.y + v.y) / 2, (u.z + v.z) / 2}, d = u - v;
      const double slack = 0x1p-40 * (1 + phi.error_bound(u) * 0x1p49);
      ASSERT_LE(std::fabs(phi.normalised(u) - phi.normalised(v)), std::sqrt(dot(d, d)) + slack);
      ASSERT_LE(std::fabs(phi.max_form(u) - phi.max_form(v)), std::sqrt(dot(d, d)) + slack);
      ASSERT_LE(2 * phi.normalised(half), phi.normalised(u) + phi.normalised(v) + slack);
    }
  }
}

TEST(PhiLaws, Leaving_By_The_Penetration_Depth_Ends_In_Contact_2_2) {
  RandomPolytopes random(16);
  for (int round = 0; round < kRounds; ++round) {
    const auto [a, b] = random.pair();
    const PhiFunction phi(a, b);
    const Vector u = draw(random, phi), t = phi.penetration_depth(u);
    if (phi.sign(u) >= 0) continue;
    ASSERT_NEAR(phi.max_form({u.x + t.x, u.y + t.y, u.z + t.z}), 0, 4 * phi.error_bound(u));
    const double depth = phi.depth(u);
    ASSERT_NEAR(dot(t, t), depth * depth, 1e-9 * (1 + depth * depth));
  }
}

TEST(PhiLaws, TheGridGivesTheSameBits) {
  RandomPolytopes random(17);
  for (int round = 0; round < 60; ++round) {
    const auto [a, b] = random.pair();
    const PhiFunction phi(a, b);
    const DepthGrid grid(phi, 1 + round % 4);
    for (int i = 0; i < 300; ++i) {
      const Vector u = draw(random, phi);
      ASSERT_EQ(grid.max_form(u), phi.max_form(u));
    }
  }
}

TEST(PhiLaws, CuttingABodyChangesNoSign_10) {
  // A box cut by a plane x = c into two; the union has the sign of the uncut box at every position.
  RandomPolytopes random(18);
  for (int round = 0; round < kRounds; ++round) {
    const std::int64_t x = random.pick(2, 9), y = random.pick(1, 9), z = random.pick(1, 9), c = random.pick(1, x - 1);
    std::vector<Point> whole, left, right;
    for (int i = 0; i < 8; ++i) {
      const std::int64_t v = i & 2 ? y : 0, w = i & 4 ? z : 0;
      whole.push_back({i & 1 ? x : 0, v, w});
      left.push_back({i & 1 ? c : 0, v, w});
      right.push_back({i & 1 ? x : c, v, w});
    }
    const Polytope b = random.next();
    const std::vector<Polytope> parts{Polytope::hull(left), Polytope::hull(right)}, bs{b}, uncut{Polytope::hull(whole)};
    const PhiUnion cut(parts, bs), one(uncut, bs);
    for (int i = 0; i < 20; ++i) {
      const Vector u = draw(random, one.pair(0));
      ASSERT_EQ(cut.sign(u), one.sign(u));
      ASSERT_EQ(cut.sign_at(real(u)), one.sign(u));
      ASSERT_GE(cut.max_form(u), one.max_form(u) - 2 * one.pair(0).error_bound(u));
      if (one.sign(u) > 0) {
        ASSERT_NEAR(cut.normalised(u), one.normalised(u), 1e-9 * (1 + one.normalised(u)));
      }
    }
  }
}

TEST(PhiLaws, EveryKindOfRegistersGivesTheSameBits) {
  RandomPolytopes random(19);
  std::size_t ties = 0;
  for (int round = 0; round < kRounds; ++round) {
    const auto [a, b] = random.pair();
    const PhiFunction phi(a, b);
    for (int i = 0; i < 20; ++i) {
      const Vector u = draw(random, phi);
      Highest one_by_one{phi.plane_value(0, u), 0};
      for (int f = 1; f < phi.surface().facet_count(); ++f) {
        ties += phi.plane_value(f, u) == one_by_one.value;
        if (phi.plane_value(f, u) > one_by_one.value) one_by_one = {phi.plane_value(f, u), f};
      }
      for (const VectorUnit unit : vector_units()) {
        const Highest top = scan_planes_on(unit, phi.blocks().data(), phi.blocks().size(), u);
        ASSERT_EQ(top.value, one_by_one.value);
        ASSERT_EQ(top.plane, one_by_one.plane);
      }
    }
  }
  ASSERT_GT(ties, 100U);
}

TEST(PhiLaws, StretchOfALineEndsAtPlanes) {
  RandomPolytopes random(23);
  int met = 0;
  for (int round = 0; round < kRounds; ++round) {
    const auto [a, b] = random.pair();
    const PhiFunction phi(a, b);
    for (int i = 0; i < 10; ++i) {
      const Vector u = draw(random, phi), to = draw(random, phi);
      const double size = length(to - u);
      if (size == 0) continue;
      const Vector way = scaled(1 / size, to - u);
      const LineStretch t = scan_line(phi.blocks().data(), phi.blocks().size(), u, way, 0, 0x1p-40);
      for (const VectorUnit unit : vector_units()) {
        const LineStretch same = scan_line_on(unit, phi.blocks().data(), phi.blocks().size(), u, way, 0, 0x1p-40);
        ASSERT_EQ(same.from, t.from);
        ASSERT_EQ(same.to, t.to);
      }
      if (!(t.from < t.to)) {
        EXPECT_GE(phi.max_form(u), 0);
        continue;
      }
      ++met;
      const double near = 1e-9 * (size + length(u) + length(to));
      const auto value = [&](double at) { return phi.max_form(plus(u, scaled(at, way))); };
      EXPECT_NEAR(value(t.from), 0, near);
      EXPECT_NEAR(value(t.to), 0, near);
      EXPECT_LT(value(0.5 * (t.from + t.to)), near);
    }
  }
  EXPECT_GT(met, kRounds);
}

TEST(PhiLaws, StretchOnAnAxisIsThatOfTheLine) {
  RandomPolytopes random(29);
  constexpr double kShallow = 1e-9, kLevel = 0x1p-40;
  int met = 0;
  for (int round = 0; round < kRounds; ++round) {
    const auto [a, b] = random.pair();
    const PhiFunction phi(a, b);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::vector<HeightBlock> blocks;
      AxisPlanes planes = planes_on_axis(phi.blocks(), axis, kLevel, blocks);
      planes.blocks = blocks.data();
      const Vector way{axis == 0 ? 1.0 : 0, axis == 1 ? 1.0 : 0, axis == 2 ? 1.0 : 0};
      for (int i = 0; i < 10; ++i) {
        const Vector u = draw(random, phi);
        const double x = axis == 0 ? u.y : u.x, y = axis == 2 ? u.y : u.z, here = dot(u, way);
        const LineStretch t = scan_axis(planes, x, y, kShallow);
        for (const VectorUnit unit : vector_units()) {
          const LineStretch same = scan_axis_on(unit, planes, x, y, kShallow);
          ASSERT_EQ(same.from, t.from);
          ASSERT_EQ(same.to, t.to);
        }
        const auto line = [&](double raised) {
          return scan_line(phi.blocks().data(), phi.blocks().size(), u, way, raised, kLevel);
        };
        const LineStretch deep = line(kShallow), whole = line(0);
        if (!(deep.from < deep.to)) continue;
        ++met;
        const double near = 1e-9 * (1 + length(u));
        EXPECT_NEAR(t.from - here, whole.from, near);
        EXPECT_NEAR(t.to - here, whole.to, near);
        EXPECT_GT(t.to - t.from, 2 * kShallow);
      }
    }
  }
  EXPECT_GT(met, kRounds);
}

}  // namespace space_phi
}  // namespace findspace::space
