// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "plane/grid/curve_stops.h"

#include <algorithm>

#include "exact/planar/geometry_signs.h"
#include "plane/base/small_sort.h"
#include "plane/complex/broad_phase.h"
#include "plane/complex/piece_meet.h"

namespace findspace::plane {
namespace {

constexpr Index kFewStops = 8;

/// One crossing, or one degenerate vertex.
bool same_meeting(const Stop& s, const Stop& t) {
  return s.other == t.other && (s.other != kNone || s.point == t.point);
}

/// Finds where curves meet, in any order.
class StopFinder {
 public:
  StopFinder(ReducedConvolution& c, CurveStops& out) : c_(c), g_(c.geometry), out_(out) {}
  /// Notes where two curves meet.
  void cross(Index i, Index j);

 private:
  /// Two curves on one line.
  void overlap(Index i, Index j);
  /// An end of a curve on the line of curve i.
  void place(Index i, Index node);
  /// The end of a curve lies on curve i.
  void touch(Index i, Index node);

  ReducedConvolution& c_;
  exact::Geometry& g_;
  CurveStops& out_;
};

/// Puts stops in order along every curve; what meets at one point becomes a degenerate vertex, or is dropped if it is
/// there twice.
class StopSorter {
 public:
  StopSorter(const ReducedConvolution& c, CurveStops& out, Memory memory)
      : c_(c), g_(c.geometry), out_(out), estimates_(memory), memory_(memory) {}
  void run();

 private:
  struct Estimate {
    double along;  // the curve
    Stop stop;
  };

  Index size() const { return Index(c_.pieces.size()); }
  Index stop_count(Index i) const { return out_.first[i + 1] - out_.first[i]; }
  void group_stops();
  void sort_stops_of(Index i);
  /// As nearly as approximate coordinates tell.
  void sort_by_estimate(Index i);
  void tie_stops_of(Index i);
  void drop_repeated();
  /// The two stops of a crossing find each other.
  void find_twins();

