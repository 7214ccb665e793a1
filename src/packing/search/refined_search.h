// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A search in the plane (strip_search.h), and what makes its layout better in the end: parts are tilted where they may
// be (tilting.h), and the last sheet is packed once more for a larger free rectangle (last_sheet.h). Guarantee: as of
// the search. Cost: as long as allowed, a tenth of it for each of these.
#pragma once

#include "packing/search/strip_search.h"

namespace findspace::packing {

/// As search_strip().
std::optional<Layout> search_refined(const Problem& problem, const SearchOptions& options, const SearchEvents& events,
                                     const StopWish& stop);

}  // namespace findspace::packing
