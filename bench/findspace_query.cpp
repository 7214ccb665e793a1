// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// One query among many obstacles, apart from reading: a scene of tools/findspace_scenes.py from standard input becomes
// a World once, then the formula is solved. Prints the milliseconds of processor time: making the world, the first
// query, and the least of three later ones, which find sums of pairs that a World keeps.
#include <findspace/findspace.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <iostream>
#include <nlohmann/json.hpp>

namespace {

double now() { return 1e3 * double(std::clock()) / CLOCKS_PER_SEC; }

}  // namespace

int main() {
  using namespace findspace;
  const nlohmann::json scene = nlohmann::json::parse(std::cin);
  std::map<std::string, Shape> shapes;
  for (const auto& [name, shape] : scene.at("shapes").items()) shapes.emplace(name, Shape::json(shape.dump()));
  const std::string moving = scene.at("moving"), formula = scene.at("where");
  double at = now();
  const World world(shapes, moving, {.unit = ""});
  const double made = now() - at;
  double first = 0, later = 1e300;
  std::size_t components = 0;
  for (int k = 0; k < 4; ++k) {
    at = now();
    components = world.solve(formula).components().size();
    const double spent = now() - at;
    if (k == 0)
      first = spent;
    else
      later = std::min(later, spent);
  }
  std::printf("%.2f %.3f %.3f %zu\n", made, first, later, components);
  return 0;
}
