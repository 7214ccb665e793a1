// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include <gtest/gtest.h>

#include <memory>
#include <optional>

#include "exact/number/tried.h"

namespace findspace::exact {
namespace exact_tried {

Tried<std::unique_ptr<int>> positive(int n) {
  if (n <= 0) return Refusal("not positive", "scene.json:3");
  return std::make_unique<int>(n);
}

TEST(Tried, HoldsAValueOrTheRefusalThatAUserReads) {
  const auto one = positive(1), none = positive(0);
  ASSERT_TRUE(one);
  EXPECT_EQ(**one, 1);
  ASSERT_FALSE(none);
  EXPECT_EQ(none.refusal().error.code(), ErrorCode::kUnsupported);
  EXPECT_STREQ(none.refusal().error.what(), "scene.json:3: not positive");
  EXPECT_EQ(*positive(7).or_throw(), 7);
  EXPECT_THROW(positive(-1).or_throw(), Error);
}

TEST(Tried, RefusalsSayWhere) {
  const Refusal without("why"), with("why", "a.json");
  EXPECT_EQ(without.at("b.json").error.place(), "b.json");
  EXPECT_EQ(without.at("").error.place(), "");
  EXPECT_EQ(with.at("b.json").error.place(), "a.json");
  EXPECT_STREQ(with.within("gap(B, A)").error.what(), "gap(B, A): a.json: why");
}

/// An answer that there is none differs from a refusal.
TEST(Tried, OfOptionalsTellsNothingFromRefused) {
  const Tried<std::optional<int>> nothing = std::nullopt, refused = Refusal("why"), some = 3;
  EXPECT_TRUE(nothing);
  EXPECT_FALSE(nothing->has_value());
  EXPECT_FALSE(refused);
  EXPECT_EQ(**some, 3);
}

}  // namespace exact_tried
}  // namespace findspace::exact
