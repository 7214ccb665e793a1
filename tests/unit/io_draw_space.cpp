// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The picture of a map of boxes: what is drawn heavy or in a second colour, and a legend of what is to be seen only.

#include <gtest/gtest.h>

#include "io/draw/draw_space.h"

namespace findspace::io {
namespace io_draw_space {

using exact::Real;
using space::BoxComplex;
using space::Interval;
using space::IntervalBox;

Interval closed(int from, int to) { return {Real(from), Real(to), true, true}; }

std::string picture(std::vector<IntervalBox> boxes, bool with_fixed) {
  const BoxComplex region = BoxComplex::of_boxes(boxes);
  SpacePicture p{"Positions", "a < b", "mm", &region, {}, {}, Real(1)};
  if (with_fixed)
    p.fixed.push_back(
        {"shelf & side", BoxComplex::of_boxes(std::vector<IntervalBox>{{closed(0, 1), closed(0, 1), closed(0, 1)}})});
  return space_svg(p);
}

bool says(const std::string& svg, const char* text) { return svg.find(text) != std::string::npos; }

TEST(SpacePicture, LegendNamesWhatIsSeen) {
  const std::string solid = picture({{closed(0, 4), closed(0, 4), closed(0, 4)}}, false);
  EXPECT_TRUE(says(solid, "the border of solid parts"));
  EXPECT_FALSE(says(solid, "in a plane only"));
  EXPECT_FALSE(says(solid, "on a line only"));
  EXPECT_FALSE(says(solid, "single positions"));
  EXPECT_FALSE(says(solid, "fixed shapes"));
  const std::string thin = picture({{closed(0, 4), closed(0, 4), closed(2, 2)},
                                    {closed(6, 6), closed(0, 4), closed(2, 2)},
                                    {closed(8, 8), closed(0, 0), closed(2, 2)}},
                                   true);
  EXPECT_FALSE(says(thin, "the border of solid parts"));
  EXPECT_TRUE(says(thin, "in a plane only"));
  EXPECT_TRUE(says(thin, "on a line only"));
  EXPECT_TRUE(says(thin, "single positions"));
  EXPECT_TRUE(says(thin, "fixed shapes"));
}

TEST(SpacePicture, ShapesHaveNamesAndAxesTicks) {
  const std::string svg = picture({{closed(0, 4), closed(0, 4), closed(0, 4)}}, true);
  EXPECT_TRUE(says(svg, ">shelf &amp; side<"));
  for (const char* axis : {">x, mm<", ">y, mm<", ">z, mm<", ">4<", ">1<"}) EXPECT_TRUE(says(svg, axis)) << axis;
}

TEST(SpacePicture, TextIsEscaped) {
  EXPECT_TRUE(says(picture({{closed(0, 4), closed(0, 4), closed(0, 4)}}, false), "a &lt; b"));
}

}  // namespace io_draw_space
}  // namespace findspace::io
