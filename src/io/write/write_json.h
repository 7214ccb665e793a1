// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Results as JSON, as docs/results.md describes them. Numbers are the shortest decimals that read back as the same
// double, whole ones without a point; the same result always gives the same bytes. Keywords: serialisation, round trip.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "distance/answer/optimum.h"
#include "findspace/text.h"
#include "formula/planar/solve.h"
#include "io/text/spool.h"
#include "plane/query/curve_net.h"
#include "plane/query/locate_line.h"

namespace findspace::io {

using findspace::json_number;
using findspace::json_string;

/// The closed form of an exact value whose decimal is not the number itself, quoted; else empty.
std::string closed_form_text(const distance::SceneAnswer& answer);
/// The members after a best value: "closed_form" where it has one; where it is not proven "proven", "lower", "upper",
/// "bound" (that of these which no place passes) and "within".
std::string how_known_members(const distance::OptimalValue& best);
/// "minimum" or "maximum", "attained", and these.
std::string optimum_members(const distance::OptimalValue& best);

/// The result of `map` and `describe`. `unit` may be empty, `best` null; with `exact` the exact cells too
/// (write_cells.h).
std::string region_json(const plane::Region& region, const plane::Summary& summary, const exact::Real& step,
                        std::string_view unit, const distance::OptimalValue* best = nullptr, bool exact = false);
/// The same, piece by piece; nothing comes before all is known that may be refused.
void region_json(const plane::Region& region, const plane::Summary& summary, const exact::Real& step,
                 std::string_view unit, const distance::OptimalValue* best, bool exact, const Sink& sink);
/// The result of `map` along a line: lengths from the point the line goes through. `side`: on which side of the true
/// set the intervals may lie; empty where they are exact.
std::string intervals_json(const std::vector<plane::LineInterval>& intervals, const exact::Real& step,
                           std::string_view unit, const distance::OptimalValue* best = nullptr,
                           std::string_view side = {}, const std::vector<plane::LineInterval>& undecided = {});

}  // namespace findspace::io
