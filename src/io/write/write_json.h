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

#include "formula/language/optimum.h"
#include "formula/planar/solve.h"
#include "plane/query/curve_net.h"
#include "plane/query/locate_line.h"

namespace findspace::io {

/// "0.1", "3", "1e-07"; "-inf" (quoted) for minus infinity, null for what no number is.
std::string json_number(double value);
/// With quotes; control characters, quotes and backslashes escaped.
std::string json_string(std::string_view text);

/// What `minimize`, `maximize` or `distance -> min` found.
struct ExtremeValue {
  bool maximum = false;
  std::optional<double> value;  // none: there is none, or no bound
  bool unbounded = false, attained = false, proven = true;
  // Where not proven: no position has a better value than `bound`, and every best one lies `within` of a given one.
  std::optional<double> bound{}, within{};
};
ExtremeValue extreme_value(const formula::OptimalValue& best, bool maximum);

/// The result of `map` and `describe`. `unit` may be empty, `extreme` null; with `exact` the exact cells too
/// (write_cells.h).
std::string region_json(const plane::Region& region, const plane::Summary& summary, const exact::Real& step,
                        std::string_view unit, const ExtremeValue* extreme = nullptr, bool exact = false);
/// The result of `map` along a line: lengths from the point the line goes through. `side`: on which side of the true
/// set the intervals may lie; empty where they are exact.
std::string intervals_json(const std::vector<plane::LineInterval>& intervals, const exact::Real& step,
                           std::string_view unit, const ExtremeValue* extreme = nullptr, std::string_view side = {});

}  // namespace findspace::io
