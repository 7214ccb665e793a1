// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "io/nesting/unscaled_problem.h"

#include <findspace/error.h>
#include <fmt/format.h>

#include <algorithm>

namespace findspace::io {
namespace {

using packing::Fraction;

/// The digits after the point.
int digits_of(const Fraction& value) {
  int digits = 0;
  while (packing::power_of_ten(digits) % value.denominator() != 0) ++digits;
  return digits;
}

/// A gap is at least a thousand steps, for the polygon about its disc.
int gap_digits(const Fraction& gap) {
  int digits = 0;
  while (gap > 0 && Fraction(1000, packing::power_of_ten(digits)) > gap) ++digits;
  return digits;
}

int grid_digits(const std::vector<UnscaledPart>& parts, int least) {
  int digits = least, finer = 0;
  for (const UnscaledPart& part : parts) {
    for (const UnscaledRing& ring : part.rings)
      for (const auto& [x, y] : ring) digits = std::max({digits, digits_of(x), digits_of(y)});
    if (!std::all_of(part.angles.begin(), part.angles.end(), packing::is_quarter)) finer = 6;
  }
  return digits + finer;
}

}  // namespace

packing::Problem UnscaledProblem::on_grid(const std::string& place) && {
  packing::Problem result;
  result.name = std::move(name);
  result.height = height;
  result.gap = gap;
  result.edge = edge;
  if (gap < 0 || edge < 0) throw Error(ErrorCode::kBadValue, "a gap or an edge below 0", place);
  if (height <= edge + edge) throw Error(ErrorCode::kBadValue, "the strip has no height between its edges", place);
  result.digits = grid_digits(parts, gap_digits(gap));
  const packing::int128 steps = result.steps();
  for (UnscaledPart& part : parts) {
    std::vector<packing::Ring> rings;
    for (const UnscaledRing& ring : part.rings) {
      packing::Ring& out = rings.emplace_back();
      for (const auto& [x, y] : ring) out.push_back({x.over(steps), y.over(steps)});
    }
    packing::Polygon shape = packing::make_polygon(std::move(rings), fmt::format("{}: part '{}'", place, part.name));
    result.parts.push_back({std::move(part.name), part.demand, std::move(shape), std::move(part.angles)});
  }
  return result;
}

}  // namespace findspace::io
