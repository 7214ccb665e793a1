// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "io/nesting/unscaled_problem.h"

#include <findspace/error.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/nesting/fault_text.h"
#include "packing/problem/pair_formula.h"
#include "packing/problem/round_part.h"
#include "packing/proof/interiors.h"
#include "packing/proof/verify.h"
#include "plane/complex/overlay.h"
#include "plane/contour/decimal_grid.h"
#include "plane/query/scaled.h"
#include "plane/query/topology.h"

namespace findspace::io {
namespace {

using packing::Fraction;

/// The digits after the point; corners lie on a decimal grid.
int digits_of(const Fraction& value) {
  constexpr int kMost = 30;
  for (int digits = 0; digits <= kMost; ++digits)
    if (packing::power_of_ten(digits) % value.denominator() == 0) return digits;
  throw Error(ErrorCode::kBadValue, fmt::format("{} is not a decimal of at most {} digits", value.text(), kMost));
}

/// A gap is at least a thousand steps, for the polygon about its disc.
int gap_digits(const Fraction& gap) {
  int digits = 0;
  while (gap > 0 && Fraction(1000, packing::power_of_ten(digits)) > gap) ++digits;
  return digits;
}

int digits_of(const std::vector<UnscaledRing>& rings, const std::string& place) try {
  int digits = 0;
  for (const UnscaledRing& ring : rings)
    for (const auto& [x, y] : ring) digits = std::max({digits, digits_of(x), digits_of(y)});
  return digits;
} catch (const Error& e) {
  throw e.within(place);
}

/// A grid finer than the numbers is for what is rounded. Shapes on it, and parts with conditions, must stay below 2^40
/// steps.
constexpr int kDigitsOfShapes = 7;

bool has_conditions(const StatedConditions& stated) {
  return !stated.conditions.empty() || !stated.where.empty() || !stated.groups.empty();
}

/// An error of an outline whose points are grid steps, with them in units: in its words too.
Error in_units(const Error& e, packing::int128 steps) {
  std::vector<std::string> places;
  for (const auto& [x, y] : e.geometry())
    places.push_back(fmt::format("({:.6g}, {:.6g})", x / double(steps), y / double(steps)));
  const std::string where = places.empty()       ? ""
                            : places.size() == 1 ? " at " + places[0]
                                                 : ": its edges from " + places[0] + " and from " + places[1];
  Error out(e.code(), e.message() + where, e.place());
  for (const auto& [x, y] : e.geometry()) out.at(x / double(steps), y / double(steps));
  return out;
}

packing::Polygon on_steps(const std::vector<UnscaledRing>& rings, packing::int128 steps, const std::string& place) try {
  std::vector<packing::Ring> result;
  for (const UnscaledRing& ring : rings) {
    packing::Ring& out = result.emplace_back();
    for (const auto& [x, y] : ring) out.push_back({x.over(steps), y.over(steps)});
  }
  return packing::make_polygon(std::move(result), place);
} catch (const Error& e) {
  throw in_units(e, steps);
}

/// The outline and each hole as polygons.
std::vector<packing::Polygon> sets_of(const packing::Polygon& shape) {
  std::vector<packing::Polygon> sets;
  for (const packing::Ring& ring : shape.rings)
    sets.push_back({{sets.empty() ? ring : packing::Ring(ring.rbegin(), ring.rend())}});
  return sets;
}

/// What is not in an outline, as far as a hole reaches.
packing::Polygon outside_of(const packing::Polygon& outline, const packing::Polygon& hole) {
  const packing::LatticeBox a = box_of(outline), b = box_of(hole);
  const packing::LatticePoint low{std::min(a.low.x, b.low.x) - 1, std::min(a.low.y, b.low.y) - 1},
      high{std::max(a.high.x, b.high.x) + 1, std::max(a.high.y, b.high.y) + 1};
  const packing::Ring& ring = outline.rings[0];
  return {{{low, {high.x, low.y}, high, {low.x, high.y}}, packing::Ring(ring.rbegin(), ring.rend())}};
}

/// Whether two holes overlap, such as a defect that is marked twice, or one reaches beyond the outline; or whether
/// there is a wall without width between two, or between one and the outline: it belongs to no part.
bool holes_overlap(const std::vector<packing::Polygon>& sets) {
  std::vector<packing::LatticeBox> boxes;
  for (const packing::Polygon& set : sets) boxes.push_back(box_of(set));
  const auto meet = [](const packing::LatticeBox& a, const packing::LatticeBox& b) {
    return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
  };
  const auto in_reach = [](const packing::LatticePoint& p) {
    constexpr packing::int128 kMost = plane::Grid::kLimit;
    return -kMost <= p.x && p.x <= kMost && -kMost <= p.y && p.y <= kMost;
  };
  const bool drops_walls = in_reach(boxes[0].low) && in_reach(boxes[0].high);  // else a region could not be made
  const auto run_along = [&](const packing::Polygon& a, const packing::Polygon& b) {
    return drops_walls && packing::run_along(a, b);
  };
  for (std::size_t i = 1; i < sets.size(); ++i) {
    if (packing::interiors_meet(outside_of(sets[0], sets[i]), sets[i]) || run_along(sets[0], sets[i])) return true;
    for (std::size_t j = 1; j < i; ++j)
      if (meet(boxes[i], boxes[j]) && (packing::interiors_meet(sets[i], sets[j]) || run_along(sets[i], sets[j])))
        return true;
  }
  return false;
}

/// The same of rings; where these are faulty, that is said later.
bool holes_overlap(const std::vector<UnscaledRing>& rings, const std::string& place) {
  if (rings.size() < 2) return false;
  try {
    return holes_overlap(sets_of(on_steps(rings, packing::power_of_ten(digits_of(rings, place)), place)));
  } catch (const Error&) {
    return false;
  }
}

/// No corner of one is farther from its origin.
template <class Outlined>
double reach_of(const std::vector<Outlined>& shapes) {
  double reach = 0;
  for (const Outlined& shape : shapes)
    for (const UnscaledRing& ring : shape.rings)
      for (const auto& [x, y] : ring) reach = std::max(reach, std::abs(x.to_double()) + std::abs(y.to_double()));
  return reach;
}

int grid_digits(const UnscaledProblem& problem) {
  bool shapes = false, overlap = false;
  int digits = gap_digits(problem.gap), finer = 0;
  const auto see = [&](const auto& outlined, const std::string& place) {
    digits = std::max(digits, digits_of(outlined.rings, place));
    overlap = overlap || holes_overlap(outlined.rings, place);
    if (!outlined.shape) return;
    digits = std::max(digits, digits_of(outlined.shape->step));
    shapes = true;
  };
  for (const packing::PairGap& pair : problem.gaps) digits = std::max(digits, gap_digits(pair.gap));
  if (!problem.sheets.empty()) digits = std::max(digits, gap_digits(problem.edge));
  for (const UnscaledPart& part : problem.parts) {
    see(part, "part '" + part.name + "'");
    if (part.tilt > 0 || !std::all_of(part.angles.begin(), part.angles.end(), packing::is_quarter)) finer = 6;
  }
  for (const packing::FixedPart& fixed : problem.fixed)
    if (!packing::is_quarter(fixed.placed.angle)) finer = 6;
  for (const UnscaledSheet& sheet : problem.sheets) {
    const std::string place = "sheet '" + sheet.name + "'";
    see(sheet, place);
    for (const UnscaledZone& zone : sheet.zones) see(zone, place + ": a zone");
  }
  if (shapes) return std::max(digits, std::min(digits + finer, kDigitsOfShapes));
  // Pairs with conditions, and what holes that overlap leave, are sets of the kernel.
  double reach = overlap || has_conditions(problem) ? reach_of(problem.parts) : 0;
  if (overlap) reach = std::max(reach, reach_of(problem.sheets));
  while (finer > 0 && double(packing::power_of_ten(digits + finer)) * reach > double(plane::Grid::kLimit)) --finer;
  return digits + finer;
}

struct Outlined {
  packing::Polygon shape;  // of a round one a polygon about it
  std::shared_ptr<const packing::RoundPart> round = {};

