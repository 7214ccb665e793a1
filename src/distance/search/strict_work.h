// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Work that ends all searches that count there, those within others too (plane/base/search_work.h), so that no value
// of many takes seconds. Guarantee: what has no answer yet keeps its bound; a task that counts its own is not meant,
// so answers are the same for any number of threads. Keywords: budget, nested search.
#pragma once

#include "plane/base/search_work.h"

namespace findspace::distance {

using ScopedStrictWork = plane::OfThread<const plane::SearchWork>;

inline bool strictly_spent() {
  const plane::SearchWork* const work = plane::ScopedSearchWork::now();
  return work != nullptr && work == ScopedStrictWork::now() && work->spent();
}

}  // namespace findspace::distance
