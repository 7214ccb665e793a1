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
  link_pairs();
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

std::optional<FieldTable::Opposite> FieldTable::opposite_of(std::size_t variant) const {
  SearchShape opposite = variants_[variant].shape;
  for (auto& ring : opposite.rings)
    for (auto& [x, y] : ring) {
      x = -x;
      y = -y;
    }
  for (const std::size_t other : of_part_[variants_[variant].part])
    if (const auto off = offset_to(other, opposite)) return Opposite{other, *off};
  return std::nullopt;
}

void FieldTable::link_pairs() {
  const std::size_t n = variants_.size();
  std::vector<std::optional<Opposite>> opposites;
  for (std::size_t v = 0; v < n; ++v) opposites.push_back(opposite_of(v));
  links_ = std::vector<Link>(n * n);
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = 0; b < n; ++b) {
      Link& link = links_[a * n + b];
      link.sign_ = a <= b ? 1 : -1;
      std::size_t first = std::min(a, b), second = std::max(a, b);
      if (opposites[a] && opposites[b]) {
        const auto [x, y] = std::minmax(opposites[a]->variant, opposites[b]->variant);
        if (std::pair(x, y) < std::pair(first, second)) {
          link.sign_ = opposites[a]->variant <= opposites[b]->variant ? -1 : 1;
          link.shift_ = -link.sign_ * (opposites[b]->off - opposites[a]->off);
          first = x;
          second = y;
        }
      }
      link.first_ = std::uint32_t(first);
      link.second_ = std::uint32_t(second);
    }
}

void FieldTable::make(const Link& link) const {
  const Link& whole = links_[link.first_ * variants_.size() + link.second_];
  if (whole.field_.load(std::memory_order_acquire) == nullptr) {
    auto made = std::make_unique<const DepthField>(
        no_fit_polygon(variants_[link.first_].shape, variants_[link.second_].shape, gap_));
    const std::lock_guard lock(guard_);
    if (whole.field_.load(std::memory_order_acquire) == nullptr) {
      whole.field_.store(made.get(), std::memory_order_release);
      made_.push_back(std::move(made));
    }
  }
  link.field_.store(&whole.field(), std::memory_order_release);
}

}  // namespace findspace::packing