  const ReducedConvolution& c_;
  const exact::Geometry& g_;
  CurveStops& out_;
  std::pmr::vector<Estimate> estimates_;  // of one curve at a time
  Memory memory_;
};

void StopFinder::cross(Index i, Index j) {
  const Piece &p = c_.pieces[i], &q = c_.pieces[j];
  const exact::SupportingCurve &k = g_.supporting_curves[p.supporting_curve],
                               &l = g_.supporting_curves[q.supporting_curve];
  if (p.p0 == q.p1 || p.p1 == q.p0) return;
  if (k.a == l.a && k.b == l.b) return k.c == l.c ? overlap(i, j) : void();
  if (p.p0 == q.p0 || p.p1 == q.p1) return;
  int s0 = side(g_, q.p0, p.supporting_curve), s1 = side(g_, q.p1, p.supporting_curve);
  if (s0 * s1 > 0) return;
  int t0 = side(g_, p.p0, q.supporting_curve), t1 = side(g_, p.p1, q.supporting_curve);
  if (t0 * t1 > 0) return;
  Index q_end = s0 == 0 ? q.p0 : s1 == 0 ? q.p1 : kNone, p_end = t0 == 0 ? p.p0 : t1 == 0 ? p.p1 : kNone;
  if (q_end != kNone && p_end != kNone) return out_.degenerate_vertices.tie(p_end, q_end);
  if (q_end != kNone) return touch(i, q_end);
  if (p_end != kNone) return touch(j, p_end);
  Index point = g_.add_crossing(p.supporting_curve, q.supporting_curve, 0);
  // The normal (a, b) is to the left of the direction (b, -a), the way to the right if b > 0.
  bool normal_left = (k.b > 0) == runs_right(c_, i);
  bool from_right = ((runs_right(c_, j) ? s0 : s1) > 0) != normal_left;
  out_.stops.push_back({i, point, j, from_right, kNone});
  out_.stops.push_back({j, point, i, !from_right, kNone});
}

void StopFinder::overlap(Index i, Index j) {
  const Piece &p = c_.pieces[i], &q = c_.pieces[j];
  bool apart = compare_along(g_, p, p.p1, q.p0) <= 0 || compare_along(g_, p, q.p1, p.p0) <= 0;
  if (!apart && runs_right(c_, i) != runs_right(c_, j))
    out_.opposite.push_back(runs_right(c_, i) ? std::pair(i, j) : std::pair(j, i));
  place(i, q.p0);
  place(i, q.p1);
  place(j, p.p0);
  place(j, p.p1);
}

void StopFinder::place(Index i, Index node) {
  const Piece& p = c_.pieces[i];
  const Within where = within(g_, p, node);
  if (where == Within::kInside) touch(i, node);
  if (where == Within::kAtStart && node != p.p0) out_.degenerate_vertices.tie(p.p0, node);
  if (where == Within::kAtEnd && node != p.p1) out_.degenerate_vertices.tie(p.p1, node);
}

void StopFinder::touch(Index i, Index node) {
  out_.degenerate_vertices.make(node);
  out_.stops.push_back({i, node, kNone, false, kNone});
}

void StopSorter::run() {
  group_stops();
  for (Index i = 0; i < size(); ++i)
    if (stop_count(i) > 1) {
      sort_stops_of(i);
      tie_stops_of(i);
    }
  out_.degenerate_vertices.settle(g_.points.size());
  drop_repeated();
  find_twins();
}

void StopSorter::group_stops() {
  out_.first.assign(size() + 1, 0);
  for (const Stop& s : out_.stops) ++out_.first[s.piece + 1];
  for (Index i = 0; i < size(); ++i) out_.first[i + 1] += out_.first[i];
  std::pmr::vector<Stop> grouped(out_.stops.size(), Stop{}, memory_);
  std::pmr::vector<Index> at(out_.first.begin(), out_.first.end() - 1, memory_);
  for (const Stop& s : out_.stops) grouped[at[s.piece]++] = s;
  out_.stops.swap(grouped);
}

void StopSorter::sort_stops_of(Index i) {
  const auto first = out_.stops.begin() + std::ptrdiff_t(out_.first[i]);
  const auto last = out_.stops.begin() + std::ptrdiff_t(out_.first[i + 1]);
  const bool few = stop_count(i) <= kFewStops;
  if (!few) sort_by_estimate(i);
  auto before = [&](const Stop& s, const Stop& t) {
    int order = s.point == t.point ? 0 : compare_along(g_, c_.pieces[i], s.point, t.point);
    if (order == 0) return s.point < t.point;
    return runs_right(c_, i) ? order < 0 : order > 0;
  };
  if (few || !std::is_sorted(first, last, before)) small_sort(first, last, before);
}

void StopSorter::sort_by_estimate(Index i) {
  const exact::Point &from = g_.points[start_of(c_, i)], &to = g_.points[end_of(c_, i)];
  double dx = to.x - from.x, dy = to.y - from.y;
  estimates_.clear();
  for (Index k = out_.first[i]; k < out_.first[i + 1]; ++k) {
    const exact::Point& p = g_.points[out_.stops[k].point];
    estimates_.push_back({p.x * dx + p.y * dy, out_.stops[k]});
  }
  std::sort(estimates_.begin(), estimates_.end(), [](const auto& p, const auto& q) { return p.along < q.along; });
  Index k = out_.first[i];
  for (const Estimate& e : estimates_) out_.stops[k++] = e.stop;
}

void StopSorter::tie_stops_of(Index i) {
  for (Index first = out_.first[i], k = first; k < out_.first[i + 1]; ++k) {
    const Stop& s = out_.stops[first];
    Stop& t = out_.stops[k];
    if (k == first || (s.point != t.point && compare_along(g_, c_.pieces[i], s.point, t.point) != 0)) {
      first = k;
      continue;
    }
    if (!same_meeting(s, t)) out_.degenerate_vertices.tie(s.point, t.point);
    t.piece = kNone;
  }
}

void StopSorter::drop_repeated() {
  Index kept = 0;
  for (Index i = 0; i < size(); ++i) {
    const Index first = out_.first[i], last = out_.first[i + 1];
    out_.first[i] = kept;
    for (Index k = first; k < last; ++k) {
      Stop s = out_.stops[k];
      if (s.piece == kNone) continue;
      if (const Index degenerate = out_.degenerate_vertices.at(s.point); degenerate != kNone) {
        s.other = kNone;
        s.twin = degenerate;
      }
      out_.stops[kept++] = s;
    }
  }
  out_.first[size()] = kept;
  out_.stops.resize(kept);
}

void StopSorter::find_twins() {
  std::pmr::vector<Index> first(g_.points.size(), kNone, memory_);
  for (Index s = 0; s < out_.stops.size(); ++s) {
    if (out_.stops[s].other == kNone) continue;
    Index& other = first[out_.stops[s].point];
    if (other != kNone) {
      out_.stops[s].twin = other - out_.first[out_.stops[other].piece];
      out_.stops[other].twin = s - out_.first[out_.stops[s].piece];
    }
    other = s;
  }
}

}  // namespace

CurveStops find_stops(ReducedConvolution& c, Memory memory) {
  CurveStops out(c.geometry.points.size() + c.pieces.size(), memory);
  out.stops.reserve(c.pieces.size());
  StopFinder finder(c, out);
  CellGrid(c.geometry, c.pieces, {}, memory).pairs([&](Index i, Index j) { finder.cross(i, j); });
  StopSorter(c, out, memory).run();
  return out;
}

}  // namespace findspace::plane
