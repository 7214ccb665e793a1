// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Parts put down one after another on a sheet, each at its lowest place and best angle, and the picture of it.
#include <findspace/findspace.h>

#include <cstdio>
#include <fstream>

int main() {
  using namespace findspace;
  using namespace findspace::words;
  const std::map<std::string, Shape> shapes{
      {"sheet", Shape::box({0, 0}, {16, 30})},
      {"bracket", Shape::polygon(Ring{{0, 0}, {6, 0}, {6, 2}, {2, 2}, {2, 6}, {0, 6}})},
      {"coin", Shape::disc({0, 0}, "1.5")},
      {"bar", Shape::box({0, 0}, {9, 2})}};
  const Demands demands{{Body({"bracket"}, {0, 90, 180, 270}, 4), Body({"coin"}, {0}, 3), Body({"bar"}, {0, 90})},
                        inside("self", "sheet"),
                        clear("self", "other"),
                        {},
                        {"y", "x", "grid"}};
  const Placement layout = place(shapes, demands, {.unit = "mm"});
  for (const Placement::Placed& p : layout.placed())
    std::printf("%s %d at (%g, %g), %g degrees\n", p.body.c_str(), p.copy, (*p.at)[0], (*p.at)[1], p.degrees);
  std::ofstream("nest.svg") << layout.svg();
  std::printf("%s\n", layout.complete() ? "all stand" : "not all fit");
}
