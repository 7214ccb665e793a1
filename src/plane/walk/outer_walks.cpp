// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "plane/walk/outer_walks.h"

#include <algorithm>

namespace findspace::plane {

std::span<const CurvePart> OuterWalks::walk(CurvePart from) {
  parts_.clear();
  CurvePart at = from;
  for (;;) {
    char& state = state_[curves_.part(at)];
    if (state == kDone || state == kInner) return leave(kInner);
    if (state == kOpen) break;
    state = kOpen;
    parts_.push_back(at);
    if (!advance(at)) return leave(kInner);
  }
  // A walk may start on a curve that runs along another one: then it comes back to a later part.
  auto start = std::find_if(parts_.begin(), parts_.end(),
                            [&](const CurvePart& p) { return p.curve == at.curve && p.slot == at.slot; });
  leave(kDone);
  return std::span(start, parts_.end());
}

bool OuterWalks::advance(CurvePart& at) const {
  if (Index degenerate = curves_.degenerate_before(at); degenerate != kNone) {
    const DirectedEdge& directed_edge = curves_.degenerate_vertices().clockwise(degenerate, at.curve, at.slot);
    if (directed_edge.starts) return false;
    at = {directed_edge.curve, directed_edge.slot};
    return true;
  }
  if (at.slot == 0) {
    Index before = curves_.before(at.curve);
    if (before == kNone) return false;
    at = {before, curves_.stop_count(before)};
    return true;
  }
  const Stop& stop = curves_.stop(at.curve, at.slot - 1);
  if (!stop.from_right) return false;
  at = {stop.other, stop.twin};
  return true;
}

}  // namespace findspace::plane
