// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The least value over a box ends after a stated amount of work, whatever a value costs, between bounds.

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <optional>

#include "distance/search/least_in_box.h"
#include "plane/base/parallel.h"
#include "plane/base/search_work.h"
#include "plane/base/stop_check.h"

namespace findspace::distance {
namespace distance_least_in_box {

using exact::Real;
using space::RealVector;

/// 1 more than the distance from 0.
Answer value_at(const RealVector& p) {
  Answer v;
  v.value = Real::from_double(1 + space::length(space::rounded(p)));
  return v;
}

/// A value costs so many cells; how many were looked at in all.
struct Costly {
  long cells;
  std::atomic<long> in_all{0};

  exact::Tried<Answer> least() {
    return least_in_box(
        [this](const RealVector& p) {
          for (long k = 0; k < cells; ++k) plane::count_cell();
          in_all += cells;
          return value_at(p);
        },
        {-4, -3, -5}, {4, 5, 4}, -exact::kInfinity);
  }
};

TEST(LeastInBox, EndsAfterAStatedAmountOfWork) {
  for (const long cells : {100L, 10000L, 300000L}) {
    Costly costly{cells};
    const auto v = costly.least();
    ASSERT_TRUE(v);
    EXPECT_LE(costly.in_all, plane::kMostCellsOfQuestion + cells) << cells;
    if (cells > 1000) EXPECT_GE(costly.in_all, plane::kMostCellsOfQuestion / 2) << cells;
    EXPECT_LE(v->bounds().lower->to_double(), 1);
    EXPECT_GE(v->value.to_double(), 1);
    if (cells < 100000) EXPECT_GT(v->bounds().lower->to_double(), 0);
  }
}

TEST(LeastInBox, EndsAtTheSamePlaceForAnyNumberOfThreads) {
  std::optional<Answer> alone;
  for (const unsigned threads : {1U, 2U, 5U}) {
    plane::with_threads(threads, [&] {
      const auto v = Costly{5000}.least();
      ASSERT_TRUE(v);
      if (!alone) alone = *v;
      EXPECT_EQ(v->value, alone->value);
      EXPECT_EQ(v->at, alone->at);
      EXPECT_EQ(*v->bounds().lower, *alone->bounds().lower);
    });
  }
}

/// The units that the asker allows raise the cells, of tasks as well, which count for themselves.
TEST(LeastInBox, MayTakeMoreWhereMoreIsAllowed) {
  const plane::SearchLimit limit{4 * plane::kUsualWorkBudget};
  const plane::ScopedSearchLimit here(&limit);
  Costly costly{10000};
  ASSERT_TRUE(costly.least());
  EXPECT_GE(costly.in_all, 2 * plane::kMostCellsOfQuestion);
  EXPECT_LE(costly.in_all, 4 * plane::kMostCellsOfQuestion + 10000);
  const plane::SearchQuestion question;
  std::atomic<int> apart{0};
  plane::parallel_for(8, [&](std::size_t) {
    plane::count_cells(7);
    apart += plane::allowed(100) == 400 && plane::cells_left() == 4 * plane::kMostCellsOfQuestion;
  });
  EXPECT_EQ(apart, 8);
  EXPECT_EQ(question.work().left, 4 * plane::kMostCellsOfQuestion);
}

/// Where a value takes all the cells that it has, its box keeps the bound of the one that it is a part of.
TEST(LeastInBox, AValueThatIsNotFoundInItsShareIsLeftOpen) {
  const auto v = least_in_box(
      [](const RealVector& p) -> exact::Tried<Answer> {
        if (p[0].sign() <= 0) return value_at(p);
        while (plane::cells_left() > 0) plane::count_cell();
        return exact::Refusal("not found");
      },
      {-4, -4, -4}, {4, 4, 4}, -exact::kInfinity);
  ASSERT_TRUE(v);
  EXPECT_LE(v->bounds().lower->to_double(), 1);
  EXPECT_GE(v->value.to_double(), 1);
  EXPECT_FALSE(least_in_box(
      [](const RealVector& p) -> exact::Tried<Answer> {
        if (p[0].sign() <= 0) return value_at(p);
        return exact::Refusal("not computed");
      },
      {-4, -4, -4}, {4, 4, 4}, -exact::kInfinity));
}

}  // namespace distance_least_in_box
}  // namespace findspace::distance
