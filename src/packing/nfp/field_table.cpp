// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/nfp/field_table.h"

#include <findspace/error.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "packing/problem/pair_formula.h"

namespace findspace::packing {
namespace {

Variant variant_of(std::size_t part, const Fraction& angle, bool mirrored, SearchShape shape) {
  Variant result{part, angle, {}, {}, std::move(shape), mirrored};
  const auto& ring = result.shape.rings[0];
  const auto [left, right] = std::minmax_element(ring.begin(), ring.end());
  const auto lower = [](const auto& p, const auto& q) { return p.second < q.second; };
  const auto [bottom, top] = std::minmax_element(ring.begin(), ring.end(), lower);
  const double step = result.shape.step;
  result.low = {double(left->first) * step, double(bottom->second) * step};
  result.high = {double(right->first) * step, double(top->second) * step};
  return result;
}

/// Of a round part, whose polygon is only about it.
void take_box(Variant& variant, const Part& part) {
  if (!variant.shape.round) return;
  const LatticeBox box = box_of(part, variant.angle, variant.mirrored);
  variant.low = {double(box.low.x) * variant.shape.step, double(box.low.y) * variant.shape.step};
  variant.high = {double(box.high.x) * variant.shape.step, double(box.high.y) * variant.shape.step};
}

/// Whether a box of the grid fits the strip's height, or the box of a sheet, between the edges. Exact, so that what has
/// no clearance fits.
bool fits_somewhere(const Problem& problem, const LatticeBox& box) {
  const int128 steps = problem.steps();
  const Fraction edges = problem.edge + problem.edge, width = Fraction(box.high.x - box.low.x, steps) + edges,
                 height = Fraction(box.high.y - box.low.y, steps) + edges;
  if (!problem.on_sheets()) return height <= problem.height;
  const auto fits = [&](const Sheet& sheet) {
    const LatticeBox room = box_of(sheet);
    return sheet.count > 0 && width <= Fraction(room.high.x, steps) && height <= Fraction(room.high.y, steps);
  };
  return std::any_of(problem.sheets.begin(), problem.sheets.end(), fits);
}

/// No allowed angle makes the part low enough for the strip.
[[noreturn]] void fail_high(const Problem& problem, const Part& part) {
  std::optional<Fraction> least;
  for (const bool mirrored : {false, true})
    for (const Fraction& angle : part.angles) {
      if (mirrored && !part.mirrored) continue;
      const LatticeBox box = box_of(part, angle, mirrored);
      const Fraction height(box.high.y - box.low.y, problem.steps());
      least = least ? std::min(*least, height) : height;
    }
  throw Error(ErrorCode::kBadValue,
              fmt::format("part '{}' is higher than the strip: {} at its lowest allowed angle, and the strip has "
                          "{} between its edges",
                          part.name, least->text(), (problem.height - problem.edge - problem.edge).text()));
}

/// The rings as a set, from the lowest corner on: the same for parts that are translates of one another.
auto normal_form(const SearchShape& shape) {
  auto rings = shape.rings;
  const auto corner = *std::min_element(rings[0].begin(), rings[0].end());
  for (auto& ring : rings) {
    std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
    for (auto& [x, y] : ring) {
      x -= corner.first;
      y -= corner.second;
    }
  }
  std::sort(rings.begin(), rings.end());
  return rings;
}

}  // namespace

FieldTable::FieldTable(const Problem& problem) : problem_(problem), edge_(problem.edge.to_double()) {
  double height = problem.height.to_double();
  for (const Sheet& sheet : problem.sheets)
    height = std::max(height, double(box_of(sheet).high.y) / double(problem.steps()));
  height_ = (problem.on_sheets() ? height : problem.height.to_double()) - 2 * edge_;
  of_part_.resize(problem.parts.size());
  for (std::size_t part = 0; part < problem.parts.size(); ++part)
    if (problem.free_copies(part) > 0) add_variants(problem, part);
  add_obstacles(problem);
  add_fixed(problem);
  if (!problem.conditions.empty()) find_ties(problem);
  link_pairs(problem);
}

/// An angle at which the part looks as at one before adds nothing.
void FieldTable::add_variants(const Problem& problem, std::size_t number) {
  const Part& part = problem.parts[number];
  for (const bool mirrored : {false, true})
    for (const Fraction& angle : part.angles) {
      if (mirrored && !part.mirrored) continue;
      if (!fits_somewhere(problem, box_of(part, angle, mirrored))) continue;
      Variant variant = variant_of(number, angle, mirrored, search_shape(problem, part, angle, mirrored));
      take_box(variant, part);
      const auto form = normal_form(variant.shape);
      const auto same = [&](std::size_t v) { return normal_form(variants_[v].shape) == form; };
      if (std::any_of(of_part_[number].begin(), of_part_[number].end(), same)) continue;
      of_part_[number].push_back(variants_.size());
      variants_.push_back(std::move(variant));
    }
  if (of_part_[number].empty() && !problem.on_sheets()) fail_high(problem, part);
}

void FieldTable::add_obstacles(const Problem& problem) {
  for (const Sheet& sheet : problem.sheets) {
    std::vector<std::size_t>& added = of_sheet_.emplace_back();
    const auto add = [&](const Part& obstacle, const Zone* zone) {
      added.push_back(variants_.size());
      variants_.push_back(variant_of(kNoPart, 0, false, search_shape(problem, obstacle, 0, false)));
      take_box(variants_.back(), obstacle);
      variants_.back().zone = zone;
    };
    for (const Part& obstacle : packing::obstacles_of(problem, sheet)) add(obstacle, nullptr);
    for (const Zone& zone : sheet.zones)
      for (const Part& wall : walls_of(problem, sheet, zone)) add(wall, &zone);
  }
}

/// A fixed part may stand at an angle at which no other copy may.
void FieldTable::add_fixed(const Problem& problem) {
  for (const FixedPart& f : problem.fixed) {
    const Placed& p = f.placed;
    fixed_.push_back(variants_.size());
    const Part& part = problem.parts[p.part];
    variants_.push_back(variant_of(p.part, p.angle, p.mirrored, search_shape(problem, part, p.angle, p.mirrored)));
    take_box(variants_.back(), part);
  }
}

/// Positions are within the row: all parts one after another, or all sheets, and what is between them.
void FieldTable::find_ties(const Problem& problem) {
  const std::size_t n = variants_.size();
  greatest_level_ = packing::greatest_level(problem.conditions);
  ties_.resize(n * n);
  const Ties ties(problem.conditions, problem.parts.size());
  reach_ = height_ + edge_;
  for (std::size_t a = 0; a < n; ++a) {
    if (variants_[a].part == kNoPart) continue;
    const Vec size = variants_[a].high - variants_[a].low;
    reach_ += (size.x + size.y + gap_) * problem.parts[variants_[a].part].demand;
    for (std::size_t b = 0; b < n; ++b)
      ties_[a * n + b] = variants_[b].part != kNoPart && ties.between(variants_[a].part, variants_[b].part);
  }
  for (const Sheet& sheet : problem.sheets) {
    const double width = double(box_of(sheet).high.x) / double(problem.steps());
    const std::size_t most = std::min(std::size_t(sheet.count), problem.items());
    reach_ += double(most) * (width + 2 * (edge_ + 2) + greatest_level_);
  }
  reach_ *= 4;
}

std::optional<Tie> FieldTable::tie_of(const Link& link) const {
  if (!are_tied(link.first_, link.second_)) return std::nullopt;
  const Variant &a = variants_[link.first_], &b = variants_[link.second_];
  const exact::Real step = exact::Real(1) / exact::Real(std::int64_t(std::llround(1 / a.shape.step)));
  return Tie{PairFormula(problem_, a.part, region_of(a.shape), b.part, region_of(b.shape), step).regions(), reach_};
}

/// Nothing where the two may overlap.
std::optional<double> FieldTable::gap_of(const Problem& problem, const Variant& a, const Variant& b) const {
  if (a.part == kNoPart && b.part == kNoPart) return std::nullopt;
  if (a.part != kNoPart && b.part != kNoPart) return problem.gap_of(a.part, b.part).to_double();
  const Variant &obstacle = a.part == kNoPart ? a : b, &part = a.part == kNoPart ? b : a;
  if (obstacle.zone == nullptr) return edge_;
  const auto& kept_out = obstacle.zone->parts;
  return std::count(kept_out.begin(), kept_out.end(), part.part) > 0 ? std::optional(0.0) : std::nullopt;
}

std::optional<Vec> FieldTable::offset_to(std::size_t variant, const SearchShape& shape) const {
  const SearchShape& own = variants_[variant].shape;
  if (normal_form(own) != normal_form(shape)) return std::nullopt;
  const auto mine = *std::min_element(own.rings[0].begin(), own.rings[0].end());
  const auto theirs = *std::min_element(shape.rings[0].begin(), shape.rings[0].end());
  return Vec{double(theirs.first - mine.first) * own.step, double(theirs.second - mine.second) * own.step};
}

Pose FieldTable::pose_of(std::size_t part, const Fraction& angle, bool mirrored, Vec at) const {
  const SearchShape mine = search_shape(problem_, problem_.parts[part], angle, mirrored);
  for (const std::size_t v : variants_of(part))
    if (const auto off = offset_to(v, mine)) return {v, at + *off};
  return {variants_of(part)[0], at};
}

/// Of what free copies may look like: there each is the opposite of its opposite. A fixed copy has none.
std::optional<FieldTable::Opposite> FieldTable::opposite_of(std::size_t variant) const {
  if (variants_[variant].part == kNoPart) return std::nullopt;
  const std::vector<std::size_t>& looks = of_part_[variants_[variant].part];
  if (std::find(looks.begin(), looks.end(), variant) == looks.end()) return std::nullopt;
  SearchShape opposite = variants_[variant].shape;
  for (auto& ring : opposite.rings)
    for (auto& [x, y] : ring) {
      x = -x;
      y = -y;
    }
  if (opposite.round) return std::nullopt;
  for (const std::size_t other : looks)
    if (const auto off = offset_to(other, opposite)) return Opposite{other, *off};
  return std::nullopt;
}

void FieldTable::link_pairs(const Problem& problem) {
  const std::size_t n = variants_.size();
  std::vector<std::optional<Opposite>> opposites;
  for (std::size_t v = 0; v < n; ++v) opposites.push_back(opposite_of(v));
  links_ = std::vector<Link>(n * n);
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = 0; b < n; ++b) {
      link_pair(opposites, a, b);
      Link& link = links_[a * n + b];
      const std::optional<double> gap = gap_of(problem, variants_[a], variants_[b]);
      if (!gap) join(link, nothing_);
      link.gap_ = gap.value_or(0);
      gap_ = std::max(gap_, link.gap_);
    }
}

