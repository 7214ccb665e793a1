// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Results as text for people. Numbers have six digits here; --json gives them all.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "formula/planar/solve.h"
#include "io/write/write_json.h"
#include "plane/query/locate_line.h"
#include "plane/query/summary.h"

namespace findspace::app {

/// `best` may be null.
std::string summary_text(std::string_view title, const plane::Summary& summary, std::string_view unit,
                         const distance::OptimalValue* best = nullptr);
std::string intervals_text(std::string_view title, const std::vector<plane::LineInterval>& intervals,
                           const exact::Real& step, std::string_view unit);
/// A certified bound from either side: the inner set's JSON, with the outer one in it.
std::string bounded_json(std::string inner, const std::string& outer);

}  // namespace findspace::app
