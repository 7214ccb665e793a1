// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/proof/lower_bound.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "exact/margins/rounding.h"
#include "packing/problem/round_part.h"
#include "packing/proof/fewest_bins.h"
#include "plane/contour/decimal_grid.h"
#include "plane/offset/plain_sum.h"

namespace findspace::packing {
namespace {

exact::Real exact_twice_area(const Polygon& shape) {
  exact::Real sum;
  for (const Ring& ring : shape.rings)
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
      const LatticePoint p = ring[i] - ring[0], q = ring[i + 1] - ring[0];
      sum += exact::Real(p.x) * exact::Real(q.y) - exact::Real(p.y) * exact::Real(q.x);
    }
  return sum;
}

/// Half the gap, in grid steps: so far about each part no other one has that much about it.
exact::Real half_gap(const Problem& problem) {
  return exact::Real(problem.steps()) * exact::Real(problem.gap.numerator()) /
         exact::Real(2 * problem.gap.denominator());
}

double twice_area_about(const plane::Region& set, const exact::Real& by) {
  return RoundPart(plane::plain_offset(set, by)).twice_area();
}

/// Whether it is an exact set, or can be made one.
bool is_in_kernel(const Part& part) {
  const LatticeBox box = box_of(part.shape);
  constexpr int128 kMost = plane::Grid::kLimit;
  return part.round || (-kMost <= std::min(box.low.x, box.low.y) && std::max(box.high.x, box.high.y) <= kMost);
}

/// How far the boundary of a copy may be off that of the part at the copy's angle, in grid steps: a vertex by less than
/// one and what numbers of machine size lose, an arc, which keeps its radius, by less than three.
double most_moved(const Problem& problem, std::size_t number) {
  const Part& part = problem.parts[number];
  const auto is_rounded = [&](const FixedPart& fixed) {
    return fixed.placed.part == number && !is_quarter(fixed.placed.angle);
  };
  const bool is_exact = part.tilt == Fraction(0) && std::all_of(part.angles.begin(), part.angles.end(), is_quarter) &&
                        std::none_of(problem.fixed.begin(), problem.fixed.end(), is_rounded);
  const LatticeBox box = box_of(part.shape);
  const double reach = double(box.high.x - box.low.x) + double(box.high.y - box.low.y) + std::abs(double(box.low.x)) +
                       std::abs(double(box.low.y));
  return is_exact ? 0 : part.round ? 3 : 1 + margin::kRounding * reach;
}

/// Twice the area within so much of the boundary, rounded up. Chords of the polygon about a part are shorter than its
/// arcs by a thousandth at most, and their ends are on the grid.
exact::Real twice_area_near_boundary(const Part& part, double moved) {
  constexpr double kRounded = 2, kLonger = 1.001;
  double twice = 0;
  for (const Ring& ring : rotated(part, 0, false).rings) {
    double length = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const LatticePoint way = ring[(i + 1) % ring.size()] - ring[i];
      length += std::hypot(double(way.x), double(way.y)) + kRounded;
    }
    twice += 2 * (2 * moved * kLonger * length + std::numbers::pi * moved * moved);
  }
  return exact::Real::from_double(twice * (1 + margin::kRoundings16));
}

/// Of a copy and half the gap about it, in grid steps, rounded down. What is near a rounded copy is near the part, but
/// for twice as much as its boundary moved.
exact::Real least_twice_area(const Problem& problem, std::size_t number) {
  const Part& part = problem.parts[number];
  const double moved = most_moved(problem, number);
  const exact::Real about = half_gap(problem) - exact::Real::from_double(2 * moved);
  if (about.sign() > 0 && is_in_kernel(part)) {
    const double grown = twice_area_about(*region_of(part, 0, false), about);
    return exact::Real::from_double(grown * (1 - margin::kRoundings16));
  }
  const exact::Real stated = part.round
                                 ? exact::Real::from_double(part.round->twice_area() * (1 - margin::kRoundings16))
                                 : exact_twice_area(part.shape);
  if (moved == 0) return stated;
  const exact::Real least = stated - twice_area_near_boundary(part, moved);
  return least.sign() > 0 ? least : exact::Real();
}

/// What parts, with half the gap about them, can cover at most: of the sheet its area, and of the box about it what the
/// edge leaves. Where the edge is less than half the gap, that is of the box alone.
exact::Real most_twice_area(const Problem& problem, const Sheet& sheet) {
  const LatticeBox box = box_of(sheet);
  const exact::Real edge =
      exact::Real(problem.steps()) * exact::Real(problem.edge.numerator()) / exact::Real(problem.edge.denominator());
  const exact::Real reach = half_gap(problem) - edge, sides = reach + reach;
  const exact::Real width = exact::Real(box.high.x - box.low.x) + sides,
                    height = exact::Real(box.high.y - box.low.y) + sides;
  if (width.sign() <= 0 || height.sign() <= 0) return {};
  const exact::Real within = exact::Real(2) * width * height;
  if (reach.sign() > 0) return within;
  const exact::Real whole = sheet.round
                                ? exact::Real::from_double(sheet.round->twice_area() * (1 + margin::kRoundings16))
                                : exact_twice_area(sheet.shape);
  return within < whole ? within : whole;
}

Fraction fewest_sheets(const Problem& problem) {
  std::vector<Alike> sheets, parts;
  std::size_t fixed = 0;
  for (std::size_t k = 0; k < problem.sheets.size(); ++k) {
    const Sheet& sheet = problem.sheets[k];
    sheets.push_back({most_twice_area(problem, sheet), std::size_t(sheet.count)});
    fixed += sheets_with_fixed(problem, k);
  }
  for (std::size_t part = 0; part < problem.parts.size(); ++part)
    parts.push_back({least_twice_area(problem, part), std::size_t(problem.parts[part].demand)});
  return Fraction(int128(std::max(fixed, fewest_bins(std::move(sheets), std::move(parts)))));
}