void FieldTable::link_pair(const std::vector<std::optional<Opposite>>& opposites, std::size_t a, std::size_t b) {
  Link& link = links_[a * variants_.size() + b];
  link.sign_ = a <= b ? 1 : -1;
  link.first_ = std::uint32_t(std::min(a, b));
  link.second_ = std::uint32_t(std::max(a, b));
  if (!opposites[a] || !opposites[b] || are_tied(a, b)) return;
  const auto [first, second] = std::minmax(opposites[a]->variant, opposites[b]->variant);
  if (std::pair<std::size_t, std::size_t>(first, second) >=
      std::pair<std::size_t, std::size_t>(link.first_, link.second_))
    return;
  link.sign_ = opposites[a]->variant <= opposites[b]->variant ? -1 : 1;
  link.shift_ = -link.sign_ * (opposites[b]->off - opposites[a]->off);
  link.first_ = std::uint32_t(first);
  link.second_ = std::uint32_t(second);
}

/// Other threads see the field when the rest of the link is there.
void FieldTable::join(const Link& link, const DepthField& field) {
  link.glance_ = field.glance(link.sign_, link.shift_);
  link.field_.store(&field, std::memory_order_release);
}

void FieldTable::make(const Link& link) const {
  const Link& whole = links_[link.first_ * variants_.size() + link.second_];
  if (whole.field_.load(std::memory_order_acquire) == nullptr) {
    const std::optional<Tie> tie = tie_of(link);
    auto made = std::make_unique<const DepthField>(
        no_fit_polygon(variants_[link.first_].shape, variants_[link.second_].shape, link.gap_, tie ? &*tie : nullptr));
    const std::lock_guard lock(guard_);
    if (whole.field_.load(std::memory_order_acquire) == nullptr) {
      join(whole, *made);
      made_.push_back(std::move(made));
    }
  }
  const std::lock_guard lock(guard_);
  if (link.field_.load(std::memory_order_acquire) == nullptr) join(link, whole.field());
}

}  // namespace findspace::packing
