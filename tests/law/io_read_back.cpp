// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A tenth of the thousand random regions, which turns with the date; tests/slow has all of them.
#include "law/io_read_back.h"

#include <chrono>

namespace findspace::io {
namespace io_read_back {

TEST(ReadBack, ATenthOfTheRegions) {
  const auto day =
      std::chrono::duration_cast<std::chrono::hours>(std::chrono::system_clock::now().time_since_epoch()).count() / 24;
  const int tenth = int(day % 10);
  expect_read_back(100 * tenth, 100 * tenth + 100);
}

}  // namespace io_read_back
}  // namespace findspace::io
