// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/convolution.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <unordered_map>
#include <unordered_set>

#include "plane/turning_path.h"

namespace findspace::plane {

using exact::Carrier;
using exact::int128;
using exact::Real;
using Line = TurningPath::Line;
using Turn = TurningPath::Turn;

namespace {

Index add_position(exact::Geometry& g, const Position& p) {
  return p.grid() ? g.add_grid_point(p.x, p.y) : g.add_real_point(p.real->x, p.real->y);
}

/// Room for `more` items without giving up growth by doubling.
template <class T>
void make_room(std::vector<T>& v, std::size_t more) {
  if (v.size() + more > v.capacity()) v.reserve(std::max(v.size() + more, 2 * v.capacity()));
}

}  // namespace

/// The convolution of one path of a with one path of b. Its curves are nodes (place in a, place in b): a line of one
/// side with a turn of the other, or two turns. Nodes follow each other in closed walks; those of length 0 are walked
/// through.
class PathPair {
 public:
  PathPair(ConvolutionBuilder& out, const TurningPath& a, const TurningPath& b, Index keys)
      : out_(out), side_{&a, &b}, keys_(keys) {}

  void run() {
    Index count = count_lines(0) + count_lines(1);
    nodes_.reserve(count);
    for (int s : {0, 1}) add_lines(s);
    add_arcs();
    for (Index k = 0; k < nodes_.size(); ++k) connect(k);
    add_still_walks();
    reserve(nodes_.size());
    for (Index k = 0; k < nodes_.size(); ++k) {
      Node& n = nodes_[k];
      if (n.kind == Kind::kLine)
        n.carrier = add_line(line_of(n), turn_of(n));
      else
        n.carrier = k > 0 && on_one_circle(nodes_[k - 1], n) ? nodes_[k - 1].carrier : add_circle(n);
    }
    for (Node& n : nodes_) n.end = nodes_[n.next].start = add_end(n, nodes_[n.next]);
    for (Node& n : nodes_) finish(n);
    emit_corners();
  }

 private:
  enum class Kind : std::uint8_t { kLine, kArc };  // line of `side` x turn of the other side; turn x turn

  struct Node {
    Kind kind;
    std::uint8_t side;       // kLine: whose line
    bool forward = true;     // true direction of travel is that of the common tangent; displaced side accordingly
    bool turns_left = true;  // kArc: directions run counter-clockwise
    bool smooth_start = false, smooth_end = false;
    std::int8_t rotation = 0, extra = 0;  // at its end
    Index at[2] = {0, 0};                 // the turns; kLine: at[side] is the line
    Index key_in = 0, key_out = 0;        // kArc: directions at its start and end; kLine: both the line's key
    Index start = kNone, end = kNone;     // points
    Index next = kNone;
    Index carrier = kNone, piece = kNone;
  };

  struct Range {               // the lines whose keys a turn of the other side sweeps
    Index first, count, base;  // places in `sorted`; first node
  };

  Index minus(Index p, Index q) const { return p >= q ? p - q : p + keys_ - q; }
  Index plus(Index p, Index q) const { return p + q >= keys_ ? p + q - keys_ : p + q; }
  static std::uint64_t pair_key(Index i, Index j) { return (std::uint64_t(i) << 32) | j; }
  Index high(const Turn& t) const { return plus(t.low, t.length); }

