// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/sum/convolution_walks.h"

#include <array>
#include <cstdint>
#include <cstdlib>
#include <unordered_set>
#include <utility>

namespace findspace::plane {
namespace {

using Node = ConvolutionNodes::Node;
using Kind = ConvolutionNodes::Kind;
using Line = ConvolutionNodes::Line;
using Turn = ConvolutionNodes::Turn;

std::uint64_t pair_key(Index i, Index j) { return (std::uint64_t(i) << 32) | j; }

class Walks {
 public:
  explicit Walks(ConvolutionNodes& nodes) : n_(nodes) {}
  /// Finds the node that follows in the true direction of travel, and how much the direction turns on the way.
  void connect(Index k);
  /// Walks that stay at one point: an arc against one of the same radius and their neighbours, round and round. The
  /// displaced path circles the point.
  void add_still_walks();
  std::vector<StillWalk> stills;

 private:
  /// If the turn pair is a curve of its own, it follows node k.
  bool to_arc(const Index turns[2], Index key, std::int64_t angle, Index k);
  /// Leaves a turn pair, a single place unless `moved`, at the first end of one of its two intervals in the direction
  /// of movement. `moved`: the pair is a curve, and its end has been reached.
  void step_out(Index turns[2], Index key, bool left, std::int64_t angle, Index k, bool moved);
  void follow(Index from, Index to, Index key, std::int64_t angle);
  const Direction& direction_of(const Node& n, Index key) const;
  /// Whole rounds that the displaced path at the corner makes beyond what its two ends show (see Corner).
  std::int8_t extra_rounds(const Node& in, const Node& out, Index key, std::int64_t angle) const;
  /// Sign of the sum of the curvatures, positive to the left of the direction of travel: where the path turns back,
  /// which of its two ends lies to the left of the other.
  int bend_sum(const Node& in, const Node& out) const;

  ConvolutionNodes& n_;
  std::unordered_set<std::uint64_t> passed_;  // pairs walked through; kept only where arcs have one radius
  std::array<Index, 2> loop_start_{kNone, kNone};
  std::int64_t loop_angle_ = 0;
};

void Walks::connect(Index k) {
  Node& from = n_.nodes[k];
  if (from.kind == Kind::kArc) {
    Index turns[2] = {from.at[0], from.at[1]};
    return step_out(turns, from.key_out, from.turns_left, 0, k, true);
  }
  const Tracing& p = n_.side(from.side);
  Index turns[2];
  turns[1 - from.side] = from.at[1 - from.side];
  turns[from.side] = from.forward ? from.at[from.side] : p.turn_before(from.at[from.side]);
  bool left = (p.turns[turns[from.side]].sign > 0) == from.forward;
  if (!to_arc(turns, from.key_out, 0, k)) step_out(turns, from.key_out, left, 0, k, false);
}

bool Walks::to_arc(const Index turns[2], Index key, std::int64_t angle, Index k) {
  if (!n_.still.empty()) passed_.insert(pair_key(turns[0], turns[1]));
  const Index found = n_.arc_node(turns[0], turns[1]);
  if (found == kNone || k == kNone) return false;
  follow(k, found, key, angle);
  return true;
}

void Walks::step_out(Index turns[2], Index key, bool left, std::int64_t angle, Index k, bool moved) {
  for (;;) {
    Index to_end[2] = {0, 0};
    for (int s : {0, 1}) {
      const Turn& t = n_.side(s).turns[turns[s]];
      to_end[s] = moved ? 0 : left ? n_.minus(n_.high(t), key) : n_.minus(key, t.low);
    }
    int s;
    if (moved) {  // already at an end: of which side?
      const Turn& t = n_.side(0).turns[turns[0]];
      s = key == (left ? n_.high(t) : t.low) ? 0 : 1;
    } else {
      s = to_end[0] < to_end[1] ? 0 : 1;
      angle += left ? std::int64_t(to_end[s]) : -std::int64_t(to_end[s]);
      key = left ? n_.plus(key, to_end[s]) : n_.minus(key, to_end[s]);
    }
    const Tracing& p = n_.side(s);
    bool ahead = (p.turns[turns[s]].sign > 0) == left;  // leaves at the turn's end
    Index line = ahead ? p.line_after(turns[s]) : turns[s];
    if (!p.lines[line].empty) return follow(k, n_.line_node(s, line, turns[1 - s]), key, angle);
    turns[s] = ahead ? line : p.turn_before(line);
    left = (p.turns[turns[s]].sign > 0) == ahead;
    moved = false;
    if (to_arc(turns, key, angle, k)) return;
    if (k == kNone && turns[0] == loop_start_[0] && turns[1] == loop_start_[1]) {  // a walk that stays at one point
      loop_angle_ = angle;
      return;
    }
  }
}

void Walks::add_still_walks() {
  for (const auto& [i, j] : n_.still) {
    if (passed_.contains(pair_key(i, j))) continue;
    const Turn &p = n_.side(0).turns[i], &q = n_.side(1).turns[j];
    Index turns[2] = {i, j};
    // Displaced inwards the sum of the radii is a little less than 0, outwards a little more: clockwise both times.
    Index low = n_.minus(q.low, p.low) < p.length ? q.low : p.low;
    Index key = n_.minus(n_.high(p), low) <= n_.minus(n_.high(q), low) ? n_.high(p) : n_.high(q);
    loop_start_[0] = i;
    loop_start_[1] = j;
    loop_angle_ = 0;
    step_out(turns, key, false, 0, kNone, false);
    int rounds = int(loop_angle_ / std::int64_t(n_.keys()));
    if (rounds == 0) continue;
    stills.push_back({{i, j}, rounds});
  }
}

void Walks::follow(Index from, Index to, Index key, std::int64_t angle) {
  Node &n = n_.nodes[from], &m = n_.nodes[to];
  n.next = to;
  n.smooth_end = m.smooth_start = n.key_out / 2 == key / 2;
  n.rotation = std::int8_t((angle > 0) - (angle < 0));
  // A cusp: the path goes from one end to the other where they are next to each other.
  const bool cusp = n.forward != m.forward && n.smooth_end && std::abs(angle) <= 1;
  if (cusp) n.rotation = std::int8_t(bend_sum(n, m));
  if (!n_.still.empty()) n.extra = extra_rounds(n, m, key, angle);
}

const Direction& Walks::direction_of(const Node& n, Index key) const {
  return n.kind == Kind::kLine ? *n_.line_of(n).direction : n_.direction_at(n, key);
}

std::int8_t Walks::extra_rounds(const Node& in, const Node& out, Index key, std::int64_t angle) const {
  const Direction &d = direction_of(in, in.key_out), &e = direction_of(out, key);
  std::int64_t keys = n_.keys(), full = angle / keys, rest = angle % keys;
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

int Walks::bend_sum(const Node& in, const Node& out) const {
  auto bend = [](const Node& n) { return n.kind == Kind::kLine ? 0 : n.turns_left ? 1 : -1; };
  int p = bend(in), q = bend(out);
  if (p + q != 0 || p == 0) return p + q;
  auto radius = [&](const Node& n) {
    return abs(n_.side(0).turns[n.at[0]].radius() + n_.side(1).turns[n.at[1]].radius());
  };
  return p * compare(radius(out), radius(in));  // the smaller radius bends more
}

}  // namespace

std::vector<StillWalk> connect_nodes(ConvolutionNodes& nodes) {
  Walks walks(nodes);
  for (Index k = 0; k < nodes.nodes.size(); ++k) walks.connect(k);
  walks.add_still_walks();
  return std::move(walks.stills);
}

}  // namespace findspace::plane
