// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/body/complement_search.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "exact/margins/rounding.h"

namespace findspace::space {

namespace {

/// Where an interval that may be infinite is divided; `near` lies about as far from what is of interest as `reach`.
double division(double low, double high, double near, double reach) {
  if (std::isfinite(low) && std::isfinite(high)) return low + (high - low) / 2;
  if (std::isfinite(low)) return low >= near + reach ? low + (low - near) : near + reach;
  if (std::isfinite(high)) return high <= near - reach ? high - (near - high) : near - reach;
  return near - reach;
}

/// How far the box is from the sides of the one around it, at least; below 0 where it is not in it.
double slack_in(const Extent& around, const Extent& box) {
  return std::min({box.low.x - around.low.x, box.low.y - around.low.y, box.low.z - around.low.z,
                   around.high.x - box.high.x, around.high.y - box.high.y, around.high.z - box.high.z});
}

}  // namespace

ComplementSearch::ComplementSearch(const OpenUnion& cover, const RealVector& p, std::span<const Extent> within)
    : cover_(cover), p_(p), near_(space::rounded(p)), within_(within) {
  reach_ = std::max(1.0, margin::kWiderBox * size_of(near_));
  for (std::size_t k = 0; k < cover.size(); ++k) {
    const Extent& e = cover.extent(k);
    if (e.bounded()) reach_ = std::max(reach_, e.farthest(near_));
  }
}

ComplementSearch::Meeting ComplementSearch::meeting(std::size_t set, const Extent& box) {
  if (!box.meets(cover_.extent(set))) return Meeting::kApart;
  if (!box.bounded()) return Meeting::kMeets;
  ++met_;
  const Vector middle = box.middle(), half = scaled(0.5, box.high - box.low);
  const double size = size_of(middle) + size_of(half);
  bool covers = true;
  for (const OpenUnion::RoundedPlane& h : cover_.rounded_planes(set)) {
    const double at = dot(h.unit, middle) + h.shift, error = h.share * (size + 2 * std::fabs(h.shift)) + h.off;
    const double spread = std::fabs(h.unit.x) * half.x + std::fabs(h.unit.y) * half.y + std::fabs(h.unit.z) * half.z;
    if (at - spread > error) return Meeting::kApart;
    covers = covers && at + spread < -error;
  }
  return covers ? Meeting::kCovers : Meeting::kMeets;
}

bool ComplementSearch::likely_covered(const Cell& cell) {
  if (!cell.box.bounded()) return false;
  std::vector<std::pair<double, std::size_t>> likely;
  for (const std::size_t k : cell.sets) {
    if (const double slack = slack_in(cover_.extent(k), cell.box); slack > 0) likely.emplace_back(-slack, k);
  }
  const auto last = likely.begin() + std::min(kLikely, static_cast<long>(likely.size()));
  std::partial_sort(likely.begin(), last, likely.end());
  return std::any_of(likely.begin(), last,
                     [&](const auto& set) { return meeting(set.second, cell.box) == Meeting::kCovers; });
}

bool ComplementSearch::sift(Cell& cell) {
  std::vector<std::size_t> left;
  for (const std::size_t k : cell.sets) {
    const Meeting how = meeting(k, cell.box);
    if (how == Meeting::kCovers) return true;
    if (how == Meeting::kMeets) left.push_back(k);
  }
  cell.sets.swap(left);
  return false;
}

void ComplementSearch::add(const Cell& cell, const Extent& box) {
  Cell part{box, {}, box.distance(near_)};
  if (part.distance > bound_) return;
  for (const std::size_t k : cell.sets) {
    if (box.meets(cover_.extent(k))) part.sets.push_back(k);
  }
  part.fruitless = cell.fruitless + (part.sets.size() == cell.sets.size() && box.bounded() ? 1 : 0);
  queue_.push(std::move(part));
}

void ComplementSearch::divide(const Cell& cell) {
  if (cell.whole && !within_.empty()) {
    for (const Extent& box : within_) add(cell, box);
    return;
  }
  const Vector& low = cell.box.low;
  const Vector& high = cell.box.high;
  const Vector size = high - low;
  Extent first = cell.box, second = cell.box;
  if (size.x >= size.y && size.x >= size.z)
    first.high.x = second.low.x = division(low.x, high.x, near_.x, reach_);
  else if (size.y >= size.z)
    first.high.y = second.low.y = division(low.y, high.y, near_.y, reach_);
  else
    first.high.z = second.low.z = division(low.z, high.z, near_.z, reach_);
  for (const Extent& box : {first, second}) add(cell, box);
}

bool ComplementSearch::crowded() const {
  long holding = 0;
  for (std::size_t k = 0; k < cover_.size() && holding <= kCrowd; ++k) holding += cover_.extent(k).holds(near_, 0);
  return holding > kCrowd;
}

void ComplementSearch::count(const Cell& cell) {
  const long sets = cell.whole ? 0 : static_cast<long>(cell.sets.size());
  steps_ += 1 + (sets + 4 * std::exchange(met_, 0)) / kSetsOfStep;
  plane::count_cells(steps_ / kStepsOfCell);
  steps_ %= kStepsOfCell;
}

void ComplementSearch::look(Cell cell) {
  count(cell);
  if (cell.whole) {
    if (covered_ || crowded()) return divide(cell);
  } else {
    if (covered_ && cell.box.bounded() && covered_(cell.box)) return;
    if (likely_covered(cell)) return;
    const std::size_t before = cell.sets.size();
    if (before <= static_cast<std::size_t>(kSifted << std::min(cell.fruitless / 3, 40)) && sift(cell)) return;
    if (static_cast<long>(cell.sets.size()) > most_sets(cell)) return divide(cell);
  }
  std::optional<ProjectionSearch::Within> within;
  if (!cell.whole) within = {cell.box, cell.sets};
  ProjectionSearch search(cover_, p_, std::move(within));
  const plane::SubdivisionEnd end =
      search.run(std::min(most_looks(cell), ProjectionSearch::kLooksOfCell * question_.work().left), bound_);
  if (end == plane::SubdivisionEnd::kSpent && !search.found()) return divide(cell);
  if (!search.found()) return;
  bound_ = search.distance();
  found_ = search.found();
}

NearestOutside ComplementSearch::run() {
  std::vector<std::size_t> all(cover_.size());
  std::iota(all.begin(), all.end(), 0);
  queue_.push({everywhere(), std::move(all), 0, true});
  bool spent = false;
  queue_.run([&](const Cell& best) { return best.distance > bound_ || (spent = question_.work().spent()); },
             [&](Cell cell) { look(std::move(cell)); });
  if (!spent) return {found_};
  const double rounding = margin::kRoundings32 * (queue_.best().distance + size_of(near_));
  return {found_, true, std::max(0.0, queue_.best().distance - rounding)};
}

}  // namespace findspace::space
