// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Memory for items that are about to be added to a vector, where more may follow. `reserve(size() + more)` alone would
// copy all items again at every such call. Cost: constant for each item in the mean.
#pragma once

#include <algorithm>
#include <cstddef>

namespace findspace::plane {

template <class Vector>
void reserve_more(Vector& v, std::size_t more) {
  if (v.size() + more > v.capacity()) v.reserve(std::max(v.size() + more, 2 * v.capacity()));
}

}  // namespace findspace::plane
