// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Where a distance is attained, as JSON and in words, as docs/results.md describes it. Keywords: witness, closest
// features.
#pragma once

#include <string>

#include "formula/planar/solve.h"
#include "plane/query/measure_cells_twofold.h"

namespace findspace::io {

/// The members of a "witness" object, without the braces; "" where nothing is known. `step`: as in write_json.h.
std::string witness_members(const formula::DistanceAt& d, const plane::Twofold& step);
/// "vertex (1, 2) of B and edge (0, 0) to (4, 0) of A, part left"; "" where nothing is known.
std::string witness_words(const formula::DistanceAt& d, const plane::Twofold& step);
/// "[x, y]" of a point in grid steps.
std::string json_point(const exact::RealPoint& p, const plane::Twofold& step);

}  // namespace findspace::io
