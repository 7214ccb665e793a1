// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A million random positions over 200 random scenes: the compiled query, the region, and the world at the position
// alone say the same everywhere. Many of the positions lie on boundaries, for all coordinates are on a coarse grid.
// Each day asks `check` at another part of them; with FINDSPACE_WHOLE set it is asked at all.

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <memory>
#include <optional>
#include <random>

#include "findspace/findspace.h"

namespace io_public_agree {

using namespace findspace;
using namespace findspace::words;

class Scenes {
 public:
  explicit Scenes(unsigned seed) : random_(seed) {}

  int number(int least, int most) { return least + int(random_() % unsigned(most - least + 1)); }
  Shape simple(int reach) {
    const int x = number(-reach, reach), y = number(-reach, reach);
    switch (number(0, 4)) {
      case 0:
        return Shape::disc({x, y}, number(1, 4));
      case 1:
        return Shape::polygon(findspace::Ring{{x, y}, {x + number(1, 6), y}, {x, y + number(1, 6)}});
      case 2:
        return Shape::polyline({{x, y}, {x + number(1, 5), y + number(-3, 3)}});
      case 3:
        return Shape::points({{x, y}, {x + number(1, 5), y}});
      default:
        return Shape::box({x, y}, {x + number(1, 6), y + number(1, 6)});
    }
  }
  Shape shape(int reach) {
    switch (number(0, 11)) {
      case 0:
        return Shape::subtract({Shape::box({-4, -4}, {number(3, 6), 5}), simple(3)});
      case 1:
        return Shape::unite({simple(reach), simple(reach)});
      case 2:
        return Shape::collection({{"one", simple(reach)}, {"two", simple(reach)}});
      case 3:
        return Shape::offset(simple(reach), number(1, 2));
      case 4:
        return Shape::minkowski_sum(simple(reach), simple(1));
      case 5:
        return simple(reach).rotated(90 * number(1, 3));
      case 6:
        return Shape::interior(Shape::box({-2, -2}, {number(1, 5), 3}));
      default:
        return simple(reach);
    }
  }
  Formula atom() {
    const std::string a = std::string(1, char('a' + number(0, 3)));
    switch (number(0, 9)) {
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
      case 5:
        return margin("peg", "table") > number(-2, 2);
      case 6:
        return protrusion("peg", a) <= number(0, 6);
      case 7:
        return distance("peg", a) != number(0, 3);
      case 8:
        return hausdorff("peg", a) <= number(4, 12);
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

/// A world of random shapes and a formula that can be asked of it: shapes may lack what a distance needs.
std::optional<Query> query_of(Scenes& scenes) {
  try {
    const Query query = scenes.world().query(scenes.formula());
    query.region();
    return query;
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ErrorCode::kUnsupported) << e.what();
    return std::nullopt;
  }
}

class Agree : public testing::TestWithParam<unsigned> {};

TEST_P(Agree, EverywhereInTenScenes) {
  constexpr std::size_t kScenes = 10, kPositions = 5000, kParts = 25;
  const bool whole = std::getenv("FINDSPACE_WHOLE") != nullptr;
  const auto days = std::chrono::duration_cast<std::chrono::hours>(std::chrono::system_clock::now().time_since_epoch());
  const std::size_t part = std::size_t(days.count() / 24) % kParts;
  Scenes scenes(GetParam());
  std::size_t asked = 0, held = 0, checked = 0;
  while (asked < kScenes) {
    const std::optional<Query> query = query_of(scenes);
    if (!query) continue;
    ++asked;
    const World& world = query->world();
    const Region region = world.solve(query->text());
    std::vector<Position> at;
    for (std::size_t k = 0; k < kPositions; ++k) at.push_back(scenes.position());
    const auto answers = std::make_unique<bool[]>(at.size());
    query->holds(at, {answers.get(), at.size()});
    for (std::size_t k = 0; k < at.size(); ++k) {
      const Point p{at[k][0], at[k][1]};
      held += answers[k];
      ASSERT_EQ(answers[k], query->holds(p)) << query->text() << " at " << at[k][0] << ", " << at[k][1];
      ASSERT_EQ(answers[k], region.contains(p)) << query->text() << " at " << at[k][0] << ", " << at[k][1];
      if (!whole && k % kParts != part) continue;
      ++checked;
      ASSERT_EQ(answers[k], world.check(query->text(), p).holds)
          << query->text() << " at " << at[k][0] << ", " << at[k][1];
    }
  }
  std::printf("%zu scenes: %zu of %zu positions hold, %zu checked\n", asked, held, kScenes * kPositions, checked);
}

INSTANTIATE_TEST_SUITE_P(Public, Agree, testing::Range(0U, 20U));

}  // namespace io_public_agree
