// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Triangles of one plane merged into facets; vertices with fewer than three facets are dropped.
#include <algorithm>
#include <cassert>

#include "space/polytope/hull_triangles.h"

namespace findspace::space {

/// The triangles of the hull as they were made.
std::vector<int> Hull::in_order() const {
  std::vector<std::pair<int, int>> alive;  // by number
  for (int t = 0; t < static_cast<int>(triangles_.size()); ++t) {
    if (triangles_[t].alive) alive.emplace_back(triangles_[t].number, t);
  }
  std::sort(alive.begin(), alive.end());
  std::vector<int> out;
  out.reserve(alive.size());
  for (const auto& [number, t] : alive) out.push_back(t);
  return out;
}

/// For every triangle the first one of its plane, joined over edges.
std::vector<int> Hull::groups(const std::vector<int>& triangles) const {
  std::vector<int> group(triangles_.size(), -1), stack;
  for (const int t : triangles) {
    if (group[t] >= 0) continue;
    group[t] = t;
    stack.assign(1, t);
    while (!stack.empty()) {
      const Triangle& from = triangles_[stack.back()];
      stack.pop_back();
      for (const int n : from.next) {
        const Triangle& to = triangles_[n];
        if (group[n] >= 0) continue;
        if (std::any_of(to.v.begin(), to.v.end(), [&](int v) { return side(triangles_[t], v) != 0; })) continue;
        group[n] = t;
        stack.push_back(n);
      }
    }
  }
  return group;
}

std::vector<std::vector<int>> Hull::merged() const {
  const std::vector<int> triangles = in_order(), group = groups(triangles);
  // Border edges of each group, chained: after (t, i) comes the first border edge when turning about its end inside the
  // group.
  std::vector<std::vector<int>> rings;
  std::vector<int> facets_at(points_.size(), 0);
  for (const int t : triangles) {
    for (int i = 0; i < 3; ++i) facets_at[triangles_[t].v[i]] += group[triangles_[t].next[i]] != group[t];
  }
  std::vector<char> done(triangles_.size(), 0);
  for (const int t : triangles) {
    if (done[group[t]]) continue;
    int edge = 0;
    while (edge < 3 && group[triangles_[t].next[edge]] == group[t]) ++edge;
    if (edge == 3) continue;
    done[group[t]] = 1;
    std::vector<int> ring;
    int at = t;
    const int begin = triangles_[t].v[edge];
    do {
      if (facets_at[triangles_[at].v[edge]] >= 3) ring.push_back(triangles_[at].v[edge]);
      const int end = triangles_[at].v[(edge + 1) % 3];
      edge = (edge + 1) % 3;
      while (group[triangles_[at].next[edge]] == group[at]) {
        at = triangles_[at].next[edge];
        edge = static_cast<int>(std::find(triangles_[at].v.begin(), triangles_[at].v.end(), end) -
                                triangles_[at].v.begin());
      }
    } while (triangles_[at].v[edge] != begin);
    assert(ring.size() >= 3);
    rings.push_back(std::move(ring));
  }
  return rings;
}

}  // namespace findspace::space
