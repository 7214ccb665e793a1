// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A rectangle of small area that holds all parts: strips of several heights, then of those near the best ones, then of
// the best. A layout to start with is the first one where it is feasible. Guarantee: layouts given are feasible,
// exactly. Cost: as long as allowed. Keywords: rectangular packing.
#pragma once

#include "packing/search/strip_search.h"

namespace findspace::packing {

/// The problem has a box. Nothing where there are no parts.
std::optional<Layout> search_box(const Problem& problem, const SearchOptions& options, const SearchEvents& events,
                                 const StopWish& stop);

}  // namespace findspace::packing
