// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/sum/convolution_nodes.h"

#include <algorithm>

namespace findspace::plane {

ConvolutionNodes::ConvolutionNodes(const Tracing& a, const Tracing& b, Index keys) : side_{&a, &b}, keys_(keys) {
  Index count = count_lines(0) + count_lines(1);
  nodes.reserve(count);
  for (int s : {0, 1}) add_lines(s);
  add_arcs();
}

Index ConvolutionNodes::count_lines(int s) {
  const Tracing &p = *side_[s], &other = *side_[1 - s];
  Index n = Index(p.sorted.size()), total = 0;
  auto below = [&](Index key) {
    auto at = std::lower_bound(p.sorted.begin(), p.sorted.end(), key,
                               [&](Index line, Index k) { return p.lines[line].key < k; });
    return Index(at - p.sorted.begin());
  };
  ranges_[s].reserve(other.size());
  for (const Turn& turn : other.turns) {
    Index first = below(turn.low), end = turn.low + turn.length;
    Index count = turn.length == 0 ? 0 : end < keys_ ? below(end) - first : n - first + below(end - keys_);
    ranges_[s].push_back({first, count, 0});
    total += count;
  }
  return total;
}

void ConvolutionNodes::add_lines(int s) {
  const Tracing &p = *side_[s], &other = *side_[1 - s];
  Index n = Index(p.sorted.size());
  for (Index t = 0; t < other.size(); ++t) {
    Range& range = ranges_[s][t];
    range.base = Index(nodes.size());
    for (Index k = 0; k < range.count; ++k) {
      Node& node = nodes.emplace_back(Node{.kind = Kind::kLine, .side = std::uint8_t(s)});
      node.at[s] = p.sorted[range.first + k < n ? range.first + k : range.first + k - n];
      node.at[1 - s] = t;
      node.forward = other.turns[t].sign > 0;
      node.key_in = node.key_out = p.lines[node.at[s]].key;
    }
  }
}

Index ConvolutionNodes::line_node(int s, Index line, Index turn) const {
  const Range& range = ranges_[s][turn];
  Index place = side_[s]->lines[line].place, n = Index(side_[s]->sorted.size());
  return range.base + (place >= range.first ? place - range.first : place + n - range.first);
}

void ConvolutionNodes::add_arcs() {
  const Tracing &a = *side_[0], &b = *side_[1];
  std::vector<Index> b_arcs;
  for (Index j = 0; j < b.size(); ++j)
    if (b.turns[j].arc) b_arcs.push_back(j);
  for (Index i = 0; i < a.size(); ++i) {
    if (!a.turns[i].arc)
      for (Index j : b_arcs) add_arc(i, j);
    else
      for (Index j = 0; j < b.size(); ++j) add_arc(i, j);
  }
}

void ConvolutionNodes::add_arc(Index i, Index j) {
  const Turn &p = side_[0]->turns[i], &q = side_[1]->turns[j];
  if (p.length == 0 || q.length == 0) return;
  Index low;
  if (minus(q.low, p.low) < p.length)
    low = q.low;
  else if (minus(p.low, q.low) < q.length)
    low = p.low;
  else
    return;
  int sum = !p.arc ? q.sign : !q.arc ? p.sign : (p.radius() + q.radius()).sign();
  Index high_end = minus(high(p), low) <= minus(high(q), low) ? high(p) : high(q);
  if (low / 2 == high_end / 2) return;  // one direction only: a single place
  if (sum == 0) {                       // equal radii: a single place in many directions
    still.push_back({i, j});
    return;
  }
  Node node{.kind = Kind::kArc, .side = 0};
  node.at[0] = i;
  node.at[1] = j;
  node.forward = p.sign == q.sign ? p.sign > 0 : sum < 0;
  // The place moves with the tangent while directions grow and the radius is positive.
  node.turns_left = node.forward == (sum > 0);
  node.key_in = node.turns_left ? low : high_end;
  node.key_out = node.turns_left ? high_end : low;
  arc_node_[pair_key(i, j)] = Index(nodes.size());
  nodes.push_back(node);
}

Index ConvolutionNodes::arc_node(Index i, Index j) const {
  if (arc_node_.empty()) return kNone;
  const auto found = arc_node_.find(pair_key(i, j));
  return found == arc_node_.end() ? kNone : found->second;
}

const Direction& ConvolutionNodes::direction_at(const Node& n, Index key) const {
  for (int s : {0, 1}) {
    const Tracing& p = *side_[s];
    const Line &before = p.lines[n.at[s]], &after = p.lines[p.line_after(n.at[s])];
    if (before.key == key) return *before.direction;
    if (after.key == key) return *after.direction;
  }
  return *side_[0]->lines[0].direction;  // not reached: an arc ends where one of its turns ends
}

}  // namespace findspace::plane
