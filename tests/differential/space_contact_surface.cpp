// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// gamma12 against the hull of all differences and against the paper's three stages, on 10,000 random pairs.
#include <findspace/error.h>
#include <gtest/gtest.h>

#include "differential/space_oracle.h"

namespace findspace::space {
namespace space_contact_surface {

std::string show(const Polytope& p) {
  std::string text;
  for (const Point& v : p.vertices()) {
    text += "[" + std::to_string(v.x) + "," + std::to_string(v.y) + "," + std::to_string(v.z) + "],";
  }
  return text;
}

TEST(ContactSurface, EqualsTheHullOfAllDifferencesAndTheThreeStages) {
  RandomPolytopes random(20240607);
  for (int round = 0; round < 10000; ++round) {
    const auto [a, b] = random.pair();
    const ContactSurface s(a, b);
    ASSERT_TRUE(plain(s, false) == plain(hull_of_differences(a, b))) << "round " << round << "\n"
                                                                     << show(a) << "\n"
                                                                     << show(b);
    ASSERT_TRUE(plain(s, true) == three_stages(a, b)) << "round " << round << "\n" << show(a) << "\n" << show(b);
    ASSERT_FALSE(s.fault().has_value()) << *s.fault();
  }
}

TEST(ContactSurface, HoldsOnTheWholeGrid) {
  // Coordinates up to 2^40: nothing overflows, the surface is closed and convex.
  RandomPolytopes random(7);
  const std::int64_t big = std::int64_t{1} << 40;
  for (int round = 0; round < 300; ++round) {
    std::vector<Point> p, q;
    for (int i = 0; i < 12; ++i) {
      p.push_back({random.pick(-big, big), random.pick(-big, big), random.pick(-big, big)});
      q.push_back({random.pick(0, 1) ? big : -big, random.pick(0, 1) ? big : -big, random.pick(-big, big)});
    }
    const ContactSurface s(Polytope::hull(p), Polytope::hull(q));
    ASSERT_FALSE(s.fault().has_value()) << *s.fault();
  }
}

}  // namespace space_contact_surface
}  // namespace findspace::space
