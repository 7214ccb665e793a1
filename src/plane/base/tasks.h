// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Tasks on the threads of oneTBB: nothing but its call, as that library is not instrumented and ThreadSanitizer has to
// be told what order it keeps (tests/thread/order_of_tasks.cpp). Work is spread by parallel.h.
#pragma once

#include <cstddef>
#include <functional>

namespace findspace::plane {

/// Calls task(0) ... task(count - 1), in any order, possibly at once. Throws what a task throws; Error(kLimit) where no
/// thread can be started.
void run_tasks(std::size_t count, const std::function<void(std::size_t)>& task);

}  // namespace findspace::plane
