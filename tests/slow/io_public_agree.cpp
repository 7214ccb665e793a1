// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A million random positions over 200 random scenes: the compiled query, the region, and the world at the position
// alone say the same everywhere. Many of the positions lie on boundaries, for all coordinates are on a coarse grid.

#include <gtest/gtest.h>

#include <memory>
#include <random>

#include "findspace/findspace.h"

namespace io_public_agree {

using namespace findspace;
using namespace findspace::words;

class Scenes {
 public:
  explicit Scenes(unsigned seed) : random_(seed) {}

  int number(int least, int most) { return least + int(random_() % unsigned(most - least + 1)); }
  Shape shape(int reach) {
    const int x = number(-reach, reach), y = number(-reach, reach);
    switch (number(0, 3)) {
      case 0:
        return Shape::disc({x, y}, number(1, 4));
      case 1:
        return Shape::polygon(findspace::Ring{{x, y}, {x + number(1, 6), y}, {x, y + number(1, 6)}});
      case 2:
        return Shape::polyline({{x, y}, {x + number(1, 5), y + number(-3, 3)}});
      default:
        return Shape::box({x, y}, {x + number(1, 6), y + number(1, 6)});
    }
  }
  Formula atom() {
    const std::string a = std::string(1, char('a' + number(0, 3)));
    switch (number(0, 5)) {
      case 0:
        return gap("peg", a) >= number(0, 3);
      case 1:
        return gap("peg", a) == number(0, 2);
      case 2:
        return reach("peg", a) <= number(6, 16);
      case 3:
        return inside("peg", "table", number(0, 2));
      case 4:
        return touches("peg", a);
      default:
        return gap("peg", a) < number(1, 4);
    }
  }
  Formula formula() {
    Formula f = atom();
    for (int k = number(1, 5); k > 0; --k) {
      const Formula g = number(0, 3) ? atom() : !atom();
      f = number(0, 2) ? f && g : f || g;
    }
    return f;
  }
  World world() {
    return World({{"peg", shape(1)},
                  {"table", Shape::box({-14, -14}, {14, 14})},
                  {"a", shape(9)},
                  {"b", shape(9)},
                  {"c", shape(9)},
                  {"d", shape(9)}},
                 "peg");
  }
  Position position() { return {number(-40, 40) / 2.0 + (number(0, 1) ? 0.1 : 0), number(-40, 40) / 2.0}; }

 private:
  std::mt19937 random_;
};

class Agree : public testing::TestWithParam<unsigned> {};

TEST_P(Agree, EverywhereInTenScenes) {
  constexpr int kScenes = 10, kPositions = 5000;
  Scenes scenes(GetParam());
  for (int scene = 0; scene < kScenes; ++scene) {
    const World world = scenes.world();
    const Query query = world.query(scenes.formula());
    const Region region = world.solve(query.text());
    std::vector<Position> at;
    for (int k = 0; k < kPositions; ++k) at.push_back(scenes.position());
    const auto answers = std::make_unique<bool[]>(at.size());
    query.holds(at, {answers.get(), at.size()});
    for (std::size_t k = 0; k < at.size(); ++k) {
      const Point p{at[k][0], at[k][1]};
      ASSERT_EQ(answers[k], query.holds(p)) << query.text() << " at " << at[k][0] << ", " << at[k][1];
      ASSERT_EQ(answers[k], region.contains(p)) << query.text() << " at " << at[k][0] << ", " << at[k][1];
      if (k % 25 == 0) {
        ASSERT_EQ(answers[k], world.check(query.text(), p).holds);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Public, Agree, testing::Range(0U, 20U));

}  // namespace io_public_agree
