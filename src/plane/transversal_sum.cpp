// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/transversal_sum.h"

#include <algorithm>
#include <numeric>

#include "plane/broad_phase.h"
#include "plane/piece_meet.h"
#include "plane/ring_map.h"

namespace findspace::plane {
namespace {

/// Where another curve crosses a curve.
struct Stop {
  Index piece, point;
  Index other;      // the other curve
  bool from_right;  // the other curve passes from the right to the left
  Index twin;       // the place of this crossing among the stops of the other curve
};

class Curves {
 public:
  Curves(ReducedConvolution& c, Memory memory)
      : c_(c), g_(c.geometry), stops_(memory), first_stop_(memory), ends_at_(memory), memory_(memory) {}

  /// Finds all crossings; false if the curves are not in general position.
  bool cross_all() {
    std::pmr::vector<PieceBox> boxes(memory_);
    boxes.reserve(size());
    for (const Piece& p : c_.pieces) {
      const exact::Point &a = g_.points[p.p0], &b = g_.points[p.p1];
      boxes.push_back({a.x, std::min(a.y, b.y), b.x, std::max(a.y, b.y)});
    }
    ends_at_.assign(g_.points.size(), kNone);
    for (Index i = 0; i < size(); ++i) ends_at_[end(i)] = i;
    std::pmr::vector<Index> order(size(), memory_);
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](Index i, Index j) { return boxes[i].x0 < boxes[j].x0; });
    for (Index s = 0; s < size(); ++s) {
      const PieceBox& box = boxes[order[s]];
      for (Index t = s + 1; t < size() && boxes[order[t]].x0 <= box.x1; ++t)
        if (box.meets(boxes[order[t]]) && !cross(order[s], order[t])) return false;
    }
    return sort_stops();
  }

  Index size() const { return Index(c_.pieces.size()); }
  /// Curves run with their inner side on the left.
  bool right(Index i) const { return c_.sides[i].left; }
  Index start(Index i) const { return right(i) ? c_.pieces[i].p0 : c_.pieces[i].p1; }
  Index end(Index i) const { return right(i) ? c_.pieces[i].p1 : c_.pieces[i].p0; }
  Index carrier(Index i) const { return c_.pieces[i].carrier; }
  /// The curve that ends where curve i starts, or kNone.
  Index before(Index i) const { return ends_at_[start(i)]; }
  Index stop_count(Index i) const { return first_stop_[i + 1] - first_stop_[i]; }
  const Stop& stop(Index i, Index k) const { return stops_[first_stop_[i] + k]; }
  /// Parts of all curves between stops, counted through: part k of curve i ends at its stop k.
  Index part(Index i, Index k) const { return first_stop_[i] + i + k; }
  Index part_count() const { return Index(stops_.size()) + size(); }

 private:
  /// Notes where two curves cross; false if they meet in another way than at a common end.
  bool cross(Index i, Index j) {
    const Piece &p = c_.pieces[i], &q = c_.pieces[j];
    const exact::Carrier &k = g_.carriers[p.carrier], &l = g_.carriers[q.carrier];
    bool parallel = k.a == l.a && k.b == l.b;
    if (p.p0 == q.p1 || p.p1 == q.p0) return true;
    if (p.p0 == q.p0 || p.p1 == q.p1) return !parallel;
    if (parallel) return k.c != l.c;
    int s0 = g_.side(q.p0, p.carrier), s1 = g_.side(q.p1, p.carrier);
    if (s0 * s1 > 0) return true;
    int t0 = g_.side(p.p0, q.carrier), t1 = g_.side(p.p1, q.carrier);
    if (t0 * t1 > 0) return true;
    if (s0 * s1 == 0 || t0 * t1 == 0) return false;
    Index point = g_.add_crossing(p.carrier, q.carrier, 0);
    // The normal (a, b) is to the left of the direction (b, -a), the way to the right if b > 0.
    bool normal_left = (k.b > 0) == right(i);
    bool from_right = ((right(j) ? s0 : s1) > 0) != normal_left;
    stops_.push_back({i, point, j, from_right, kNone});
    stops_.push_back({j, point, i, !from_right, kNone});
    return true;
  }

  /// Along every curve; false if three curves meet at a point.
  bool sort_stops() {
    first_stop_.assign(size() + 1, 0);
    for (const Stop& s : stops_) ++first_stop_[s.piece + 1];
    for (Index i = 0; i < size(); ++i) first_stop_[i + 1] += first_stop_[i];
    std::pmr::vector<Stop> sorted(stops_.size(), Stop{}, memory_);
    std::pmr::vector<Index> at(first_stop_.begin(), first_stop_.end() - 1, memory_);
    for (const Stop& s : stops_) sorted[at[s.piece]++] = s;
    stops_.swap(sorted);
    for (Index i = 0; i < size(); ++i)
      if (!sort_stops_of(i)) return false;
    // The two stops of a crossing find each other.
    std::pmr::vector<Index> first(g_.points.size(), kNone, memory_);
    for (Index s = 0; s < stops_.size(); ++s) {
      Index& other = first[stops_[s].point];
      if (other != kNone) {
        stops_[s].twin = other - first_stop_[stops_[other].piece];
        stops_[other].twin = s - first_stop_[stops_[s].piece];
      }
      other = s;
    }
    return true;
  }

