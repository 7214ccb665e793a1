// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Tasks that are counted as work of one question (search_work.h), whichever threads they run on. Guarantee: the same
// count for any number of threads. Keywords: budget, parallel for.
#pragma once

#include <cstddef>
#include <functional>

namespace findspace::plane {

/// As parallel_for(); the cells that the tasks count are counted for the question of the caller.
void counted_tasks(std::size_t count, const std::function<void(std::size_t)>& task);

}  // namespace findspace::plane