/// Where the last fixed part ends, in whole grid steps behind its origin rounded down.
Fraction end_of_fixed(const Problem& problem) {
  Fraction end;
  for (const auto& [placed, kind] : problem.fixed) {
    const Part& part = problem.parts[placed.part];
    const int128 high = part.round ? exact::floor(part.round->at(placed.angle, placed.mirrored).high.x)
                                   : box_of(part, placed.angle, placed.mirrored).high.x;
    end = std::max(end, placed.x + Fraction(high, problem.steps()));
  }
  return end;
}

struct Size {
  int128 width, height;
};
/// At an angle in whole grid steps, rounded down.
Size size_at(const Part& part, const Fraction& angle, bool mirrored) {
  if (part.round) {
    const RoundPart::Form& form = part.round->at(angle, mirrored);
    return {exact::floor(form.high.x - form.low.x), exact::floor(form.high.y - form.low.y)};
  }
  const LatticeBox box = box_of(part, angle, mirrored);
  return {box.high.x - box.low.x, box.high.y - box.low.y};
}

/// As it may stand. Turned over, a part has another size where the angle is not a multiple of 90 degrees.
std::vector<Size> sizes_of(const Part& part) {
  std::vector<Size> result;
  for (const Fraction& angle : part.angles) {
    result.push_back(size_at(part, angle, false));
    if (part.mirrored && !is_quarter(angle)) result.push_back(size_at(part, angle, true));
  }
  return result;
}

/// The width at the narrowest angle at which the part fits the height; not of parts that may be tilted.
std::optional<int128> least_width(const Problem& problem, const Part& part) {
  if (part.tilt > 0) return std::nullopt;
  std::optional<int128> least;
  for (const auto& [width, height] : sizes_of(part)) {
    if (Fraction(height, problem.steps()) + problem.edge + problem.edge > problem.height) continue;
    least = std::min(least.value_or(width), width);
  }
  return least;
}

/// The side that a box needs both ways for the part: the least at any of its angles; 0 of parts that may be tilted.
double least_side(const Problem& problem, const Part& part) {
  if (part.tilt > 0) return 0;
  std::optional<int128> least;
  for (const auto& [width, height] : sizes_of(part)) least = std::min(least.value_or(width), std::min(width, height));
  return Fraction(least.value_or(0), problem.steps()).to_double();
}

/// The areas of all parts, with half the gap about each or without, in square units; exact where those of the parts
/// are.
exact::Real exact_least_area(const Problem& problem) {
  exact::Real twice;
  for (std::size_t part = 0; part < problem.parts.size(); ++part)
    if (const int demand = problem.parts[part].demand; demand > 0)
      twice += exact::Real(demand) * least_twice_area(problem, part);
  const exact::Real steps(problem.steps());
  return twice / (exact::Real(2) * steps * steps);
}

/// Rounded down.
double least_area(const Problem& problem) { return exact_least_area(problem).to_double() * (1 - margin::kRoundings16); }

Fraction rounded_down(const exact::Real& value) {
  constexpr std::int64_t kDecimals = 1000000;
  if (value.sign() <= 0) return {};
  return Fraction(exact::floor(value * exact::Real(kDecimals)), kDecimals);
}

/// By area. What lies within half the gap of parts lies within so much of the rectangle that the edge leaves. Without a
/// gap it is exact, so that a layout that fills the strip is known to be a shortest one.
Fraction least_length(const Problem& problem) {
  const Fraction height = problem.height - problem.edge - problem.edge, between = height + problem.gap;
  const double gap = problem.gap.to_double();
  const double ends = (gap * height.to_double() + std::numbers::pi / 4 * gap * gap) * (1 + margin::kRoundings16);
  const exact::Real area = exact_least_area(problem) - exact::Real::from_double(ends);
  return rounded_down(area * exact::Real(between.denominator()) / exact::Real(between.numerator()));
}

/// Of the rectangles w x h with (w + gap)(h + gap) no less than what parts with half the gap take, and both sides no
/// less than one part needs, the longest has the least area. The edge is least about a square.
Fraction least_box(const Problem& problem) {
  Problem touching = problem;
  touching.gap = 0;
  double side = 0;
  for (const Part& part : problem.parts)
    if (part.demand > 0) side = std::max(side, least_side(problem, part));
  const double gap = problem.gap.to_double(), edge = problem.edge.to_double();
  const double grown = least_area(problem) + (1 - std::numbers::pi / 4) * gap * gap;
  const double length = grown / (side + gap) * (1 - margin::kRoundings16) - gap;
  const double inner = std::max({least_area(touching), side * side, side * length});
  const double least = inner + 4 * edge * std::sqrt(inner) + 4 * edge * edge;
  return rounded_down(exact::Real::from_double(least * (1 - margin::kRoundings16)));
}

}  // namespace

Fraction lower_bound(const Problem& problem) {
  if (problem.on_sheets()) return fewest_sheets(problem);
  if (problem.box) return least_box(problem);
  Fraction widest;  // of what is not fixed: that may stand at any angle
  for (std::size_t part = 0; part < problem.parts.size(); ++part)
    if (problem.free_copies(part) > 0)
      if (const auto width = least_width(problem, problem.parts[part]))
        widest = std::max(widest, Fraction(*width, problem.steps()));
  const Fraction free_end = std::max(widest, least_length(problem)) + problem.edge;
  return std::max(free_end, end_of_fixed(problem)) + problem.edge;
}

}  // namespace findspace::packing
