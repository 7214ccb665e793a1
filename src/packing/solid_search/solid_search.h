// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The search for a low container of solids, or for few containers (search/room_search.h). It ends early where a layout
// is as low as the lower bound. Guarantee: layouts given are feasible, exactly. With a limit of work alone the result
// depends on the seed only, for any number of threads. Cost: as long as allowed. Keywords: three-dimensional packing,
// open dimension, container loading.
#pragma once

#include <optional>

#include "packing/search/search_options.h"
#include "packing/solid_problem/solid_problem.h"

namespace findspace::packing {

using SolidSearchOptions = SearchOptionsOf<SolidLayout>;
using SolidSearchEvents = SearchEventsOf<SolidLayout>;

/// Nothing where there are no parts, or none that fits a container. `stop`: ends the search when it becomes true.
std::optional<SolidLayout> search_solids(const SolidProblem& problem, const SolidSearchOptions& options,
                                         const SolidSearchEvents& events, const StopWish& stop);

}  // namespace findspace::packing
