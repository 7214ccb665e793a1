// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Which stage decided a sign: counters a test can read to check that the cheap stages do their work, and that the
// exact ones are reached where they must be. One set a thread, plain increments, never reset by the library.
#pragma once

#include <cstdint>

namespace findspace::exact {

struct StageCounts {
  std::uint64_t filter = 0;         // the double interval excluded 0 (or equality was visible without arithmetic)
  std::uint64_t fixed = 0;          // integers or rationals
  std::uint64_t quadratic = 0;      // p + r*sqrt(n), by squaring
  std::uint64_t bigfloat = 0;       // a ball of higher precision excluded 0
  std::uint64_t zero_identity = 0;  // 0 as an identity of the roots
  std::uint64_t zero_bound = 0;     // a ball inside the root separation bound: exactly 0
};

namespace detail {
inline thread_local StageCounts stage_counts_of_thread;
}

/// The calling thread's counters; assign `{}` to reset.
inline StageCounts& stage_counts() { return detail::stage_counts_of_thread; }

}  // namespace findspace::exact
