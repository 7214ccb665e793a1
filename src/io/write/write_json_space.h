// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Results of 3D scenes as JSON (docs/results.md): the same keys as in the plane, places with three coordinates. An
// exact map of boxes lists the set as disjoint boxes, each with open and closed ends. Keywords: serialisation.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "formula/solid/solve_space.h"
#include "io/write/write_json.h"
#include "space/box/box_summary.h"

namespace findspace::io {

/// `best` may be null.
std::string space_json(const space::BoxComplex& set, const space::SpaceSummary& summary, const exact::Real& step,
                       std::string_view unit, const distance::OptimalValue* best = nullptr);
/// The polytope with its facets instead of boxes.
std::string space_json(const space::ConvexSet& set, const space::SpaceSummary& summary, const exact::Real& step,
                       std::string_view unit, const distance::OptimalValue* best = nullptr);

}  // namespace findspace::io
