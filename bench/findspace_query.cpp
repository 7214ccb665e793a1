// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The time of one question to a world that stands already: a scene of tools/findspace_scenes.py is read from standard
// input and built once, then its formula is solved several times. Prints the processor seconds to build and the least
// of the questions, and the area found. Processor time of all threads.
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>

#include "findspace/world.h"

namespace {

double processor_seconds() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return double(t.tv_sec) + double(t.tv_nsec) * 1e-9;
}

}  // namespace

int main() {
  constexpr int kQuestions = 5;
  const nlohmann::json scene = nlohmann::json::parse(std::cin);
  std::map<std::string, findspace::Shape> shapes;
  for (const auto& [name, shape] : scene["shapes"].items())
    shapes.emplace(name,
                   findspace::Shape::json(shape.is_array() ? nlohmann::json{{"union", shape}}.dump() : shape.dump()));
  const double start = processor_seconds();
  const findspace::World world(shapes, scene["moving"].get<std::string>());
  const double built = processor_seconds() - start;
  const auto where = scene["where"].get<std::string>();
  double least = 1e9, area = 0;
  for (int k = 0; k < kQuestions; ++k) {
    const double from = processor_seconds();
    area = world.solve(where).area().value_or(-1);
    least = std::min(least, processor_seconds() - from);
  }
  std::printf("%.4f %.4f %.6f\n", built, least, area);
}
