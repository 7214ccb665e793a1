// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Results as text for people. Numbers have six digits here; JSON gives them all.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "distance/answer/optimum.h"
#include "plane/query/locate_line.h"
#include "plane/query/summary.h"
#include "space/box/box_summary.h"

namespace findspace::io {

/// "12.5 mm²" with `power` "²".
std::string size_text(double value, std::string_view unit, const char* power = "");
/// The line of a least or greatest value, if there is something to say.
std::string optimum_text(const distance::OptimalValue& best, std::string_view unit);
/// What a set is like; `best` may be null.
std::string summary_text(std::string_view title, const plane::Summary& summary, std::string_view unit,
                         const distance::OptimalValue* best = nullptr);
std::string summary_text(std::string_view title, const space::SpaceSummary& summary, std::string_view unit,
                         const distance::OptimalValue* best = nullptr);
std::string intervals_text(std::string_view title, const std::vector<plane::LineInterval>& intervals,
                           const exact::Real& step, std::string_view unit);
/// A certified bound from either side: the inner set's JSON, with the outer one in it.
std::string bounded_json(std::string inner, const std::string& outer);

}  // namespace findspace::io
