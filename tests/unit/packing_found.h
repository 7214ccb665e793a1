// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Layouts that tests search for, and that must be proved.
#pragma once

#include <gtest/gtest.h>

#include <atomic>

#include "packing/proof/verify.h"
#include "packing/search/refined_search.h"

namespace findspace::packing {

inline Layout found(const Problem& problem, double work, std::uint64_t seed = 1, unsigned threads = 1) {
  const std::atomic<bool> stop = false;
  SearchOptions options;
  options.work = work;
  options.seed = seed;
  options.threads = threads;
  const auto layout = search_refined(problem, options, {}, stop);
  EXPECT_TRUE(verify(problem, layout.value()).feasible());
  return *layout;
}

}  // namespace findspace::packing
