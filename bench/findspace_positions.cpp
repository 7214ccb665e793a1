// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A compiled query at many positions, for bench/public_queries.py: from standard input rings of shapes, a formula and
// how many positions; prints the least processor time of three in seconds.
#include <findspace/findspace.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <random>

int main() {
  using namespace findspace;
  const nlohmann::json scene = nlohmann::json::parse(std::cin);
  const auto polygon = [](const nlohmann::json& ring) { return Shape::polygon(ring.get<std::vector<Position>>()); };
  std::map<std::string, Shape> shapes{{"peg", polygon(scene.at("peg"))}};
  for (const auto& [name, ring] : scene.at("shapes").items()) shapes.emplace(name, polygon(ring));
  const Query query = World(shapes, "peg").query(scene.at("where").get<std::string>());
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> x(0, 100), y(0, 50);
  std::vector<Position> positions(scene.at("positions").get<std::size_t>());
  for (Position& p : positions) p = {x(random), y(random)};
  const auto answers = std::make_unique<bool[]>(positions.size());
  const std::span<bool> out(answers.get(), positions.size());
  query.holds(std::span<const Position>(positions).first(1), out.first(1));
  double least = 1e300;
  for (int k = 0; k < 3; ++k) {
    const std::clock_t begun = std::clock();
    query.holds(positions, out);
    least = std::min(least, double(std::clock() - begun) / CLOCKS_PER_SEC);
  }
  std::printf("{\"seconds\": %.6f}\n", least);
  return 0;
}
