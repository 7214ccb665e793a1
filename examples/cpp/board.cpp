// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A board with 100 obstacles: where a chip can go, walked edge by edge.
#include <findspace/findspace.h>

#include <cmath>
#include <cstdio>
#include <string>

int main() {
  using namespace findspace;
  using namespace findspace::words;
  std::map<std::string, Shape> shapes{{"board", Shape::box({0, 0}, {100, 100})},
                                      {"chip", Shape::box({"-1.5", -1}, {"1.5", 1})}};
  Formula where = inside("chip", "board", 1);
  for (int k = 0; k < 100; ++k) {
    const std::string name = "c" + std::to_string(k);
    shapes.emplace(name, Shape::disc({10 * (k % 10) + 5, 10 * (k / 10) + 5 + k % 3}, 2 + k % 2));
    where = where && clear("chip", name, "0.5 mm");
  }
  const World world(shapes, "chip", {.unit = "mm"});
  const Region region = world.solve(where);
  double length = 0;
  std::size_t arcs = 0, rings = 0;
  for (const Region::Component& part : region.components())
    for (const Region::Ring& ring : part.rings) {
      ++rings;
      for (const Region::Side& side : ring) {
        const Region::Edge& e = region.edges()[side.edge];
        const Position a = region.vertices()[e.start].at, b = region.vertices()[e.end].at;
        length += e.arc ? e.radius * e.angle : std::hypot(b[0] - a[0], b[1] - a[1]);
        arcs += e.arc;
      }
    }
  std::printf("%zu parts, %zu rings, %zu arcs, area %.3f, boundary %.3f\n", region.components().size(), rings, arcs,
              *region.area(), length);
}
