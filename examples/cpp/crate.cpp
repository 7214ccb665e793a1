// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A box, a wedge and a ball in several copies, packed into cartons: which they need, where each copy stands.
#include <findspace/findspace.h>

#include <cstdio>
#include <fstream>
#include <vector>

int main() {
  using namespace findspace;
  const std::vector<Position3> wedge{{0, 0, 0}, {4, 0, 0}, {0, 3, 0}, {4, 3, 0}, {0, 0, 2}, {4, 0, 2}};
  SolidPackProblem problem;
  problem.name = "a delivery";
  problem.containers = {{"carton", 6, 6, 4, 5}};
  problem.gap = "0.1";
  problem.parts = {{"box", Shape::box(Point3{0, 0, 0}, Point3{3, 2, 2}), 6, Orientation::right_angles()},
                   {"wedge", Shape::polytope(wedge), 4, Orientation::upright()},
                   {"ball", Shape::ball({0, 0, 0}, "1.25"), 3}};
  const auto layout = pack(problem, {.work = 20}, [](const SolidPackLayout& better) {
    std::printf("%zu cartons, %s of the last\n", better.containers.size(), better.height.text().c_str());
  });
  if (!layout || !layout_faults(problem, *layout).empty()) return 1;
  for (const PlacedSolid& item : layout->items)
    std::printf("carton %zu: %s %d at %s, %s, %s\n", item.container, item.part.c_str(), item.copy,
                item.at.x.text().c_str(), item.at.y.text().c_str(), item.at.z.text().c_str());
  std::ofstream("delivery.3mf", std::ios::binary) << layout_file(problem, *layout, ".3mf");
  std::ofstream("delivery.svg") << layout_svg(problem, *layout);
  std::puts("all delivered");
}
