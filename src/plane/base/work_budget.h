// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// How much work one input may cause. Work is counted, not timed, so the same input is refused on every machine. A unit
// is about what one number of a file, one vertex or one cell costs. Guarantee: whoever charges ends after a stated
// number of units with Error(kLimit). Keywords: budget, quota, denial of service.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "findspace/error.h"

namespace findspace::plane {

inline constexpr std::uint64_t kUsualWorkBudget = 20'000'000;

class WorkBudget {
 public:
  explicit WorkBudget(std::uint64_t limit = kUsualWorkBudget) : limit_(limit) {}

  /// Throws Error(kLimit), which names `what` causes the work.
  void charge(std::uint64_t units, std::string_view what) {
    if (units > limit_ - used_) fail(what);
    used_ += units;
  }
  std::uint64_t limit() const { return limit_; }
  std::uint64_t left() const { return limit_ - used_; }

 private:
  [[noreturn]] void fail(std::string_view what) const {
    throw Error(ErrorCode::kLimit, std::string(what) + " costs more than the work limit of " + std::to_string(limit_) +
                                       " units, which --work-limit raises");
  }

  std::uint64_t limit_, used_ = 0;
};

}  // namespace findspace::plane
