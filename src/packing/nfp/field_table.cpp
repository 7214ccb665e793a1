// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/nfp/field_table.h"

#include <findspace/error.h>
#include <fmt/format.h>

#include <algorithm>

namespace findspace::packing {
namespace {

Variant variant_of(const Problem& problem, std::size_t part, const Fraction& angle) {
  Variant result{part, angle, {}, {}, search_shape(turned(problem.parts[part].shape, angle, false), problem.digits)};
  const auto& ring = result.shape.rings[0];
  const auto [left, right] = std::minmax_element(ring.begin(), ring.end());
  const auto lower = [](const auto& p, const auto& q) { return p.second < q.second; };
  const auto [bottom, top] = std::minmax_element(ring.begin(), ring.end(), lower);
  const double step = result.shape.step;
  result.low = {double(left->first) * step, double(bottom->second) * step};
  result.high = {double(right->first) * step, double(top->second) * step};
  return result;
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

FieldTable::FieldTable(const Problem& problem)
    : gap_(problem.gap.to_double()),
      edge_(problem.edge.to_double()),
      height_((problem.height - problem.edge - problem.edge).to_double()) {
  of_part_.resize(problem.parts.size());
  for (std::size_t part = 0; part < problem.parts.size(); ++part)
    if (problem.parts[part].demand > 0) add_variants(problem, part);
  table_ = std::vector<std::atomic<const DepthField*>>(variants_.size() * variants_.size());
}

/// An angle at which the part looks as at one before adds nothing.
void FieldTable::add_variants(const Problem& problem, std::size_t part) {
  bool known = false;
  for (const Fraction& angle : problem.parts[part].angles) {
    Variant variant = variant_of(problem, part, angle);
    if (variant.high.y - variant.low.y > height_) continue;
    const auto form = normal_form(variant.shape);
    const auto same = [&](std::size_t v) { return normal_form(variants_[v].shape) == form; };
    known = true;
    if (std::any_of(of_part_[part].begin(), of_part_[part].end(), same)) continue;
    of_part_[part].push_back(variants_.size());
    variants_.push_back(std::move(variant));
  }
  if (!known)
    throw Error(ErrorCode::kBadValue, fmt::format("part '{}' is higher than the strip", problem.parts[part].name));
}

std::optional<Vec> FieldTable::offset_to(std::size_t variant, const SearchShape& shape) const {
  const SearchShape& own = variants_[variant].shape;
  if (normal_form(own) != normal_form(shape)) return std::nullopt;
  const auto mine = *std::min_element(own.rings[0].begin(), own.rings[0].end());
  const auto theirs = *std::min_element(shape.rings[0].begin(), shape.rings[0].end());
  return Vec{double(theirs.first - mine.first) * own.step, double(theirs.second - mine.second) * own.step};
}

const DepthField& FieldTable::make(std::size_t a, std::size_t b) const {
  auto made = std::make_unique<const DepthField>(no_fit_polygon(variants_[a].shape, variants_[b].shape, gap_));
  const std::lock_guard lock(guard_);
  auto& slot = table_[a * variants_.size() + b];
  if (const DepthField* known = slot.load(std::memory_order_acquire)) return *known;
  slot.store(made.get(), std::memory_order_release);
  made_.push_back(std::move(made));
  return *made_.back();
}

}  // namespace findspace::packing
