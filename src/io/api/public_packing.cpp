// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Packing as the public header shows it: problems and layouts as values with names, put on one grid and back.

#include "io/api/public_packing.h"

#include <findspace/error.h>
#include <findspace/packing.h>
#include <fmt/format.h>

#include "api/values/region_data.h"
#include "io/api/public_search.h"
#include "io/nesting/fault_text.h"
#include "io/nesting/read_nesting.h"
#include "io/nesting/unscaled_problem.h"
#include "io/nesting/write_layout.h"
#include "packing/proof/lower_bound.h"
#include "packing/proof/verify.h"
#include "packing/search/box_search.h"
#include "packing/search/refined_search.h"
#include "plane/query/topology.h"

namespace findspace {
namespace {

using packing::Fraction;

using io::amount_of;
using io::count_of;
using io::fraction;
using io::index_of;
using io::public_amount;

std::vector<io::UnscaledRing> rings_of(const std::vector<Ring>& rings) {
  std::vector<io::UnscaledRing> result;
  for (const Ring& ring : rings) {
    io::UnscaledRing& out = result.emplace_back();
    for (const Point& p : ring) out.push_back({fraction(p.x), fraction(p.y)});
  }
  return result;
}

/// The closure; RoundPart refuses what is not an area.
/// Of a part, sheet or zone.
template <class Outlined, class Unscaled>
void take_outline(const Outlined& from, const std::string& what, Unscaled& to) {
  to.rings = rings_of(from.rings);
  if (!from.shape) return;
  if (!from.rings.empty()) throw Error(ErrorCode::kBadValue, what + " has both rings and a shape");
  if (from.shape->dimension() != 2) throw Error(ErrorCode::kUnsupported, what + " is a shape of the plane");
  to.shape = {plane::closure(from.shape->region().data().cells), fraction(from.shape->grid().step)};
}

io::UnscaledPart part_of(const PackPart& part) {
  io::UnscaledPart result{part.name, count_of(part.count), {}, {}, part.mirrored, amount_of(part.value)};
  take_outline(part, "part '" + part.name + "'", result);
  for (const Number& angle : part.angles) result.angles.push_back(fraction(angle));
  if (result.angles.empty()) result.angles.push_back(0);
  result.tilt = fraction(part.tilt);
  if (result.tilt < 0 || result.tilt > 180)
    throw Error(ErrorCode::kBadValue, "part '" + part.name + "': a tilt is from 0 to 180 degrees");
  return result;
}

io::UnscaledSheet sheet_of(const PackSheet& sheet, const std::vector<io::UnscaledPart>& parts) {
  io::UnscaledSheet result{sheet.name, count_of(sheet.count), amount_of(sheet.cost), {}, {}};
  take_outline(sheet, "sheet '" + sheet.name + "'", result);
  for (const PackZone& zone : sheet.zones) {
    io::UnscaledZone& out = result.zones.emplace_back();
    take_outline(zone, "a zone of sheet '" + sheet.name + "'", out);
    if (!zone.keeps_out.empty() && !zone.holds.empty())
      throw Error(ErrorCode::kBadValue, "a zone keeps parts out or holds them");
    out.holds = !zone.holds.empty();
    for (const std::string& name : out.holds ? zone.holds : zone.keeps_out)
      out.parts.push_back(index_of(name, parts, "part"));
  }
  return result;
}

packing::FixedPart fixed_of(const FixedPart& fixed, const io::UnscaledProblem& problem) {
  packing::FixedPart result;
  result.placed = {index_of(fixed.part, problem.parts, "part"),
                   1,
                   fraction(fixed.angle),
                   fixed.mirrored,
                   fraction(fixed.x),
                   fraction(fixed.y)};
  if (problem.sheets.empty()) {
    if (!fixed.sheet.empty() || fixed.number != 1)
      throw Error(ErrorCode::kBadValue, "a sheet is said, but there are no sheets", "fixed part '" + fixed.part + "'");
    return result;
  }
  result.kind = index_of(fixed.sheet, problem.sheets, "sheet");
  if (fixed.number < 1 || fixed.number > problem.sheets[result.kind].count)
    throw Error(ErrorCode::kBadValue, fmt::format("there is no sheet {} number {}", fixed.sheet, fixed.number));
  result.placed.sheet = std::size_t(fixed.number - 1);
  return result;
}

packing::Problem on_grid(const PackProblem& problem) {
  io::UnscaledProblem result;
  result.name = problem.name;
  result.box = problem.box && problem.sheets.empty();
  if (!result.box) result.height = fraction(problem.height);
  result.gap = fraction(problem.gap);
  result.edge = fraction(problem.edge);
  for (const PackPart& part : problem.parts) result.parts.push_back(part_of(part));
  io::check_names(result.parts, "parts");
  for (const PackSheet& sheet : problem.sheets) result.sheets.push_back(sheet_of(sheet, result.parts));
  io::check_names(result.sheets, "sheets");
  static_cast<io::StatedConditions&>(result) = io::stated_of(problem, result.parts);
  for (const FixedPart& fixed : problem.fixed) result.fixed.push_back(fixed_of(fixed, result));
  return std::move(result).on_grid("pack");
}

PackLayout public_layout(const packing::Problem& problem, const packing::Layout& layout) {
  PackLayout result;
  result.length = layout.length.text();
  result.height = layout.height.text();
  for (const packing::Placed& item : layout.items)
    result.items.push_back({problem.parts[item.part].name, item.copy, item.sheet, item.angle.text(), item.mirrored,
                            item.x.text(), item.y.text()});
  for (const packing::LeftOut& out : layout.left_out)
    result.left_out.push_back({problem.parts[out.part].name, out.copies, out.why});
  for (const std::size_t kind : layout.sheets) result.sheets.push_back(problem.sheets[kind].name);
  if (const auto left = packing::largest_remnant(problem, layout))
    result.remnant = {left->sheet, left->x.text(), left->y.text(), left->width.text(), left->height.text()};
  const double room = packing::container_area(problem, layout);
  result.density = room > 0 ? packing::area(problem, layout) / room : 0;
  return result;
}

packing::Layout layout_of(const packing::Problem& problem, const PackLayout& layout) {
  packing::Layout result;
  result.length = fraction(layout.length);
  result.height = fraction(layout.height);
  for (const PlacedPart& item : layout.items)
    result.items.push_back({index_of(item.part, problem.parts, "part"), item.copy, fraction(item.angle), item.mirrored,
                            fraction(item.x), fraction(item.y), item.sheet});
  for (const LeftOutPart& out : layout.left_out)
    result.left_out.push_back({index_of(out.part, problem.parts, "part"), out.copies, out.why});
  for (const std::string& name : layout.sheets) result.sheets.push_back(index_of(name, problem.sheets, "sheet"));
  return result;
}

io::LayoutFacts facts_of(const packing::Problem& problem, const packing::Layout& layout) {
  io::LayoutFacts facts;
  const packing::Verdict verdict = packing::verify(problem, layout);
  facts.proven = verdict.feasible();
  facts.density = verdict.density;
  if (facts.proven) facts.remnant = packing::largest_remnant(problem, layout);
  if (!problem.on_sheets() && !problem.box) facts.lower_bound = packing::lower_bound(problem);
  return facts;
}

std::vector<Ring> public_rings(const std::vector<io::UnscaledRing>& rings) {
  std::vector<Ring> result;
  for (const io::UnscaledRing& ring : rings) {
    Ring& out = result.emplace_back();
    for (const auto& [x, y] : ring) out.push_back({x.text(), y.text()});
  }
  return result;
}

std::optional<Shape> public_shape(const std::optional<io::UnscaledShape>& shape) {
  if (!shape) return std::nullopt;
  const plane::Grid grid(exact::Real::parse_decimal(shape->step.text()));
  return Shape(api::make_region(*shape->region, grid));
}

PackPart public_part(const io::UnscaledPart& part) {
  PackPart result{part.name,
                  public_rings(part.rings),
                  part.demand,
                  {},
                  part.mirrored,
                  public_amount(part.value),
                  public_shape(part.shape)};
  for (const Fraction& angle : part.angles) result.angles.push_back(angle.text());
  result.tilt = part.tilt.text();
  return result;
}

}  // namespace

PackSheet PackSheet::rectangle(std::string name, const Number& width, const Number& height, int count) {
  return {std::move(name), {{{0, 0}, {width, 0}, {width, height}, {0, height}}}, count};
}

PackPart PackPart::of(std::string name, Shape shape, int count) {
  PackPart result{std::move(name), {}, count};
  result.shape = std::move(shape);
  return result;
}

std::optional<PackLayout> pack(const PackProblem& problem, const Options& options,
                               const std::function<void(const PackLayout&)>& better) {
  const packing::Problem inner = on_grid(problem);
  const auto search = inner.box ? packing::search_box : packing::search_refined;
  const auto shown = [&](const packing::Layout& layout) { return public_layout(inner, layout); };
  return io::searched<packing::Layout, PackLayout>(options, better, shown,
                                                   [&](const auto&... how) { return search(inner, how...); });
}

std::vector<std::string> layout_faults(const PackProblem& problem, const PackLayout& layout) {
  const packing::Problem inner = on_grid(problem);
  const packing::Layout placed = layout_of(inner, layout);
  std::vector<std::string> result;
  for (const packing::Fault& fault : packing::verify(inner, placed).faults)
    result.push_back(io::fault_text(inner, placed, fault));
  return result;
}

PackProblem pack_problem(std::string_view json) {
  const io::UnscaledProblem inner = io::read_unscaled(std::string(json), "problem");
  io::UnscaledProblem(inner).on_grid("problem");  // refuses what is wrong
  PackProblem result;
  result.name = inner.name;
  result.height = inner.height.text();
  result.box = inner.box;
  const auto name_of = [&](std::size_t part) { return inner.parts[part].name; };
  for (const io::UnscaledPart& part : inner.parts) result.parts.push_back(public_part(part));
  for (const io::UnscaledSheet& sheet : inner.sheets) {
    PackSheet& out = result.sheets.emplace_back();
    out = {sheet.name, public_rings(sheet.rings), sheet.count, public_amount(sheet.cost),
           {},         public_shape(sheet.shape)};
    for (const io::UnscaledZone& zone : sheet.zones) {
      PackZone& shown = out.zones.emplace_back();
      shown.rings = public_rings(zone.rings);
      shown.shape = public_shape(zone.shape);
      for (const std::size_t part : zone.parts) (zone.holds ? shown.holds : shown.keeps_out).push_back(name_of(part));
    }
  }
  io::show_stated(inner, io::names_of(inner.parts), result);
  for (const packing::FixedPart& f : inner.fixed)
    result.fixed.push_back({name_of(f.placed.part), f.placed.x.text(), f.placed.y.text(), f.placed.angle.text(),
                            f.placed.mirrored, inner.sheets.empty() ? "" : inner.sheets[f.kind].name,
                            int(f.placed.sheet) + 1});
  return result;
}

std::string layout_json(const PackProblem& problem, const PackLayout& layout) {
  const packing::Problem inner = on_grid(problem);
  const packing::Layout placed = layout_of(inner, layout);
  return io::layout_json(inner, placed, facts_of(inner, placed));
}

std::string layout_svg(const PackProblem& problem, const PackLayout& layout) {
  const packing::Problem inner = on_grid(problem);
  const packing::Layout placed = layout_of(inner, layout);
  return io::layout_svg(inner, placed, facts_of(inner, placed));
}

}  // namespace findspace
