// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/sum/convolution_nodes.h"

#include <algorithm>
#include <cstdlib>

namespace findspace::plane {

ConvolutionNodes::ConvolutionNodes(const TurningPath& a, const TurningPath& b, Index keys)
    : side_{&a, &b}, keys_(keys) {
  Index count = count_lines(0) + count_lines(1);
  nodes.reserve(count);
  for (int s : {0, 1}) add_lines(s);
  add_arcs();
  for (Index k = 0; k < nodes.size(); ++k) connect(k);
  add_still_walks();
}

Index ConvolutionNodes::count_lines(int s) {
  const TurningPath &p = *side_[s], &other = *side_[1 - s];
  Index n = Index(p.sorted.size()), total = 0;
  auto below = [&](Index key) {
    auto at = std::lower_bound(p.sorted.begin(), p.sorted.end(), key,
                               [&](Index line, Index k) { return p.lines[line].key < k; });
    return Index(at - p.sorted.begin());
  };
  ranges_[s].reserve(other.size());
  for (const ExactAngle& turn : other.turns) {
    Index first = below(turn.low), end = turn.low + turn.length;
    Index count = turn.length == 0 ? 0 : end < keys_ ? below(end) - first : n - first + below(end - keys_);
    ranges_[s].push_back({first, count, 0});
    total += count;
  }
  return total;
}

void ConvolutionNodes::add_lines(int s) {
  const TurningPath &p = *side_[s], &other = *side_[1 - s];
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
  const TurningPath &a = *side_[0], &b = *side_[1];
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
  const ExactAngle &p = side_[0]->turns[i], &q = side_[1]->turns[j];
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
    still_.push_back({i, j});
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

void ConvolutionNodes::connect(Index k) {
  Node& from = nodes[k];
  if (from.kind == Kind::kArc) {
    Index turns[2] = {from.at[0], from.at[1]};
    return step_out(turns, from.key_out, from.turns_left, 0, k, true);
  }
  const TurningPath& p = *side_[from.side];
  Index turns[2];
  turns[1 - from.side] = from.at[1 - from.side];
  turns[from.side] = from.forward ? from.at[from.side] : p.turn_before(from.at[from.side]);
  bool left = (p.turns[turns[from.side]].sign > 0) == from.forward;
  if (!to_arc(turns, from.key_out, 0, k)) step_out(turns, from.key_out, left, 0, k, false);
}

bool ConvolutionNodes::to_arc(const Index turns[2], Index key, std::int64_t turned, Index k) {
  if (!still_.empty()) passed_.insert(pair_key(turns[0], turns[1]));
  if (arc_node_.empty()) return false;
  auto found = arc_node_.find(pair_key(turns[0], turns[1]));
  if (found == arc_node_.end() || k == kNone) return false;
  follow(k, found->second, key, turned);
  return true;
}

void ConvolutionNodes::step_out(Index turns[2], Index key, bool left, std::int64_t turned, Index k, bool moved) {
  for (;;) {
    Index to_end[2] = {0, 0};
    for (int s : {0, 1}) {
      const ExactAngle& t = side_[s]->turns[turns[s]];
      to_end[s] = moved ? 0 : left ? minus(high(t), key) : minus(key, t.low);
    }
    int s;
    if (moved) {  // already at an end: of which side?
      const ExactAngle& t = side_[0]->turns[turns[0]];
      s = key == (left ? high(t) : t.low) ? 0 : 1;
    } else {
      s = to_end[0] < to_end[1] ? 0 : 1;
      turned += left ? std::int64_t(to_end[s]) : -std::int64_t(to_end[s]);
      key = left ? plus(key, to_end[s]) : minus(key, to_end[s]);
    }
    const TurningPath& p = *side_[s];
    bool ahead = (p.turns[turns[s]].sign > 0) == left;  // leaves at the turn's end
    Index line = ahead ? p.line_after(turns[s]) : turns[s];
    if (!p.lines[line].empty) return follow(k, line_node(s, line, turns[1 - s]), key, turned);
    turns[s] = ahead ? line : p.turn_before(line);
    left = (p.turns[turns[s]].sign > 0) == ahead;
    moved = false;
    if (to_arc(turns, key, turned, k)) return;
    if (k == kNone && turns[0] == loop_start_[0] && turns[1] == loop_start_[1]) {  // a walk that stays at one point
      loop_turned_ = turned;
      return;
    }
  }
}

void ConvolutionNodes::add_still_walks() {
  for (const auto& [i, j] : still_) {
    if (passed_.count(pair_key(i, j))) continue;
    const ExactAngle &p = side_[0]->turns[i], &q = side_[1]->turns[j];
    Index turns[2] = {i, j};
    // Displaced inwards the sum of the radii is a little less than 0, outwards a little more: clockwise both times.
    Index low = minus(q.low, p.low) < p.length ? q.low : p.low;
    Index key = minus(high(p), low) <= minus(high(q), low) ? high(p) : high(q);
    loop_start_[0] = i;
    loop_start_[1] = j;
    loop_turned_ = 0;
    step_out(turns, key, false, 0, kNone, false);
    int rounds = int(loop_turned_ / std::int64_t(keys_));
    if (rounds == 0) continue;
    stills.push_back({{i, j}, rounds});
  }
}

void ConvolutionNodes::follow(Index from, Index to, Index key, std::int64_t turned) {
  Node &n = nodes[from], &m = nodes[to];
  n.next = to;
  n.smooth_end = m.smooth_start = n.key_out / 2 == key / 2;
  n.rotation = std::int8_t((turned > 0) - (turned < 0));
  // A cusp: the path goes from one end to the other where they are next to each other.
  const bool cusp = n.forward != m.forward && n.smooth_end && std::abs(turned) <= 1;
  if (cusp) n.rotation = std::int8_t(bend_sum(n, m));
  if (!still_.empty()) n.extra = extra_rounds(n, m, key, turned);
}

const Direction& ConvolutionNodes::direction_of(const Node& n, Index key) const {
  return n.kind == Kind::kLine ? *line_of(n).direction : direction_at(n, key);
}

std::int8_t ConvolutionNodes::extra_rounds(const Node& in, const Node& out, Index key, std::int64_t turned) const {
  const Direction &d = direction_of(in, in.key_out), &e = direction_of(out, key);
  std::int64_t keys = keys_, full = turned / keys, rest = turned % keys;
  int cross = cross_sign(d, e), sign = (rest > 0) - (rest < 0);
  // How far the rest turns, in half turns: 0 less than one, 1 exactly one, 2 more.
  int halves = cross == sign ? 0 : cross == -sign ? 2 : dot_sign(d, e) < 0 ? 1 : 0;
  if (cross == 0 && halves == 0 && 2 * (sign * rest) > keys) {
    full += sign;
    halves = 0;
  }
  if (in.forward != out.forward) return std::int8_t(full);
  // Displaced to the left, the path goes round clockwise by half a turn less what it turns; to the right, the other
  // way.
  int side = in.forward ? 1 : -1, bend = halves == 1 ? -side * bend_sum(in, out) : 0;
  if (side * sign < 0 && (halves == 2 || bend > 0)) full -= side;
  if (side * sign > 0 && (halves == 2 || bend < 0)) full += side;
  return std::int8_t(full);
}

int ConvolutionNodes::bend_sum(const Node& in, const Node& out) const {
  auto bend = [](const Node& n) { return n.kind == Kind::kLine ? 0 : n.turns_left ? 1 : -1; };
  int p = bend(in), q = bend(out);
  if (p + q != 0 || p == 0) return p + q;
  auto radius = [&](const Node& n) {
    return abs(side_[0]->turns[n.at[0]].radius() + side_[1]->turns[n.at[1]].radius());
  };
  return p * compare(radius(out), radius(in));  // the smaller radius bends more
}

const Direction& ConvolutionNodes::direction_at(const Node& n, Index key) const {
  for (int s : {0, 1}) {
    const TurningPath& p = *side_[s];
    const Line &before = p.lines[n.at[s]], &after = p.lines[p.line_after(n.at[s])];
    if (before.key == key) return *before.direction;
    if (after.key == key) return *after.direction;
  }
  return *side_[0]->lines[0].direction;  // not reached: an arc ends where one of its turns ends
}

}  // namespace findspace::plane
