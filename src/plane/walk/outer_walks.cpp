// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "plane/walk/outer_walks.h"

#include <algorithm>
#include <array>
#include <atomic>

#include "plane/base/parallel.h"

namespace findspace::plane {
namespace {

constexpr std::size_t kManyToWalk = 12'000;  // parts: from here on ranges of curves are looked at at once
constexpr std::size_t kShortWay = 32;        // parts; at half the crossings a way ends

}  // namespace

// A part is inner or not whoever finds out first, so it does not matter what other threads have noted so far.
void OuterWalks::close_short_ways() {
  const std::size_t ranges = range_count(curves_.part_count(), kManyToWalk);
  if (ranges == 1) return;
  parallel_for(ranges, [&](std::size_t k) {
    const IndexRange curves = range(k, ranges, curves_.size());
    for (auto i = Index(curves.first); i < curves.end; ++i)
      for (Index slot = 0; slot <= curves_.stop_count(i); ++slot) close_short_way({i, slot});
  });
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
  if (tried_ == 0) close_short_ways();
  const auto first = walk_of_.begin(), end = walk_of_.end();
  for (auto at = first + tried_; (at = std::find(at, end, kNone)) != end;) {
    const auto part = Index(at++ - first);
    while (curves_.part({curve_ + 1, 0}) <= part) ++curve_;
    const auto found = walk({curve_, part - curves_.part({curve_, 0})});
    tried_ = part + 1;
    if (!found.empty()) return found;
  }
  tried_ = Index(walk_of_.size());
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
