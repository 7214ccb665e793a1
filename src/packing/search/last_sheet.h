// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The last sheet of a layout packed once more, so that it is used little along y, as the search for few sheets uses it
// little along x. Guarantee: the layout that is returned is feasible, exactly, on the same sheets, and its largest free
// rectangle is larger by a twentieth at least. Cost: a search with one sheet, within the options. Keywords: offcut,
// remnant.
#pragma once

#include "packing/search/strip_search.h"

namespace findspace::packing {

/// A layout of the problem on sheets, or nothing where none leaves so large a rectangle.
std::optional<Layout> with_larger_remnant(const Problem& problem, const Layout& layout, const SearchOptions& options,
                                          const StopWish& stop);

}  // namespace findspace::packing
