// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The search for a short strip, or for few sheets, in the plane: an island a thread (room_search.h). Guarantee: layouts
// given are feasible, exactly. With a limit of work alone the result depends on the seed and the number of threads
// only. Cost: as long as allowed.
#pragma once

#include <optional>

#include "packing/problem/problem.h"
#include "packing/search/search_options.h"

namespace findspace::packing {

using SearchOptions = SearchOptionsOf<Layout>;
using SearchEvents = SearchEventsOf<Layout>;

/// Nothing where there are no parts, no part that fits a sheet, or no layout was found in which all conditions hold.
/// No items where parts would fit a sheet, and no place was found for any.
/// `stop`: ends the search when it becomes true.
std::optional<Layout> search_strip(const Problem& problem, const SearchOptions& options, const SearchEvents& events,
                                   const StopWish& stop);

}  // namespace findspace::packing
