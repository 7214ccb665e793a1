// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Results of 3D scenes as text for people, as report.h does in the plane.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "formula/solid/solve_space.h"
#include "io/write/write_json.h"
#include "space/box/box_summary.h"

namespace findspace::app {

/// `best` may be null.
std::string space_summary_text(std::string_view title, const space::SpaceSummary& summary, std::string_view unit,
                               const distance::OptimalValue* best);

}  // namespace findspace::app
