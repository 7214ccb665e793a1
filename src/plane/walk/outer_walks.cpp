// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "plane/walk/outer_walks.h"

#include <algorithm>
#include <array>
#include <atomic>

#include "plane/base/parallel.h"

namespace findspace::plane {
namespace {

constexpr std::size_t kManyToWalk = 2000;  // curves: from here on ranges of them are looked at at once
constexpr std::size_t kShortWay = 32;      // parts; at half the crossings a way ends

}  // namespace

std::optional<std::vector<Index>> OuterWalks::candidates() {
  const std::size_t ranges = range_count(curves_.size(), kManyToWalk);
  if (ranges == 1) return std::nullopt;
  std::vector<std::vector<Index>> found(ranges);
  parallel_for(ranges, [&](std::size_t k) {
    const IndexRange curves = range(k, ranges, curves_.size());
    for (auto i = Index(curves.first); i < curves.end; ++i)
      if (is_candidate(i)) found[k].push_back(i);
  });
  std::vector<Index> all;
  for (const auto& some : found) all.insert(all.end(), some.begin(), some.end());
  return all;
}

// A part is inner or not whoever finds out first, so it does not matter what other threads have noted so far.
bool OuterWalks::is_candidate(Index curve) {
  bool left = false;
  for (Index k = 0; k <= curves_.stop_count(curve); ++k) {
    std::atomic_ref<Index> walk(walk_of_[curves_.part({curve, k})]);
    if (walk.load(std::memory_order_relaxed) == kNone) close_short_way({curve, k});
    left |= walk.load(std::memory_order_relaxed) == kNone;
  }
  return left;
}

void OuterWalks::close_short_way(CurvePart from) {
  std::array<Index, kShortWay> way;
  std::size_t length = 0;
  for (CurvePart at = from;;) {
    const Index part = curves_.part(at);
    if (std::atomic_ref<Index>(walk_of_[part]).load(std::memory_order_relaxed) != kNone) break;
    if (length == kShortWay) return;
    way[length++] = part;
    at = before(at);
    if (at.curve == kNone) break;
  }
  for (std::size_t k = 0; k < length; ++k)
    std::atomic_ref<Index>(walk_of_[way[k]]).store(kShort, std::memory_order_relaxed);
}

std::span<const CurvePart> OuterWalks::next() {
  if (tried_ == 0 && tried_slots_ == 0) candidates_ = candidates();
  const Index count = candidates_ ? Index(candidates_->size()) : curves_.size();
  for (; tried_ < count; ++tried_, tried_slots_ = 0) {
    const Index i = candidates_ ? (*candidates_)[tried_] : tried_;
    const Index first = curves_.part({i, 0}), parts = curves_.stop_count(i) + 1;
    while (tried_slots_ < parts) {
      const Index k = tried_slots_++;
      if (walk_of_[first + k] != kNone) continue;
      if (const auto found = walk({i, k}); !found.empty()) return found;
    }
  }
  return {};
}

std::span<const CurvePart> OuterWalks::walk(CurvePart from) {
  const Index walk = walks_++;
  Index* const walk_of = walk_of_.data();
  parts_.clear();
  // Two numbers: as one that is taken apart again and again, each step would wait for it.
  Index curve = from.curve, slot = from.slot;
  for (;;) {
    Index& passed = walk_of[curves_.part({curve, slot})];
    if (passed == walk) break;
    if (passed != kNone) return {};
    passed = walk;
    parts_.push_back({curve, slot});
    const CurvePart next = before({curve, slot});
    if (next.curve == kNone) return {};
    curve = next.curve;
    slot = next.slot;
  }
  // A walk may start on a curve that runs along another one: then it comes back to a later part.
  auto start = std::find_if(parts_.begin(), parts_.end(),
                            [&](const CurvePart& p) { return p.curve == curve && p.slot == slot; });
  return std::span(start, parts_.end());
}

CurvePart OuterWalks::before(CurvePart at) const {
  constexpr CurvePart kNowhere{kNone, 0};
  if (Index degenerate = curves_.degenerate_before(at); degenerate != kNone) {
    const DirectedEdge& directed_edge = curves_.degenerate_vertices().clockwise(degenerate, at.curve, at.slot);
    return directed_edge.starts ? kNowhere : CurvePart{directed_edge.curve, directed_edge.slot};
  }
  if (at.slot == 0) {
    const Index before = curves_.before(at.curve);
    return before == kNone ? kNowhere : CurvePart{before, curves_.stop_count(before)};
  }
  const Stop& stop = curves_.stop(at.curve, at.slot - 1);
  return stop.from_right ? CurvePart{stop.other, stop.twin} : kNowhere;
}

}  // namespace findspace::plane
