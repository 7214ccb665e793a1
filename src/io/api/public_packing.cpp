// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Packing as the public header shows it: problems and layouts as values with names, put on one grid and back.

#include "io/api/public_packing.h"

#include <findspace/error.h>
#include <findspace/packing.h>
#include <fmt/format.h>

#include <algorithm>
#include <mutex>
#include <utility>

#include "api/values/region_data.h"
#include "io/api/last_verdict.h"
#include "io/api/public_search.h"
#include "io/nesting/fault_text.h"
#include "io/nesting/read_nesting.h"
#include "io/nesting/unscaled_problem.h"
#include "io/nesting/write_layout.h"
#include "packing/proof/lower_bound.h"
#include "packing/proof/verify.h"
#include "packing/search/box_search.h"
#include "packing/search/make_room.h"
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
  if (!result.box) result.height = fraction(problem.height, "height");
  result.gap = fraction(problem.gap, "gap");
  result.edge = fraction(problem.edge, "edge");
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
    result.left_out.push_back({index_of(out.part, problem.parts, "part"), count_of(out.copies), out.why});
  for (const std::string& name : layout.sheets) result.sheets.push_back(index_of(name, problem.sheets, "sheet"));
  return result;
}

[[noreturn]] void refuse_layout(const std::string& why) { throw Error(ErrorCode::kBadValue, "the layout " + why); }

/// Of each part and of each sheet as many as the problem has, and every item on one of its sheets. Throws Error.
void check_counts(const packing::Problem& problem, const packing::Layout& layout) {
  std::vector<std::int64_t> missing, unused;
  for (const packing::Part& part : problem.parts) missing.push_back(part.demand);
  for (const packing::Placed& item : layout.items) --missing[item.part];
  for (const packing::LeftOut& out : layout.left_out) missing[out.part] -= out.copies;
  if (std::any_of(missing.begin(), missing.end(), [](std::int64_t count) { return count != 0; }))
    refuse_layout("has other parts than the problem");
  for (const packing::Sheet& sheet : problem.sheets) unused.push_back(sheet.count);
  for (const std::size_t kind : layout.sheets)
    if (--unused[kind] < 0)
      refuse_layout(fmt::format("uses more sheets '{}' than there are", problem.sheets[kind].name));
  const std::size_t sheets = problem.on_sheets() ? layout.sheets.size() : 1;
  for (std::size_t i = 0; i < layout.items.size(); ++i)
    if (layout.items[i].sheet >= sheets)
      refuse_layout(fmt::format("has {} on sheet {}, which it does not list", io::item_name(problem, layout, i),
                                layout.items[i].sheet));
}

