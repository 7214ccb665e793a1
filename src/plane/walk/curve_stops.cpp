// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "plane/walk/curve_stops.h"

#include <algorithm>

#include "exact/planar/geometry_signs.h"
#include "plane/base/parallel.h"
#include "plane/base/small_sort.h"
#include "plane/complex/broad_phase.h"
#include "plane/complex/piece_meet.h"

namespace findspace::plane {
namespace {

constexpr Index kFewStops = 8;
constexpr std::size_t kManyToMeetAtOnce = 2000;  // from here on strips and ranges of them are worked on at once

/// One crossing, or one degenerate vertex.
bool same_meeting(const Stop& s, const Stop& t) {
  return s.other == t.other && (s.other != kNone || s.point == t.point);
}

/// What is found of some pairs of curves.
struct Found {
  explicit Found(Memory memory) : stops(memory), opposite(memory), ties(memory) {}

  std::pmr::vector<Stop> stops;
  std::pmr::vector<std::pair<Index, Index>> opposite;
  std::pmr::vector<std::pair<Index, Index>> ties;  // points at one place, or one that is a degenerate vertex
};

/// Finds where curves meet, in any order.
class StopFinder {
 public:
  /// Appends crossings to `points`; the first that it appends has the number that the geometry's next point has.
  StopFinder(const DirectedCurves& c, std::vector<exact::Point>& points, Found& out)
      : c_(c), g_(c.geometry), points_(points), before_(c.geometry.points.size() - points.size()), out_(out) {}
  /// Notes where two curves meet.
  void cross(Index i, Index j);

 private:
  /// Two curves on one line.
  void overlap(Index i, Index j);
  /// An end of a curve on the line of curve i.
  void place(Index i, Index node);
  /// The end of a curve lies on curve i.
  void touch(Index i, Index node);

  const DirectedCurves& c_;
  const exact::Geometry& g_;
  std::vector<exact::Point>& points_;  // may be those of the geometry
  const std::size_t before_;           // points that are not among these
  Found& out_;
};

/// Puts stops in order along every curve; what meets at one point becomes a degenerate vertex, or is dropped if it is
/// there twice.
class StopSorter {
 public:
  StopSorter(const DirectedCurves& c, CurveStops& out, Memory memory)
      : c_(c), g_(c.geometry), out_(out), memory_(memory) {}
  void run();

 private:
  struct Estimate {
    double along;  // the curve
    Stop stop;
  };

  using Ties = std::vector<std::pair<Index, Index>>;

  Index size() const { return Index(c_.pieces.size()); }
  Index stop_count(Index i) const { return out_.first[i + 1] - out_.first[i]; }
  void group_stops();
  /// Sorts those of some curves; what is at one place, unless it is one crossing.
  Ties sort_stops(IndexRange curves);
  void sort_stops_of(Index i, std::pmr::vector<Estimate>& estimates);
  /// As nearly as approximate coordinates tell.
  void sort_by_estimate(Index i, std::pmr::vector<Estimate>& estimates);
  void tie_stops_of(Index i, Ties& ties);
  void drop_repeated();
  /// The two stops of a crossing find each other.
  void find_twins();

