// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Packing as the public header shows it: problems and layouts as values with names, put on one grid and back.

#include <findspace/error.h>
#include <findspace/packing.h>

#include <algorithm>
#include <atomic>

#include "io/nesting/fault_text.h"
#include "io/nesting/read_nesting.h"
#include "io/nesting/unscaled_problem.h"
#include "io/nesting/write_layout.h"
#include "packing/proof/lower_bound.h"
#include "packing/proof/verify.h"
#include "packing/search/box_search.h"

namespace findspace {
namespace {

using packing::Fraction;

Fraction fraction(const Number& number) { return Fraction::parse(number.text()); }

template <class Named>
std::size_t index_of(const std::string& name, const std::vector<Named>& all, const char* what) {
  const auto same = [&](const Named& one) { return one.name == name; };
  const auto found = std::find_if(all.begin(), all.end(), same);
  if (found == all.end()) throw Error(ErrorCode::kUnknownName, std::string("there is no ") + what + " '" + name + "'");
  return std::size_t(found - all.begin());
}

std::vector<io::UnscaledRing> rings_of(const std::vector<Ring>& rings) {
  std::vector<io::UnscaledRing> result;
  for (const Ring& ring : rings) {
    io::UnscaledRing& out = result.emplace_back();
    for (const Point& p : ring) out.push_back({fraction(p.x), fraction(p.y)});
  }
  return result;
}

int count_of(int count) {
  if (count < 0) throw Error(ErrorCode::kBadValue, "a count below 0");
  return count;
}

std::optional<Fraction> amount_of(const std::optional<Number>& amount) {
  if (!amount) return std::nullopt;
  if (fraction(*amount) < 0) throw Error(ErrorCode::kBadValue, "a value or cost below 0");
  return fraction(*amount);
}

io::UnscaledPart part_of(const PackPart& part) {
  io::UnscaledPart result{part.name, count_of(part.count), rings_of(part.rings),
                          {},        part.mirrored,        amount_of(part.value)};
  for (const Number& angle : part.angles) result.angles.push_back(fraction(angle));
  if (result.angles.empty()) result.angles.push_back(0);
  return result;
}

io::UnscaledSheet sheet_of(const PackSheet& sheet, const std::vector<io::UnscaledPart>& parts) {
  io::UnscaledSheet result{sheet.name, count_of(sheet.count), amount_of(sheet.cost), rings_of(sheet.rings), {}};
  for (const PackZone& zone : sheet.zones) {
    io::UnscaledZone& out = result.zones.emplace_back();
    out.rings = rings_of(zone.rings);
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
  if (problem.sheets.empty()) return result;
  result.kind = index_of(fixed.sheet, problem.sheets, "sheet");
  if (fixed.number < 1 || fixed.number > problem.sheets[result.kind].count)
    throw Error(ErrorCode::kBadValue, "there is no sheet of that number");
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
  for (const PackSheet& sheet : problem.sheets) result.sheets.push_back(sheet_of(sheet, result.parts));
  for (const PackGap& pair : problem.gaps)
    result.pair_gaps.push_back(
        {index_of(pair.first, result.parts, "part"), index_of(pair.second, result.parts, "part"), fraction(pair.gap)});
  for (const PackCondition& c : problem.conditions)
    result.conditions.push_back(
        {index_of(c.first, result.parts, "part"), index_of(c.second, result.parts, "part"), c.where});
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
  if (!problem.on_sheets() && !problem.box) facts.lower_bound = packing::lower_bound(problem);
  return facts;
}

/// A number of the problem's grid as text.
Point public_point(const packing::LatticePoint& p, packing::int128 steps) {
  return {Fraction(p.x, steps).text(), Fraction(p.y, steps).text()};
}

std::vector<Ring> public_rings(const packing::Polygon& shape, packing::int128 steps) {
  std::vector<Ring> result;
  for (const packing::Ring& ring : shape.rings) {
    Ring& out = result.emplace_back();
    for (const packing::LatticePoint& p : ring) out.push_back(public_point(p, steps));
  }
  return result;
}

std::optional<Number> public_amount(const std::optional<Fraction>& amount) {
  return amount ? std::optional<Number>(amount->text()) : std::nullopt;
}

}  // namespace

PackSheet PackSheet::rectangle(std::string name, const Number& width, const Number& height, int count) {
  return {std::move(name), {{{0, 0}, {width, 0}, {width, height}, {0, height}}}, count};
}

std::optional<PackLayout> pack(const PackProblem& problem, const PackOptions& options) {
  const packing::Problem inner = on_grid(problem);
  packing::SearchOptions search;
  search.seed = options.seed;
  search.threads = std::max(1u, options.threads);
  search.seconds = options.seconds;
  search.work = options.work * 1000000;
  std::atomic<bool> stop = false;
  packing::SearchEvents events;
  events.better = [&](const packing::Layout& layout, const packing::SearchState&) {
    if (options.better) options.better(public_layout(inner, layout));
    stop = stop || options.cancel.requested();
  };
  events.progress = [&](const packing::SearchState&) { stop = stop || options.cancel.requested(); };
  const auto best = (inner.box ? packing::search_box : packing::search_strip)(inner, search, events, stop);
  return best ? std::optional(public_layout(inner, *best)) : std::nullopt;
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
  const packing::Problem inner = io::read_nesting(std::string(json), "problem");
  const packing::int128 steps = inner.steps();
  PackProblem result;
  result.name = inner.name;
  result.height = inner.height.text();
  result.box = inner.box;
  for (const packing::Part& part : inner.parts) {
    PackPart& out = result.parts.emplace_back();
    out = {part.name, public_rings(part.shape, steps), part.demand, {}, part.mirrored, public_amount(part.value)};
    for (const Fraction& angle : part.angles) out.angles.push_back(angle.text());
  }
  for (const packing::Sheet& sheet : inner.sheets) {
    PackSheet& out = result.sheets.emplace_back();
    out = {sheet.name, public_rings(sheet.shape, steps), sheet.count, public_amount(sheet.cost)};
    for (const packing::Zone& zone : sheet.zones) {
      PackZone& shown = out.zones.emplace_back();
      shown.rings = public_rings(zone.shape, steps);
      for (const std::size_t part : zone.parts)
        (zone.holds ? shown.holds : shown.keeps_out).push_back(inner.parts[part].name);
    }
  }
  for (const packing::PairGap& pair : inner.pair_gaps)
    result.gaps.push_back({inner.parts[pair.first].name, inner.parts[pair.second].name, pair.gap.text()});
  for (const packing::PairCondition& c : inner.conditions)
    result.conditions.push_back({inner.parts[c.first].name, inner.parts[c.second].name, c.where});
  for (const packing::FixedPart& f : inner.fixed)
    result.fixed.push_back({inner.parts[f.placed.part].name, f.placed.x.text(), f.placed.y.text(),
                            f.placed.angle.text(), f.placed.mirrored,
                            inner.on_sheets() ? inner.sheets[f.kind].name : "", int(f.placed.sheet) + 1});
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