/// Whether a search may begin with the layout, or an item of it be moved. Throws Error.
void check_layout_of(const packing::Problem& problem, const packing::Layout& layout) {
  check_counts(problem, layout);
  for (const packing::FixedPart& fixed : problem.fixed) {
    const auto is_it = [&](const packing::Placed& item) { return packing::is_fixed_part(layout, item, fixed); };
    if (std::count_if(layout.items.begin(), layout.items.end(), is_it) != 1)
      refuse_layout(fmt::format("lacks the fixed part '{}' at ({}, {}), or has it twice",
                                problem.parts[fixed.placed.part].name, fixed.placed.x.text(), fixed.placed.y.text()));
  }
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

PackProblem public_problem(const io::UnscaledProblem& inner) {
  PackProblem result;
  result.name = inner.name;
  result.height = inner.height.text();
  result.box = inner.box;
  result.gap = inner.gap.text();
  result.edge = inner.edge.text();
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

PackFault::Kind kind_of(packing::Fault::Kind kind) {
  using From = packing::Fault::Kind;
  using To = PackFault::Kind;
  switch (kind) {
    case From::kOverlap:
      return To::kOverlap;
    case From::kGap:
      return To::kGap;
    case From::kCondition:
      return To::kCondition;
    case From::kOutside:
      return To::kOutside;
    case From::kAngle:
      return To::kAngle;
    case From::kZone:
      return To::kZone;
    case From::kCount:
      return To::kCount;
    case From::kSheets:
      return To::kSheets;
    case From::kFixed:
      break;
  }
  return To::kFixed;
}

PackFault public_fault(const packing::Problem& problem, const packing::Layout& layout, const packing::Fault& fault) {
  using Kind = packing::Fault::Kind;
  PackFault result{kind_of(fault.kind), {}, fault.depth, {fault.x, fault.y}, io::fault_text(problem, layout, fault)};
  if (fault.kind == Kind::kCount || fault.kind == Kind::kFixed)
    result.of.push_back(problem.parts[fault.first].name);
  else if (fault.kind == Kind::kSheets)
    result.of.push_back(problem.sheets[fault.first].name);
  else
    result.of.push_back(io::item_name(problem, layout, fault.first));
  if (fault.kind <= Kind::kCondition) result.of.push_back(io::item_name(problem, layout, fault.second));
  return result;
}

}  // namespace

struct Packing::Data {
  packing::Problem problem;
  std::vector<std::string> notes;
  Fraction bound;

  explicit Data(const PackProblem& values) : problem(on_grid(values)), given_(values) { find_bound(); }
  Data(io::UnscaledProblem stated, const std::string& name) : notes(stated.notes), stated_(stated) {
    problem = std::move(stated).on_grid(name);
    find_bound();
  }
  /// Of a drawing that has both: its parts are polygons of the grid.
  explicit Data(packing::Problem drawn) : problem(std::move(drawn)) {
    io::UnscaledProblem stated;
    stated.height = problem.height;
    for (const packing::Part& part : problem.parts) stated.parts.push_back(unscaled(part));
    stated_ = std::move(stated);
    find_bound();
  }

  const PackProblem& values() const {
    std::call_once(made_, [&] {
      if (!given_) given_ = public_problem(*stated_);
    });
    return *given_;
  }
  packing::Verdict verdict(const packing::Layout& placed) const {
    return last_.of(placed, [&] { return packing::verify(problem, placed); });
  }

 private:
  void find_bound() { bound = packing::lower_bound(problem); }
  io::UnscaledPart unscaled(const packing::Part& part) const {
    io::UnscaledPart out{part.name, part.demand, {}, part.angles, part.mirrored};
    for (const packing::Ring& ring : part.shape.rings) {
      io::UnscaledRing& to = out.rings.emplace_back();
      for (const packing::LatticePoint& p : ring)
        to.push_back({Fraction(p.x, problem.steps()), Fraction(p.y, problem.steps())});
    }
    return out;
  }

  std::optional<io::UnscaledProblem> stated_ = {};  // what was read
  mutable std::once_flag made_{};
  mutable std::optional<PackProblem> given_ = {};
  io::LastVerdict<packing::Layout, packing::Verdict> last_{};
};

namespace {

io::LayoutFacts facts_of(const Packing::Data& data, const packing::Layout& placed, const PackLayout& layout) {
  io::LayoutFacts facts;
  const packing::Verdict verdict = data.verdict(placed);
  facts.proven = verdict.feasible();
  facts.density = verdict.density;
  if (facts.proven) facts.remnant = packing::largest_remnant(data.problem, placed);
  facts.lower_bound = data.bound;
  facts.seconds = layout.seconds;
  facts.seed = layout.seed;
  facts.threads = layout.threads;
  return facts;
}

}  // namespace

namespace {

std::size_t kind_of_sheet(const packing::Problem& problem, std::size_t sheet) {
  if (sheet >= problem.sheets.size()) throw Error(ErrorCode::kBadValue, fmt::format("there is no sheet {}", sheet));
  return sheet;
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

Packing::Packing(const PackProblem& problem) : data_(std::make_shared<const Data>(problem)) {}

Packing Packing::json(std::string_view text, const PackReading& reading) {
  return Packing(std::make_shared<const Data>(
      io::read_unscaled(std::string(text), reading.name, io::nesting_options(reading)), reading.name));
}

std::pair<Packing, PackLayout> Packing::sparrow(std::string_view svg, const std::string& name) {
  io::ProblemAndLayout read = io::read_sparrow_svg(std::string(svg), name);
  PackLayout layout = public_layout(read.problem, read.layout);
  return {Packing(std::make_shared<const Data>(std::move(read.problem))), std::move(layout)};
}

const PackProblem& Packing::problem() const { return data_->values(); }
const std::vector<std::string>& Packing::notes() const { return data_->notes; }
std::size_t Packing::copies() const { return data_->problem.items(); }
Number Packing::lower_bound() const { return data_->bound.text(); }

std::optional<PackLayout> Packing::search(const Options& options, const PackSearch<PackLayout>& how) const {
  const packing::Problem& inner = data_->problem;
  std::optional<packing::Layout> start;
  if (how.start) {
    start = layout_of(inner, *how.start);
    check_layout_of(inner, *start);
  }
  const auto search = inner.box ? packing::search_box : packing::search_refined;
  const auto shown = [&](const packing::Layout& layout) { return public_layout(inner, layout); };
  return io::searched<packing::Layout, PackLayout>(options, how, start ? &*start : nullptr, shown,
                                                   [&](const auto&... asked) { return search(inner, asked...); });
}

void Packing::check_start(const PackLayout& layout) const {
  check_layout_of(data_->problem, layout_of(data_->problem, layout));
}

PackVerdict Packing::verdict(const PackLayout& layout) const {
  const packing::Layout placed = layout_of(data_->problem, layout);
  const packing::Verdict found = data_->verdict(placed);
  PackVerdict result{{}, found.used.text(), found.density};
  for (const packing::Fault& fault : found.faults) result.faults.push_back(public_fault(data_->problem, placed, fault));
  return result;
}

std::optional<PackLayout> Packing::moved(const PackLayout& layout, std::size_t item, const Position& at) const {
  const packing::Problem& inner = data_->problem;
  io::check_item(item, layout.items.size());
  const packing::Layout before = layout_of(inner, layout);
  check_layout_of(inner, before);
  for (const packing::FixedPart& fixed : inner.fixed)
    if (packing::is_fixed_part(before, before.items[item], fixed))
      throw Error(ErrorCode::kBadValue, "part '" + layout.items[item].part + "' is fixed where it stands");
  const auto made = packing::with_room(inner, before, item, at);
  return made ? std::optional(public_layout(inner, *made)) : std::nullopt;
}

PackLayout Packing::layout(std::string_view json, const std::string& name) const {
  return public_layout(data_->problem, io::read_layout(std::string(json), name, data_->problem));
}

std::string Packing::json(const PackLayout& layout) const {
  const packing::Layout placed = layout_of(data_->problem, layout);
  return io::layout_json(data_->problem, placed, facts_of(*data_, placed, layout));
}

std::string Packing::svg(const PackLayout& layout) const {
  const packing::Layout placed = layout_of(data_->problem, layout);
  return io::layout_svg(data_->problem, placed, facts_of(*data_, placed, layout));
}

std::string Packing::dxf(const PackLayout& layout, DxfVersion version) const {
  return io::layout_dxf(data_->problem, layout_of(data_->problem, layout), version);
}

std::string Packing::outline(std::size_t part) const {
  if (part >= data_->problem.parts.size()) throw Error(ErrorCode::kBadValue, fmt::format("there is no part {}", part));
  return io::outline_path(data_->problem, part);
}

std::string Packing::sheet_outline(std::size_t sheet) const {
  return io::sheet_path(data_->problem, kind_of_sheet(data_->problem, sheet));
}

std::string Packing::sheet_zones(std::size_t sheet) const {
  return io::zones_path(data_->problem, kind_of_sheet(data_->problem, sheet));
}

std::optional<PackLayout> pack(const PackProblem& problem, const Options& options,
                               const std::function<void(const PackLayout&)>& better) {
  PackSearch<PackLayout> how;
  if (better) how.better = [&](const PackLayout& layout, const PackProgress&) { better(layout); };
  return Packing(problem).search(options, how);
}

std::vector<std::string> layout_faults(const PackProblem& problem, const PackLayout& layout) {
  return io::texts_of(Packing(problem).verdict(layout));
}

PackProblem pack_problem(std::string_view json) { return Packing::json(json).problem(); }
std::string layout_json(const PackProblem& problem, const PackLayout& layout) { return Packing(problem).json(layout); }
std::string layout_svg(const PackProblem& problem, const PackLayout& layout) { return Packing(problem).svg(layout); }

}  // namespace findspace
