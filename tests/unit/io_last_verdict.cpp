// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A layout that is judged several times is verified once.

#include <gtest/gtest.h>

#include "io/api/last_verdict.h"

namespace io_last_verdict {

using namespace findspace;

TEST(LastVerdict, IsOfTheLayoutThatWasAskedOfLast) {
  const io::LastVerdict<packing::Layout, int> last;
  int verified = 0;
  const auto ask = [&](const packing::Layout& layout) { return last.of(layout, [&] { return ++verified; }); };
  packing::Layout one{3, {{0, 1, 90, false, 2, 1, 0}}, {{0, 1, "why"}}};
  EXPECT_EQ(ask(one), 1);
  EXPECT_EQ(ask(one), 1);
  packing::Layout other = one;
  other.items[0].y = packing::Fraction(1, 3);
  EXPECT_EQ(ask(other), 2);
  EXPECT_EQ(ask(one), 3);
  one.left_out[0].copies = 2;
  EXPECT_EQ(ask(one), 4);
  one.sheets.push_back(0);
  EXPECT_EQ(ask(one), 5);
  one.height = 7;
  EXPECT_EQ(ask(one), 6);
}

TEST(LastVerdict, OfSolids) {
  const io::LastVerdict<packing::SolidLayout, int> last;
  int verified = 0;
  const auto ask = [&](const packing::SolidLayout& layout) { return last.of(layout, [&] { return ++verified; }); };
  packing::SolidLayout layout{3, {{0, 1, 2, {0, 1, 2}, 0}}};
  EXPECT_EQ(ask(layout), 1);
  EXPECT_EQ(ask(packing::SolidLayout(layout)), 1);
  layout.items[0].at[2] = 3;
  EXPECT_EQ(ask(layout), 2);
}

}  // namespace io_last_verdict