  /// Finds the lines of side s that meet the turns of the other side; how many there are.
  Index count_lines(int s) {
    const TurningPath &p = *side_[s], &other = *side_[1 - s];
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

  /// Lines of side s with the turns of the other side.
  void add_lines(int s) {
    const TurningPath &p = *side_[s], &other = *side_[1 - s];
    Index n = Index(p.sorted.size());
    for (Index t = 0; t < other.size(); ++t) {
      Range& range = ranges_[s][t];
      range.base = Index(nodes_.size());
      for (Index k = 0; k < range.count; ++k) {
        Node& node = nodes_.emplace_back(Node{.kind = Kind::kLine, .side = std::uint8_t(s)});
        node.at[s] = p.sorted[range.first + k < n ? range.first + k : range.first + k - n];
        node.at[1 - s] = t;
        node.forward = other.turns[t].sign > 0;
        node.key_in = node.key_out = p.lines[node.at[s]].key;
      }
    }
  }

  Index line_node(int s, Index line, Index turn) const {
    const Range& range = ranges_[s][turn];
    Index place = side_[s]->lines[line].place, n = Index(side_[s]->sorted.size());
    return range.base + (place >= range.first ? place - range.first : place + n - range.first);
  }

  void add_arcs() {
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

  void add_arc(Index i, Index j) {
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
      still_.push_back({i, j});
      return;
    }
    Node node{.kind = Kind::kArc, .side = 0};
    node.at[0] = i, node.at[1] = j;
    node.forward = p.sign == q.sign ? p.sign > 0 : sum < 0;
    // The place moves with the tangent while directions grow and the radius is positive.
    node.turns_left = node.forward == (sum > 0);
    node.key_in = node.turns_left ? low : high_end;
    node.key_out = node.turns_left ? high_end : low;
    arc_node_[pair_key(i, j)] = Index(nodes_.size());
    nodes_.push_back(node);
  }

  /// Finds the node that follows in the true direction of travel, and how much the direction turns on the way.
  void connect(Index k) {
    Node& from = nodes_[k];
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

  /// If the turn pair is a curve of its own, it follows node k.
  bool to_arc(const Index turns[2], Index key, std::int64_t turned, Index k) {
    if (!still_.empty()) passed_.insert(pair_key(turns[0], turns[1]));
    if (arc_node_.empty()) return false;
    auto found = arc_node_.find(pair_key(turns[0], turns[1]));
    if (found == arc_node_.end() || k == kNone) return false;
    follow(k, found->second, key, turned);
    return true;
  }

  /// Leaves a turn pair, a single place unless `moved`, at the first end of one of its two intervals in the direction
  /// of movement. `moved`: the pair is a curve, and its end has been reached.
  void step_out(Index turns[2], Index key, bool left, std::int64_t turned, Index k, bool moved) {
    for (;;) {
      Index room[2];
      for (int s : {0, 1}) {
        const Turn& t = side_[s]->turns[turns[s]];
        room[s] = moved ? 0 : left ? minus(high(t), key) : minus(key, t.low);
      }
      int s;
      if (moved) {  // already at an end: of which side?
        const Turn& t = side_[0]->turns[turns[0]];
        s = key == (left ? high(t) : t.low) ? 0 : 1;
      } else {
        s = room[0] < room[1] ? 0 : 1;
        turned += left ? std::int64_t(room[s]) : -std::int64_t(room[s]);
        key = left ? plus(key, room[s]) : minus(key, room[s]);
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

  /// Walks that stay at one point: an arc against one of the same radius and their neighbours, round and round. The
  /// displaced path circles the point.
  void add_still_walks() {
    for (const auto& [i, j] : still_) {
      if (passed_.count(pair_key(i, j))) continue;
      const Turn &p = side_[0]->turns[i], &q = side_[1]->turns[j];
      Index turns[2] = {i, j};
      // Displaced inwards the sum of the radii is a little less than 0, outwards a little more: clockwise both times.
      Index low = minus(q.low, p.low) < p.length ? q.low : p.low;
      Index key = minus(high(p), low) <= minus(high(q), low) ? high(p) : high(q);
      loop_start_[0] = i, loop_start_[1] = j;
      loop_turned_ = 0;
      step_out(turns, key, false, 0, kNone, false);
      int rounds = int(loop_turned_ / std::int64_t(keys_));
      if (rounds == 0) continue;
      Position at = *p.center + *q.center;
      out_.circled.push_back({add_position(out_.curves.geometry, at), rounds});
    }
  }

  void follow(Index from, Index to, Index key, std::int64_t turned) {
    Node &n = nodes_[from], &m = nodes_[to];
    n.next = to;
    n.smooth_end = m.smooth_start = n.key_out / 2 == key / 2;
    n.rotation = std::int8_t((turned > 0) - (turned < 0));
    // A cusp: the path goes from one end to the other where they are next to each other.
    const bool cusp = n.forward != m.forward && n.smooth_end && std::abs(turned) <= 1;
    if (cusp) n.rotation = std::int8_t(bend_sum(n, m));
    if (!still_.empty()) n.extra = extra_rounds(n, m, key, turned);
  }

  const Direction& direction_of(const Node& n, Index key) const {
    return n.kind == Kind::kLine ? *line_of(n).direction : direction_at(n, key);
  }

  /// Whole rounds that the displaced path at the corner makes beyond what its two ends show (see Corner).
  std::int8_t extra_rounds(const Node& in, const Node& out, Index key, std::int64_t turned) const {
    const Direction &d = direction_of(in, in.key_out), &e = direction_of(out, key);
    std::int64_t keys = keys_, full = turned / keys, rest = turned % keys;
    int cross = cross_sign(d, e), sign = (rest > 0) - (rest < 0);
    // How far the rest turns, in half turns: 0 less than one, 1 exactly one, 2 more.
    int halves = cross == sign ? 0 : cross == -sign ? 2 : dot_sign(d, e) < 0 ? 1 : 0;
    if (cross == 0 && halves == 0 && 2 * (sign * rest) > keys) full += sign, halves = 0;
    if (in.forward != out.forward) return std::int8_t(full);
    // Displaced to the left, the path goes round clockwise by half a turn less what it turns; to the right, the other
    // way.
    int side = in.forward ? 1 : -1, bend = halves == 1 ? -side * bend_sum(in, out) : 0;
    if (side * sign < 0 && (halves == 2 || bend > 0)) full -= side;
    if (side * sign > 0 && (halves == 2 || bend < 0)) full += side;
    return std::int8_t(full);
  }

  /// Sign of the sum of the curvatures, positive to the left of the direction of travel: where the path turns back,
  /// which of its two ends lies to the left of the other.
  int bend_sum(const Node& in, const Node& out) const {
    auto bend = [](const Node& n) { return n.kind == Kind::kLine ? 0 : n.turns_left ? 1 : -1; };
    int p = bend(in), q = bend(out);
    if (p + q != 0 || p == 0) return p + q;
    auto radius = [&](const Node& n) {
      return abs(side_[0]->turns[n.at[0]].radius() + side_[1]->turns[n.at[1]].radius());
    };
    return p * compare(radius(out), radius(in));  // the smaller radius bends more
  }

  /// centre + radius * normal of a turn in the direction of a line.
  static Position place(const Turn& t, const Direction& d) {
    if (!t.arc) return *t.center;
    Position n = d.right_normal();
    Real r = t.radius();
    return Position::of(t.center->real_x() + r * n.real_x(), t.center->real_y() + r * n.real_y());
  }

  const Direction& direction_at(const Node& n, Index key) const {
    for (int s : {0, 1}) {
      const TurningPath& p = *side_[s];
      const Line &before = p.lines[n.at[s]], &after = p.lines[p.line_after(n.at[s])];
      if (before.key == key) return *before.direction;
      if (after.key == key) return *after.direction;
    }
    return *side_[0]->lines[0].direction;  // not reached: an arc ends where one of its turns ends
  }

  const Line& line_of(const Node& n) const { return side_[n.side]->lines[n.at[n.side]]; }
  const Turn& turn_of(const Node& n) const { return side_[1 - n.side]->turns[n.at[1 - n.side]]; }

  /// Where node n ends and m, the next one, starts.
  Index add_end(const Node& n, const Node& m) {
    auto& g = out_.curves.geometry;
    if (n.kind == Kind::kLine) {
      const Line& l = line_of(n);
      const Turn& t = turn_of(n);
      const Position &p = n.forward ? *l.to : *l.from, &q = *t.center;
      if (!t.arc && p.grid() && q.grid()) return g.add_grid_point(p.x + q.x, p.y + q.y);
      if (n.smooth_end && touch_obliquely(n, m)) return g.add_crossing(n.carrier, m.carrier, 0);
      return add_position(g, p + place(t, *l.direction));
    }
    if (n.smooth_end && touch_obliquely(m, n)) return g.add_crossing(m.carrier, n.carrier, 0);
    const Direction& d = direction_at(n, n.key_out);
    return add_position(g, place(side_[0]->turns[n.at[0]], d) + place(side_[1]->turns[n.at[1]], d));
  }

  /// Smooth neighbours, a line and a circle: their common point needs no coordinates; but where the line is parallel to
  /// an axis these are simple.
  bool touch_obliquely(const Node& line, const Node& arc) const {
    if (line.kind != Kind::kLine || arc.kind != Kind::kArc) return false;
    const Direction& d = *line_of(line).direction;
    return d.grid() && d.x != 0 && d.y != 0;
  }

  void reserve(std::size_t more) {
    make_room(out_.curves.geometry.carriers, more);
    make_room(out_.curves.pieces, more);
    make_room(out_.curves.forward, more);
    make_room(out_.strands, more);
    make_room(out_.corners, more);
  }

  void finish(Node& n) {
    std::int8_t half = 0;
    bool right;
    if (n.kind == Kind::kLine) {
      const Direction& d = *line_of(n).direction;
      right = (d.x > 0 || (d.x == 0 && d.y > 0)) == n.forward;
    } else {
      const Turn &p = side_[0]->turns[n.at[0]], &q = side_[1]->turns[n.at[1]];
      half = std::int8_t((p.radius() + q.radius()).sign() * (p.arc ? p.normal_up() : q.normal_up()));
      right = (half < 0) == n.turns_left;
    }
    n.piece = Index(out_.curves.pieces.size());
    out_.curves.pieces.push_back({.carrier = n.carrier,
                                  .p0 = right ? n.start : n.end,
                                  .p1 = right ? n.end : n.start,
                                  .half = half,
                                  .smooth0 = right ? n.smooth_start : n.smooth_end,
                                  .smooth1 = right ? n.smooth_end : n.smooth_start});
    out_.curves.forward.push_back(right);
    out_.strands.push_back({.forward = right, .displaced_left = n.forward == out_.inward_});
  }

  /// Two arcs of one circle about one vertex, as far as that shows at once.
  bool on_one_circle(const Node& n, const Node& m) const {
    if (n.kind != Kind::kArc || m.kind != Kind::kArc || n.at[0] != m.at[0]) return false;
    const Turn &p = side_[1]->turns[n.at[1]], &q = side_[1]->turns[m.at[1]];
    if (!p.arc || !q.arc || p.sign != q.sign) return false;
    return p.center->grid() && q.center->grid() && p.center->x == q.center->x && p.center->y == q.center->y &&
           p.radius() == q.radius();
  }

  Index add_circle(const Node& n) {
    const Turn &p = side_[0]->turns[n.at[0]], &q = side_[1]->turns[n.at[1]];
    Position c = *p.center + *q.center;
    Real r = abs(p.radius() + q.radius());
    return out_.curves.geometry.add(c.grid() ? Carrier::circle_at(c.x, c.y, r)
                                             : Carrier::circle_at(c.real->x, c.real->y, r));
  }

  Index add_line(const Line& l, const Turn& t) {
    // Directions are primitive: the canonical normal needs no division.
    std::int64_t a = l.direction->y, b = -l.direction->x;
    bool flipped = a < 0 || (a == 0 && b < 0);
    if (flipped) a = -a, b = -b;
    auto& g = out_.curves.geometry;
    const Position &p = *l.from, &q = *t.center;
    if (!t.arc && p.grid() && q.grid()) return g.add_line(a, b, int128(a) * (p.x + q.x) + int128(b) * (p.y + q.y));
    // The place on an arc is the centre plus the radius times the unit normal, which is (a, b) / |(a, b)| or its
    // opposite.
    Real shift = flipped ? -t.radius() : t.radius();
    Position sum = p + q;
    if (sum.grid()) return g.add(Carrier::displaced_line(a, b, int128(a) * sum.x + int128(b) * sum.y, shift));
    Real c = Real(a) * sum.real_x() + Real(b) * sum.real_y();
    if (t.arc) c += shift * sqrt(Real(int128(a) * a + int128(b) * b));
    return g.add(Carrier::line(a, b, c));
  }

  void emit_corners() {
    for (const Node& n : nodes_) out_.corners.push_back({n.piece, nodes_[n.next].piece, n.rotation, n.extra});
  }

  ConvolutionBuilder& out_;
  const TurningPath* side_[2];
  Index keys_;
  std::vector<Range> ranges_[2];  // of the lines of a side, per turn of the other
  std::vector<Node> nodes_;
  std::unordered_map<std::uint64_t, Index> arc_node_;
  std::vector<std::array<Index, 2>> still_;   // pairs of arcs of one radius: curves of length 0 that turn
  std::unordered_set<std::uint64_t> passed_;  // pairs walked through; kept only if there are such arcs
  std::array<Index, 2> loop_start_{kNone, kNone};
  std::int64_t loop_turned_ = 0;
};

void ConvolutionBuilder::add(const Part& a, const Part& b) {
  std::vector<TurningPath> p, q;
  p.reserve(a.paths.size()), q.reserve(b.paths.size());
  for (const Path& path : a.paths) p.push_back(TurningPath::from(path, a.flat));
  for (const Path& path : b.paths) q.push_back(TurningPath::from(path, b.flat));
  Index keys = assign_keys(p, q);
  for (const Path& path : a.paths)
    for (const Path& other : b.paths)
      if (path.lonely && other.lonely) {
        Position at = *path.lonely + *other.lonely;
        points.push_back(add_position(curves.geometry, at));
      }
  for (const TurningPath& x : p)
    for (const TurningPath& y : q) PathPair(*this, x, y, keys).run();
}

}  // namespace findspace::plane
