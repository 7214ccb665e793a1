// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <gtest/gtest.h>

#include "plane/query/locate_line.h"
#include "plane_topology_sets.h"

namespace findspace::plane {
namespace plane_locate_line {

using exact::Real;

/// "[0,3] (6,9)": as people write intervals.
std::string text(const std::vector<LineInterval>& intervals) {
  std::string out;
  for (const LineInterval& i : intervals) {
    if (!out.empty()) out += " ";
    out += (i.from_in ? "[" : "(") + (i.from ? i.from->text() : "-inf") + ",";
    out += (i.to ? i.to->text() : "inf") + (i.to_in ? "]" : ")");
  }
  return out;
}

TEST(Line, EmptyAndPlane) {
  EXPECT_EQ(text(along_line(Region::uniform(0), {1, 2}, {3, 4})), "");
  EXPECT_EQ(text(along_line(Region::uniform(1), {1, 2}, {3, 4})), "(-inf,inf)");
}

TEST(Line, AcrossABox) {
  Region s = box(0, 0, 4, 4);
  EXPECT_EQ(text(along_line(s, {-1, 2}, {1, 0})), "[1,5]");
  EXPECT_EQ(text(along_line(interior(s), {-1, 2}, {1, 0})), "(1,5)");
  EXPECT_EQ(text(along_line(complement(s), {-1, 2}, {1, 0})), "(-inf,1) (5,inf)");
  EXPECT_EQ(text(along_line(s, {-1, 2}, {-1, 0})), "[-5,-1]");
}

TEST(Line, AlongAnEdgeAndThroughACorner) {
  Region s = box(0, 0, 4, 4);
  EXPECT_EQ(text(along_line(s, {0, 4}, {1, 0})), "[0,4]");
  EXPECT_EQ(text(along_line(interior(s), {0, 4}, {1, 0})), "");
  EXPECT_EQ(text(along_line(s, {-3, 4}, {3, 4})), "");
  EXPECT_EQ(text(along_line(s, {-3, 0}, {3, 4})), "[5,5]");
}

TEST(Line, CracksPuncturesAndPoints) {
  Region s = (box(0, 0, 10, 4) - segment({3, 0}, {3, 4})) - point(7, 2) + point(20, 2);
  EXPECT_EQ(text(along_line(s, {0, 2}, {1, 0})), "[0,3) (3,7) (7,10] [20,20]");
}

TEST(Line, CircleSecantAndTangent) {
  Region d = disc(0, 0, 5);
  EXPECT_EQ(text(along_line(d, {0, 3}, {1, 0})), "[-4,4]");
  EXPECT_EQ(text(along_line(d, {0, 5}, {1, 0})), "[0,0]");
  EXPECT_EQ(text(along_line(d, {5, -7}, {0, 1})), "[7,7]");
  EXPECT_EQ(text(along_line(interior(d), {0, 5}, {1, 0})), "");
  EXPECT_EQ(text(along_line(d, {-1, -1}, {1, 1})),
            "[" + (sqrt(Real(2)) - Real(5)).text() + "," + (sqrt(Real(2)) + Real(5)).text() + "]");
}

}  // namespace plane_locate_line
}  // namespace findspace::plane