  bool sort_stops_of(Index i) {
    bool tie = false;
    for (Index k = first_stop_[i] + 1; k < first_stop_[i + 1]; ++k) {
      Stop item = stops_[k];
      Index at = k;
      for (; at > first_stop_[i]; --at) {
        int order = compare_along(g_, c_.pieces[i], item.point, stops_[at - 1].point);
        tie |= order == 0;
        if ((right(i) ? order : -order) >= 0) break;
        stops_[at] = stops_[at - 1];
      }
      stops_[at] = item;
    }
    return !tie;
  }

  ReducedConvolution& c_;
  exact::Geometry& g_;
  std::pmr::vector<Stop> stops_;
  std::pmr::vector<Index> first_stop_, ends_at_;
  Memory memory_;
};

/// The closed walks along outer sides, against the way of the curves.
class OuterWalks {
 public:
  OuterWalks(const Curves& curves, Memory memory)
      : curves_(curves), state_(curves.part_count(), kNew, memory), edges_(memory) {}

  struct Part {
    Index curve, slot;
  };

  /// The walk from a part of a curve, if it is closed and new.
  std::span<const Part> walk(Part from) {
    edges_.clear();
    Part at = from;
    for (;;) {
      char& state = state_[curves_.part(at.curve, at.slot)];
      if (state == kDone || state == kInner) return leave(kInner);
      if (state == kOpen) break;  // back at the start: every part has one predecessor
      state = kOpen;
      edges_.push_back(at);
      if (!advance(at)) return leave(kInner);
    }
    leave(kDone);
    return edges_;
  }

  bool is_new(Index curve, Index slot) const { return state_[curves_.part(curve, slot)] == kNew; }

 private:
  enum State : char { kNew, kOpen, kInner, kDone };

  /// To the part before; false where the walk would pass an inner side.
  bool advance(Part& at) const {
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

  std::span<const Part> leave(State state) {
    for (const Part& p : edges_) state_[curves_.part(p.curve, p.slot)] = state;
    return {};
  }

  const Curves& curves_;
  std::pmr::vector<char> state_;
  std::pmr::vector<Part> edges_;
};

class TransversalSum {
 public:
  TransversalSum(ReducedConvolution& c, const InsideTest& inside, Memory memory)
      : c_(c), inside_(inside), curves_(c, memory), rings_(memory), starts_(memory), memory_(memory) {}

  std::optional<SignMap> run() {
    std::size_t known = c_.geometry.points.size();
    if (!curves_.cross_all() || !find_rings()) {
      c_.geometry.points.resize(known);
      return std::nullopt;
    }
    return ring_map(c_.geometry, rings_, starts_);
  }

 private:
  bool find_rings() {
    OuterWalks walks(curves_, memory_);
    Index first = leftmost();
    add_ring(walks.walk({first, 0}));
    if (starts_.empty()) return false;
    for (Index i = 0; i < curves_.size(); ++i)
      for (Index k = 0; k <= curves_.stop_count(i); ++k) {
        if (!walks.is_new(i, k)) continue;
        auto walk = walks.walk({i, k});
        if (!walk.empty() && !is_inside(walk.front())) add_ring(walk);
      }
    return true;
  }

  /// The curve that starts at the leftmost point: it is part of the outer ring.
  Index leftmost() const {
    const auto& points = c_.geometry.points;
    auto less = [&](Index i, Index j) {
      const exact::Point &p = points[curves_.start(i)], &q = points[curves_.start(j)];
      return p.gx != q.gx ? p.gx < q.gx : p.gy < q.gy;
    };
    Index best = 0;
    for (Index i = 1; i < curves_.size(); ++i)
      if (less(i, best)) best = i;
    return best;
  }

  /// Whether the face beside a walk is in the sum all the same: as its parts are, displaced.
  bool is_inside(OuterWalks::Part p) {
    Index from = p.slot == 0 ? curves_.start(p.curve) : curves_.stop(p.curve, p.slot - 1).point;
    Index to = p.slot == curves_.stop_count(p.curve) ? curves_.end(p.curve) : curves_.stop(p.curve, p.slot).point;
    return inside_(c_.geometry, point_between(c_.geometry, curves_.carrier(p.curve), from, to));
  }

  void add_ring(std::span<const OuterWalks::Part> walk) {
    if (walk.empty()) return;
    starts_.push_back(Index(rings_.size()));
    for (std::size_t k = walk.size(); k-- > 0;) {
      OuterWalks::Part p = walk[k], before = walk[k + 1 == walk.size() ? 0 : k + 1];
      if (p.slot == 0 && straight(before.curve, p.curve)) continue;
      Index point = p.slot == 0 ? curves_.start(p.curve) : curves_.stop(p.curve, p.slot - 1).point;
      rings_.push_back({point, curves_.carrier(p.curve), curves_.right(p.curve)});
    }
  }

  bool straight(Index i, Index j) const {
    const auto &k = c_.geometry.carriers[curves_.carrier(i)], &l = c_.geometry.carriers[curves_.carrier(j)];
    return k.a == l.a && k.b == l.b;
  }

  ReducedConvolution& c_;
  const InsideTest& inside_;
  Curves curves_;
  std::pmr::vector<RingEdge> rings_;
  std::pmr::vector<Index> starts_;
  Memory memory_;
};

}  // namespace

std::optional<SignMap> transversal_sum(ReducedConvolution& convolution, const InsideTest& inside) {
  if (convolution.pieces.empty()) return std::nullopt;
  Scratch scratch(convolution.pieces.size());
  return TransversalSum(convolution, inside, scratch.memory()).run();
}

}  // namespace findspace::plane
