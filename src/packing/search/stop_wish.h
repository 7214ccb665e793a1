// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The wish of others that a search ends: a flag of its caller, or a token of the public options. Cost of asking: two
// loads. Keywords: cancellation token.
#pragma once

#include <atomic>

#include "findspace/options.h"

namespace findspace::packing {

class StopWish {
 public:
  /// Both must live as long.
  StopWish(const std::atomic<bool>& flag) : flag_(&flag) {}  // NOLINT: implicit on purpose
  StopWish(const std::atomic<bool>& flag, const Cancel& cancel) : flag_(&flag), cancel_(&cancel) {}

  operator bool() const { return *flag_ || (cancel_ != nullptr && cancel_->requested()); }  // NOLINT

 private:
  const std::atomic<bool>* flag_;
  const Cancel* cancel_ = nullptr;
};

}  // namespace findspace::packing
