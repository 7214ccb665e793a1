// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/transversal_sum.h"

#include <algorithm>
#include <array>
#include <utility>

#include "plane/meeting_curves.h"
#include "plane/ring_map.h"

namespace findspace::plane {
namespace {

/// The closed walks along outer sides, against the way of the curves.
class OuterWalks {
 public:
  OuterWalks(const MeetingCurves& curves, Memory memory)
      : curves_(curves), state_(curves.part_count(), kNew, memory), parts_(memory) {}

  struct Part {
    Index curve, slot;
  };

  /// The walk from a part of a curve, if it is closed and new.
  std::span<const Part> walk(Part from) {
    parts_.clear();
    Part at = from;
    for (;;) {
      char& state = state_[curves_.part(at.curve, at.slot)];
      if (state == kDone || state == kInner) return leave(kInner);
      if (state == kOpen) break;
      state = kOpen;
      parts_.push_back(at);
      if (!advance(at)) return leave(kInner);
    }
    // A walk may start on a curve that runs along another one: then it comes back to a later part.
    auto start = std::find_if(parts_.begin(), parts_.end(),
                              [&](const Part& p) { return p.curve == at.curve && p.slot == at.slot; });
    leave(kDone);
    return std::span(start, parts_.end());
  }

  bool is_new(Index curve, Index slot) const { return state_[curves_.part(curve, slot)] == kNew; }

 private:
  enum State : char { kNew, kOpen, kInner, kDone };

  /// To the part before; false where the walk would pass an inner side.
  bool advance(Part& at) const {
    if (Index knot = curves_.knot_before(at.curve, at.slot); knot != kNone) {
      const Arm& arm = curves_.clockwise(knot, at.curve, at.slot);
      if (arm.starts) return false;
      at = {arm.curve, arm.slot};
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

  std::span<const Part> leave(State state) {
    for (const Part& p : parts_) state_[curves_.part(p.curve, p.slot)] = state;
    return {};
  }

  const MeetingCurves& curves_;
  std::pmr::vector<char> state_;
  std::pmr::vector<Part> parts_;
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
    return ring_map(std::move(c_.geometry), rings_, rings_of_one_face(starts_));
  }

 private:
  bool find_rings() {
    OuterWalks walks(curves_, memory_);
    Index first = leftmost();
    if (first == kNone) return false;
    auto outer = walks.walk({first, 0});
    if (outer.empty() || !add_ring(outer)) return false;
    for (Index i = 0; i < curves_.size(); ++i)
      for (Index k = 0; k <= curves_.stop_count(i); ++k) {
        if (!walks.is_new(i, k)) continue;
        auto walk = walks.walk({i, k});
        if (!walk.empty() && !is_inside(walk.front()) && !add_ring(walk)) return false;
      }
    for (Index k = 0; k < curves_.knot_count(); ++k)
      if (passed_[k] == 0 && curves_.could_hide_point(k)) return false;
    return true;
  }

  /// The curve that starts at the leftmost corner of the sum: it is part of the outer ring. Ends made by pruning lie
  /// inside.
  Index leftmost() const {
    const auto& points = c_.geometry.points;
    Index best = kNone;
    for (Index i = 0; i < curves_.size(); ++i) {
      const exact::Point& p = points[curves_.start(i)];
      if (p.kind != exact::Point::Kind::kGrid) continue;
      if (best == kNone) best = i;
      const exact::Point& q = points[curves_.start(best)];
      if (p.gx < q.gx || (p.gx == q.gx && p.gy < q.gy)) best = i;
    }
    return best;
  }

  /// Whether the face beside a walk is in the sum all the same: as its parts are, displaced.
  bool is_inside(OuterWalks::Part p) {
    Index from = p.slot == 0 ? curves_.start(p.curve) : curves_.stop(p.curve, p.slot - 1).point;
    Index to = p.slot == curves_.stop_count(p.curve) ? curves_.end(p.curve) : curves_.stop(p.curve, p.slot).point;
    return inside_(c_.geometry, point_between(c_.geometry, curves_.carrier(p.curve), from, to));
  }

  /// False where the ring passes a knot that a ring has passed before.
  bool add_ring(std::span<const OuterWalks::Part> walk) {
    starts_.push_back(Index(rings_.size()));
    for (std::size_t k = walk.size(); k-- > 0;) {
      OuterWalks::Part p = walk[k], before = walk[k + 1 == walk.size() ? 0 : k + 1];
      if (Index knot = curves_.knot_before(p.curve, p.slot); knot != kNone && passed_[knot]++ > 0) return false;
      if (straight(before.curve, p.curve)) continue;
      Index point = p.slot == 0 ? curves_.start(p.curve) : curves_.stop(p.curve, p.slot - 1).point;
      rings_.push_back({point, curves_.carrier(p.curve), curves_.right(p.curve)});
    }
    return true;
  }

  bool straight(Index i, Index j) const {
    const auto &k = c_.geometry.carriers[curves_.carrier(i)], &l = c_.geometry.carriers[curves_.carrier(j)];
    return k.a == l.a && k.b == l.b;
  }

  ReducedConvolution& c_;
  const InsideTest& inside_;
  MeetingCurves curves_;
  std::pmr::vector<RingEdge> rings_;
  std::pmr::vector<Index> starts_;
  std::array<int, kMostKnots> passed_{};  // knot -> times a ring passed it
  Memory memory_;
};

}  // namespace

std::optional<SignMap> transversal_sum(ReducedConvolution& convolution, const InsideTest& inside) {
  if (convolution.pieces.empty()) return std::nullopt;
  Scratch scratch(convolution.pieces.size());
  return TransversalSum(convolution, inside, scratch.memory()).run();
}

}  // namespace findspace::plane