  packing::LatticeBox box() const { return round ? round->at(0, false).box : box_of(shape); }
};

/// The outline without its holes.
plane::Region region_without(const std::vector<packing::Polygon>& sets) {
  std::vector<plane::Region> regions;
  for (const packing::Polygon& set : sets) regions.push_back(packing::region_of(set));
  std::vector<const plane::Region*> all;
  for (const plane::Region& region : regions) all.push_back(&region);
  return plane::closure(plane::subtract(all));
}

/// A polygon where the set is one; a round part otherwise. `steps`: in a unit.
Outlined outlined_as(plane::Region region, packing::int128 steps, const std::string& place) {
  const auto round = std::make_shared<const packing::RoundPart>(std::move(region), 1 / double(steps));
  if (auto rings = packing::rings_of(round->at(0, false).region))
    return {packing::make_polygon(std::move(*rings), place)};
  return {round->at(0, false).about, round};
}

template <class Unscaled>
Outlined outlined_on(const Unscaled& from, packing::int128 steps, const std::string& place) {
  packing::Polygon stated;
  if (!from.shape) stated = on_steps(from.rings, steps, place);
  try {
    if (!from.shape) {
      const std::vector<packing::Polygon> sets = sets_of(stated);
      return holes_overlap(sets) ? outlined_as(region_without(sets), steps, place) : Outlined{std::move(stated)};
    }
    const packing::int128 factor = from.shape->step.over(steps);
    return outlined_as(factor == 1 ? *from.shape->region : plane::scaled(from.shape->region, std::int64_t(factor)),
                       steps, place);
  } catch (const Error& e) {
    throw e.within(place);
  }
}

packing::Part part_on(UnscaledPart& part, packing::int128 steps, const std::string& place) {
  const std::string own = fmt::format("{}: part '{}'", place, part.name);
  Outlined outlined = outlined_on(part, steps, own);
  packing::Part result{std::move(part.name), part.demand, std::move(outlined.shape), std::move(part.angles),
                       part.mirrored,        part.value,  std::move(outlined.round), part.tilt};
  if (!result.round) return result;
  try {
    for (const Fraction& angle : result.angles)
      for (const bool mirrored : {false, true})
        if (!mirrored || result.mirrored) result.round->at(angle, mirrored);  // errors are here
  } catch (const Error& e) {
    throw e.within(own);
  }
  return result;
}

packing::Zone zone_on(UnscaledZone& zone, const packing::LatticeBox& sheet, const packing::Problem& problem,
                      const std::string& place) {
  Outlined outlined = outlined_on(zone, problem.steps(), place + ": a zone");
  const packing::LatticeBox in = outlined.box();
  if (in.low.x < 0 || in.low.y < 0 || in.high.x > sheet.high.x || in.high.y > sheet.high.y)
    throw Error(ErrorCode::kGeometry, "a zone reaches beyond its sheet", place);
  packing::Zone result{std::move(outlined.shape), std::move(zone.parts), zone.holds, std::move(outlined.round)};
  if (result.round && result.holds) result.about = what_is_about(*result.round, box_about(problem, sheet));
  return result;
}

packing::Sheet sheet_on(UnscaledSheet& sheet, const packing::Problem& problem, const std::string& place) {
  const std::string own = fmt::format("{}: sheet '{}'", place, sheet.name);
  Outlined outlined = outlined_on(sheet, problem.steps(), own);
  const packing::LatticeBox box = outlined.box();
  if (box.low.x != 0 || box.low.y != 0) throw Error(ErrorCode::kGeometry, "a sheet's box begins at (0, 0)", own);
  packing::Sheet result{std::move(sheet.name), sheet.count, sheet.cost, std::move(outlined.shape)};
  result.round = std::move(outlined.round);
  if (result.round) result.about = what_is_about(*result.round, box_about(problem, box));
  for (UnscaledZone& zone : sheet.zones) result.zones.push_back(zone_on(zone, box, problem, own));
  return result;
}

/// Where one part is a shape, the kernel sees all parts and sheets on the problem's grid.
void check_reach(const packing::Problem& problem, const std::string& place) {
  const auto check = [&](const packing::LatticeBox& box, const std::string& name) {
    for (const packing::int128 c : {box.low.x, box.low.y, box.high.x, box.high.y})
      if (c < -plane::Grid::kLimit || c > plane::Grid::kLimit)
        throw Error(ErrorCode::kOutOfRange,
                    fmt::format("'{}' is too large for the {} digits of the problem's grid", name, problem.digits),
                    place);
  };
  for (const packing::Part& part : problem.parts) check(box_of(part, 0, false), part.name);
  for (const packing::Sheet& sheet : problem.sheets) check(box_of(sheet), sheet.name);
}

/// On one sheet no gap is larger than width and height of the largest; nothing on a strip.
std::optional<Fraction> farthest_gap(const packing::Problem& problem) {
  std::optional<Fraction> result;
  for (const packing::Sheet& sheet : problem.sheets) {
    const packing::LatticeBox box = box_of(sheet);
    result = std::max(result.value_or(0), Fraction(box.high.x + box.high.y, problem.steps()));
  }
  return result;
}

/// The fixed parts alone, as a layout.
packing::Layout layout_of_fixed(const packing::Problem& problem) {
  packing::Layout layout;
  std::vector<std::size_t> first_of_kind;
  for (std::size_t kind = 0; kind < problem.sheets.size(); ++kind) {
    first_of_kind.push_back(layout.sheets.size());
    layout.sheets.insert(layout.sheets.end(), sheets_with_fixed(problem, kind), kind);
  }
  std::vector<int> copies(problem.parts.size());
  for (const packing::FixedPart& f : problem.fixed) {
    layout.items.push_back(f.placed);
    layout.items.back().copy = ++copies[f.placed.part];
    if (problem.on_sheets()) layout.items.back().sheet += first_of_kind[f.kind];
    const packing::LatticeBox box = box_of(problem.parts[f.placed.part], f.placed.angle, f.placed.mirrored);
    layout.length = std::max(layout.length, f.placed.x + Fraction(box.high.x, problem.steps()) + problem.edge);
  }
  for (std::size_t part = 0; part < problem.parts.size(); ++part)
    layout.left_out.push_back({part, problem.free_copies(part), ""});
  return layout;
}

void check_fixed(const packing::Problem& problem, const std::string& place) {
  if (problem.fixed.empty()) return;
  if (problem.box)
    throw Error(ErrorCode::kUnsupported, "fixed parts stand on a strip or on sheets, not in a box", place);
  for (std::size_t part = 0; part < problem.parts.size(); ++part)
    if (problem.free_copies(part) < 0)
      throw Error(ErrorCode::kBadValue,
                  fmt::format("more copies of '{}' are fixed than its demand", problem.parts[part].name), place);
  const packing::Layout layout = layout_of_fixed(problem);
  for (std::size_t k = 0; k < layout.sheets.size(); ++k)
    if (std::none_of(layout.items.begin(), layout.items.end(), [&](const auto& item) { return item.sheet == k; }))
      throw Error(ErrorCode::kBadValue,
                  fmt::format("sheets '{}' with fixed parts are numbered from 1 on, without a gap",
                              problem.sheets[layout.sheets[k]].name),
                  place);
  const packing::Verdict verdict = packing::verify(problem, layout);
  if (!verdict.feasible())
    throw Error(ErrorCode::kGeometry, "fixed: " + fault_text(problem, layout, verdict.faults[0]), place);
}

}  // namespace

packing::Problem UnscaledProblem::on_grid(const std::string& place) && {
  packing::Problem result;
  result.name = std::move(name);
  result.height = height;
  result.box = box;
  result.gap = gap;
  result.edge = edge;
  result.pair_gaps = gaps;
  if (gap < 0 || edge < 0) throw Error(ErrorCode::kBadValue, "a gap or an edge below 0", place);
  if (sheets.empty() && !box && height <= edge + edge)
    throw Error(ErrorCode::kBadValue, "the strip has no height between its edges", place);
  result.digits = grid_digits(*this);
  const packing::int128 steps = result.steps();
  for (UnscaledPart& part : parts) result.parts.push_back(part_on(part, steps, place));
  for (UnscaledSheet& sheet : sheets) result.sheets.push_back(sheet_on(sheet, result, place));
  if (result.has_round_parts()) check_reach(result, place);
  result.conditions = conditions_of(*this, result.parts.size(), farthest_gap(result), place);
  for (const packing::PairCondition& condition : result.conditions) packing::parse_condition(condition.where);
  result.fixed = std::move(fixed);
  check_fixed(result, place);
  return result;
}

}  // namespace findspace::io
