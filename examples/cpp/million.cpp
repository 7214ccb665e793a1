// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A million positions asked of one compiled query.
#include <findspace/findspace.h>

#include <cstdio>
#include <memory>
#include <random>

int main() {
  using namespace findspace;
  const Shape plate = Shape::subtract({Shape::box({25, 12}, {75, 48}), Shape::disc({50, 30}, 9)});
  const World world({{"plate", plate}, {"peg", Shape::box({-6, -4}, {6, 4})}, {"table", Shape::box({0, 0}, {100, 60})}},
                    "peg");
  const Query query = world.query("inside(peg, table) and clear(peg, plate, 0.5)");
  std::mt19937 random(1);
  std::uniform_real_distribution<double> x(0, 100), y(0, 60);
  std::vector<Position> positions(1'000'000);
  for (Position& p : positions) p = {x(random), y(random)};
  const auto answers = std::make_unique<bool[]>(positions.size());
  query.holds(positions, {answers.get(), positions.size()});
  std::size_t feasible = 0;
  for (std::size_t k = 0; k < positions.size(); ++k) feasible += answers[k];
  const double share = double(feasible) / double(positions.size());
  std::printf("%.2f of the table is free, by area %.2f\n", share, *query.region().area() / 6000);
}