  const DirectedCurves& c_;
  const exact::Geometry& g_;
  CurveStops& out_;
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
  if (q_end != kNone && p_end != kNone) return void(out_.ties.emplace_back(p_end, q_end));
  if (q_end != kNone) return touch(i, q_end);
  if (p_end != kNone) return touch(j, p_end);
  const auto point = Index(before_ + points_.size());
  points_.push_back(g_.crossing(p.supporting_curve, q.supporting_curve, 0));
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
  if (where == Within::kAtStart && node != p.p0) out_.ties.emplace_back(p.p0, node);
  if (where == Within::kAtEnd && node != p.p1) out_.ties.emplace_back(p.p1, node);
}

void StopFinder::touch(Index i, Index node) {
  out_.ties.emplace_back(node, node);
  out_.stops.push_back({i, node, kNone, false, kNone});
}

void StopSorter::run() {
  group_stops();
  const std::size_t count = range_count(size(), kManyToMeetAtOnce);
  std::vector<Ties> ties(count);
  const auto sort = [&](std::size_t k) { ties[k] = sort_stops(range(k, count, size())); };
  if (count == 1)
    sort(0);
  else
    parallel_for(count, sort);
  for (const Ties& part : ties)
    for (const auto& [p, q] : part) out_.degenerate_vertices.tie(p, q);
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

StopSorter::Ties StopSorter::sort_stops(IndexRange curves) {
  Ties ties;
  std::pmr::vector<Estimate> estimates;
  for (auto i = Index(curves.first); i < curves.end; ++i) {
    if (stop_count(i) < 2) continue;
    sort_stops_of(i, estimates);
    tie_stops_of(i, ties);
  }
  return ties;
}

void StopSorter::sort_stops_of(Index i, std::pmr::vector<Estimate>& estimates) {
  const auto first = out_.stops.begin() + std::ptrdiff_t(out_.first[i]);
  const auto last = out_.stops.begin() + std::ptrdiff_t(out_.first[i + 1]);
  const bool few = stop_count(i) <= kFewStops;
  if (!few) sort_by_estimate(i, estimates);
  auto before = [&](const Stop& s, const Stop& t) {
    int order = s.point == t.point ? 0 : compare_along(g_, c_.pieces[i], s.point, t.point);
    if (order == 0) return s.point < t.point;
    return runs_right(c_, i) ? order < 0 : order > 0;
  };
  if (few || !std::is_sorted(first, last, before)) small_sort(first, last, before);
}

void StopSorter::sort_by_estimate(Index i, std::pmr::vector<Estimate>& estimates) {
  const exact::Point &from = g_.points[start_of(c_, i)], &to = g_.points[end_of(c_, i)];
  double dx = to.x - from.x, dy = to.y - from.y;
  estimates.clear();
  for (Index k = out_.first[i]; k < out_.first[i + 1]; ++k) {
    const exact::Point& p = g_.points[out_.stops[k].point];
    estimates.push_back({p.x * dx + p.y * dy, out_.stops[k]});
  }
  std::sort(estimates.begin(), estimates.end(), [](const auto& p, const auto& q) { return p.along < q.along; });
  Index k = out_.first[i];
  for (const Estimate& e : estimates) out_.stops[k++] = e.stop;
}

void StopSorter::tie_stops_of(Index i, Ties& ties) {
  for (Index first = out_.first[i], k = first; k < out_.first[i + 1]; ++k) {
    const Stop& s = out_.stops[first];
    Stop& t = out_.stops[k];
    if (k == first || (s.point != t.point && compare_along(g_, c_.pieces[i], s.point, t.point) != 0)) {
      first = k;
      continue;
    }
    if (!same_meeting(s, t)) ties.emplace_back(s.point, t.point);
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

/// Strips of the grid at once where there are many curves; the same as one after the other.
Found find_meetings(DirectedCurves& c, Memory memory) {
  Found all(memory);
  std::vector<exact::Point>& points = c.geometry.points;
  const CellGrid grid(c.geometry, c.pieces, {}, memory);
  const std::size_t count = range_count(c.pieces.size(), kManyToMeetAtOnce);
  if (count == 1) {
    all.stops.reserve(c.pieces.size());
    StopFinder finder(c, points, all);
    grid.pairs([&](Index i, Index j) { finder.cross(i, j); });
    return all;
  }
  const std::vector<IndexRange> strips = grid.strips(count);
  std::vector<Found> found(count, Found(std::pmr::new_delete_resource()));
  std::vector<std::vector<exact::Point>> made(count);
  parallel_for(count, [&](std::size_t k) {
    StopFinder finder(c, made[k], found[k]);
    grid.pairs(strips[k], [&](Index i, Index j) { finder.cross(i, j); });
  });
  const std::size_t first = points.size();
  for (std::size_t k = 0; k < count; ++k) {
    const auto further = Index(points.size() - first);
    points.insert(points.end(), made[k].begin(), made[k].end());
    for (Stop s : found[k].stops) {
      if (s.point >= first) s.point += further;
      all.stops.push_back(s);
    }
    all.opposite.insert(all.opposite.end(), found[k].opposite.begin(), found[k].opposite.end());
    all.ties.insert(all.ties.end(), found[k].ties.begin(), found[k].ties.end());
  }
  return all;
}

/// Puts what was found in order.
CurveStops in_order(const DirectedCurves& c, Found found, Memory memory) {
  CurveStops out(c.geometry.points.size() + c.pieces.size(), memory);
  for (const auto& [p, q] : found.ties) out.degenerate_vertices.tie(p, q);
  out.stops = std::move(found.stops);
  out.opposite = std::move(found.opposite);
  StopSorter(c, out, memory).run();
  return out;
}

}  // namespace

CurveStops find_stops(DirectedCurves& c, Memory memory) { return in_order(c, find_meetings(c, memory), memory); }

CurveStops find_stops(DirectedCurves& c, std::span<const std::pair<Index, Index>> pairs, Memory memory) {
  Found found(memory);
  StopFinder finder(c, c.geometry.points, found);
  for (const auto& [i, j] : pairs) finder.cross(i, j);
  return in_order(c, std::move(found), memory);
}

}  // namespace findspace::plane
