// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "plane/walk/curve_stops.h"

#include <algorithm>
#include <optional>

#include "exact/planar/geometry_signs.h"
#include "exact/planar/segment_sides.h"
#include "plane/base/parallel.h"
#include "plane/base/small_sort.h"
#include "plane/complex/broad_phase.h"
#include "plane/complex/piece_meet.h"

namespace findspace::plane {
namespace {

constexpr Index kFewStops = 8;
// From here on work is divided: curves, and pairs that share a cell as their strips count them; stops. Less gains
// nothing where processors share no cache.
constexpr std::size_t kManyToMeet = 2000, kManyToCompare = 120'000, kManyStops = 6000;

/// One crossing, or one degenerate vertex.
bool same_meeting(const Stop& s, const Stop& t) {
  return s.other == t.other && (s.other != kNone || s.point == t.point);
}

/// What is found of some pairs of curves.
struct Found {
  explicit Found(Memory memory) : stops(memory), opposite(memory), ties(memory) {}

  ArenaVector<Stop> stops;
  ArenaVector<std::pair<Index, Index>> opposite;
  ArenaVector<std::pair<Index, Index>> ties;  // points at one place, or one that is a degenerate vertex
};

/// Finds where curves meet, in any order.
class StopFinder {
 public:
  /// Appends crossings to `points`; the first that it appends has the number that the geometry's next point has.
  StopFinder(const DirectedCurves& c, std::vector<exact::Point>& points, Found& out)
      : c_(c),
        g_(c.geometry),
        points_(points),
        before_(c.geometry.points.size() - points.size()),
        narrow_(std::all_of(g_.points.begin(), g_.points.end(), exact::has_narrow_sides)),
        out_(out) {}
  /// Notes where two curves meet.
  void cross(Index i, Index j);

 private:
  exact::SegmentSides<int> sides_by_lines(const Piece& p, const Piece& q) const;
  template <class Integer>
  void meet(Index i, Index j, const exact::SegmentSides<Integer>& sides);
  template <class Integer>
  exact::Point crossing(const Piece& p, const Piece& q, const exact::SegmentSides<Integer>& sides) const;
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
  const bool narrow_;                  // all ends of curves have narrow sides
  Found& out_;
};

/// Puts stops in order along every curve; what meets at one point becomes a degenerate vertex, or is dropped if it is
/// there twice.
class StopSorter {
 public:
  StopSorter(const DirectedCurves& c, std::span<const Found> found, CurveStops& out, Memory memory)
      : c_(c),
        g_(c.geometry),
        found_(found),
        out_(out),
        memory_(memory),
        ranges_(range_count(found_stops(), kManyStops)) {}
  /// `known`: points of the geometry that are not made of crossings.
  void run(std::size_t known);

 private:
  struct Estimate {
    double along;  // the curve
    Stop stop;
  };

  struct Sorted {
    std::vector<std::pair<Index, Index>> ties;  // what is at one place, unless it is one crossing
    std::size_t repeated = 0;
  };

  Index size() const { return Index(c_.pieces.size()); }
  Index stop_count(Index i) const { return out_.first[i + 1] - out_.first[i]; }
  std::size_t found_stops() const {
    std::size_t stops = 0;
    for (const Found& part : found_) stops += part.stops.size();
    return stops;
  }
  void group_stops();
  void put_stops(IndexRange curves);
  void sort_all();
  Sorted sort_stops(IndexRange curves);
  /// Whether all are known to be at different places.
  bool sort_stops_of(Index i, ArenaVector<Estimate>& estimates);
  /// As nearly as approximate coordinates tell.
  void sort_by_estimate(Index i, ArenaVector<Estimate>& estimates);
  void tie_stops_of(Index i, Sorted& out);
  void drop_repeated();
  void mark_degenerate();
  /// The two stops of a crossing find each other.
  void find_twins(std::size_t known);
  /// Calls visit(stop) for all, those of ranges of curves at once.
  template <class Visit>
  void each_stop(Visit&& visit);

  const DirectedCurves& c_;
  const exact::Geometry& g_;
  std::span<const Found> found_;
  CurveStops& out_;
  Memory memory_;
  const std::size_t ranges_;  // of curves
};

void StopFinder::cross(Index i, Index j) {
  const Piece &p = c_.pieces[i], &q = c_.pieces[j];
  if (p.p0 == q.p1 || p.p1 == q.p0) return;
  const exact::Point *points = g_.points.data(), &p0 = points[p.p0], &p1 = points[p.p1], &q0 = points[q.p0],
                     &q1 = points[q.p1];
  if (narrow_) return meet(i, j, exact::segment_sides<std::int64_t>(p0, p1, q0, q1));
  constexpr auto kGrid = exact::Point::Kind::kGrid;
  if (p0.kind == kGrid && p1.kind == kGrid && q0.kind == kGrid && q1.kind == kGrid)
    return meet(i, j, exact::segment_sides<exact::int128>(p0, p1, q0, q1));
  meet(i, j, sides_by_lines(p, q));
}

exact::SegmentSides<int> StopFinder::sides_by_lines(const Piece& p, const Piece& q) const {
  const exact::SupportingCurve &k = g_.supporting_curves[p.supporting_curve],
                               &l = g_.supporting_curves[q.supporting_curve];
  if (k.a == l.a && k.b == l.b) {
    const int side = k.c == l.c ? 0 : 1;
    return {side, side, side, side, true};
  }
  // The normal (a, b) is to the left of the direction (b, -a), which is that of a segment if b > 0.
  const int left_of_p = k.b > 0 ? 1 : -1, left_of_q = l.b > 0 ? 1 : -1;
  return {left_of_p * side(g_, q.p0, p.supporting_curve), left_of_p * side(g_, q.p1, p.supporting_curve),
          left_of_q * side(g_, p.p0, q.supporting_curve), left_of_q * side(g_, p.p1, q.supporting_curve), false};
}

template <class Integer>
void StopFinder::meet(Index i, Index j, const exact::SegmentSides<Integer>& sides) {
  const Piece &p = c_.pieces[i], &q = c_.pieces[j];
  if (sides.parallel) return sides.q0 == 0 ? overlap(i, j) : void();
  if (sides.apart() || p.p0 == q.p0 || p.p1 == q.p1) return;
  const Index q_end = sides.q0 == 0 ? q.p0 : sides.q1 == 0 ? q.p1 : kNone;
  const Index p_end = sides.p0 == 0 ? p.p0 : sides.p1 == 0 ? p.p1 : kNone;
  if (q_end != kNone && p_end != kNone) return void(out_.ties.emplace_back(p_end, q_end));
  if (q_end != kNone) return touch(i, q_end);
  if (p_end != kNone) return touch(j, p_end);
  const auto point = Index(before_ + points_.size());
  points_.push_back(crossing(p, q, sides));
  const bool starts_left = (runs_right(c_, j) ? sides.q0 : sides.q1) > 0, from_right = starts_left != runs_right(c_, i);
  out_.stops.emplace_back(i, point, j, from_right);
  out_.stops.emplace_back(j, point, i, !from_right);
}

template <class Integer>
exact::Point StopFinder::crossing(const Piece& p, const Piece& q, const exact::SegmentSides<Integer>& sides) const {
  const Index i = p.supporting_curve, j = q.supporting_curve;
  if (c_.unreduced) return rough_crossing(i, j, g_.points[p.p0], g_.points[p.p1], sides);
  return g_.crossing(i, j, 0);
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
  out_.stops.emplace_back(i, node, kNone, false);
}

void StopSorter::run(std::size_t known) {
  group_stops();
  if (!out_.stops.empty()) sort_all();
  out_.degenerate_vertices.settle(g_.points.size());
  if (!out_.degenerate_vertices.empty()) mark_degenerate();
  if (known < g_.points.size()) find_twins(known);
}

void StopSorter::sort_all() {
  std::size_t repeated = 0;
  const auto note = [&](const Sorted& part) {
    for (const auto& [p, q] : part.ties) out_.degenerate_vertices.tie(p, q);
    repeated += part.repeated;
  };
  if (ranges_ == 1) {
    note(sort_stops({0, size()}));
  } else {
    std::vector<Sorted> sorted(ranges_);
    parallel_for(ranges_, [&](std::size_t k) { sorted[k] = sort_stops(range(k, ranges_, size())); });
    for (const Sorted& part : sorted) note(part);
  }
  if (repeated > 0) drop_repeated();
}

/// In the order in which they were found. One thread counts them, and each of two looks at all and puts down those of
/// its own curves: what several put down here and there would have to go from one processor to the other.
void StopSorter::group_stops() {
  out_.first.assign(size() + 1, 0);
  for (const Found& part : found_)
    for (const Stop& s : part.stops) ++out_.first[s.piece];
  Index end = 0;
  for (Index& first : out_.first) first = end += first;
  out_.stops.resize(end);
  const std::size_t halves = ranges_ == 1 ? 1 : 2;
  each_range(halves, [&](std::size_t k) { put_stops(range(k, halves, size())); });
}

/// Of some curves, from their last places on.
void StopSorter::put_stops(IndexRange curves) {
  for (std::size_t part = found_.size(); part-- > 0;) {
    const ArenaVector<Stop>& stops = found_[part].stops;
    for (std::size_t k = stops.size(); k-- > 0;)
      if (const Index i = stops[k].piece; curves.first <= i && i < curves.end) out_.stops[--out_.first[i]] = stops[k];
  }
}

StopSorter::Sorted StopSorter::sort_stops(IndexRange curves) {
  Sorted out;
  ArenaVector<Estimate> estimates;
  const Index* const first = out_.first.data();
  for (auto i = Index(curves.first); i < curves.end; ++i)
    if (first[i + 1] - first[i] > 1 && !sort_stops_of(i, estimates)) tie_stops_of(i, out);
  return out;
}

bool StopSorter::sort_stops_of(Index i, ArenaVector<Estimate>& estimates) {
  const auto first = out_.stops.begin() + std::ptrdiff_t(out_.first[i]);
  const auto last = out_.stops.begin() + std::ptrdiff_t(out_.first[i + 1]);
  const bool few = stop_count(i) <= kFewStops;
  if (!few) sort_by_estimate(i, estimates);
  bool apart = few;  // few are inserted, and what is inserted at the place of another one is compared with one there
  auto before = [&](const Stop& s, const Stop& t) {
    int order = s.point == t.point ? 0 : compare_along(g_, c_.pieces[i], s.point, t.point);
    apart &= order != 0;
    if (order == 0) return s.point < t.point;
    return runs_right(c_, i) ? order < 0 : order > 0;
  };
  if (few || !std::is_sorted(first, last, before)) small_sort(first, last, before);
  return apart;
}

void StopSorter::sort_by_estimate(Index i, ArenaVector<Estimate>& estimates) {
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

void StopSorter::tie_stops_of(Index i, Sorted& out) {
  for (Index first = out_.first[i], k = first; k < out_.first[i + 1]; ++k) {
    const Stop& s = out_.stops[first];
    Stop& t = out_.stops[k];
    if (k == first || (s.point != t.point && compare_along(g_, c_.pieces[i], s.point, t.point) != 0)) {
      first = k;
      continue;
    }
    if (!same_meeting(s, t)) out.ties.emplace_back(s.point, t.point);
    t.piece = kNone;
    ++out.repeated;
  }
}

void StopSorter::drop_repeated() {
  Index kept = 0;
  for (Index i = 0; i < size(); ++i) {
    const Index first = out_.first[i], last = out_.first[i + 1];
    out_.first[i] = kept;
    for (Index k = first; k < last; ++k)
      if (out_.stops[k].piece != kNone) out_.stops[kept++] = out_.stops[k];
  }
  out_.first[size()] = kept;
  out_.stops.resize(kept);
}

template <class Visit>
void StopSorter::each_stop(Visit&& visit) {
  each_range(ranges_, [&](std::size_t k) {
    const IndexRange curves = range(k, ranges_, size());
    for (Index s = out_.first[curves.first]; s < out_.first[curves.end]; ++s) visit(s);
  });
}

void StopSorter::mark_degenerate() {
  each_stop([&](Index at) {
    Stop& s = out_.stops[at];
    const Index degenerate = out_.degenerate_vertices.at(s.point);
    if (degenerate == kNone) return;
    s.other = kNone;
    s.twin = degenerate;
  });
}

void StopSorter::find_twins(std::size_t known) {
  // Of each point made of a crossing, the stop of the curve with less number.
  ArenaVector<Index> first(g_.points.size() - known, kNone, memory_);
  each_stop([&](Index at) {
    const Stop& s = out_.stops[at];
    if (s.other != kNone && s.piece < s.other) first[s.point - known] = at;
  });
  each_stop([&](Index at) {
    Stop& s = out_.stops[at];
    if (s.other == kNone || s.piece < s.other) return;
    const Index other = first[s.point - known];
    Stop& twin = out_.stops[other];
    s.twin = other - out_.first[twin.piece];
    twin.twin = at - out_.first[s.piece];
  });
}

/// About twice the pairs in the cells, one with itself among them.
std::size_t pairs_at_most(const CellGrid& grid) {
  const Index last_column = grid.column(exact::kInfinity), last_row = grid.row(exact::kInfinity);
  std::size_t pairs = 0;
  for (Index c = 0; c <= last_column; ++c)
    for (Index r = 0; r <= last_row; ++r) pairs += grid.cell(c, r).size() * grid.cell(c, r).size();
  return pairs;
}

std::size_t strip_count(const CellGrid& grid, std::size_t curves) {
  return range_count(curves, kManyToMeet) == 1 ? 1 : range_count(pairs_at_most(grid), kManyToCompare);
}

/// Of strips of the grid at once; the same as one after the other.
ArenaVector<Found> find_meetings(DirectedCurves& c, const CellGrid& grid, std::size_t count, Memory memory) {
  std::vector<exact::Point>& points = c.geometry.points;
  const std::vector<IndexRange> strips = grid.strips(count);
  ArenaVector<Found> found(memory);
  for (std::size_t k = 0; k < count; ++k) found.emplace_back(kHeap);
  std::vector<std::vector<exact::Point>> made(count);
  parallel_for(count, [&](std::size_t k) {
    StopFinder finder(c, made[k], found[k]);
    grid.pairs(strips[k], [&](Index i, Index j) { finder.cross(i, j); });
  });
  const std::size_t known = points.size();
  std::vector<std::size_t> first(count);  // of each strip the first of its points
  std::size_t all = known;
  for (std::size_t k = 0; k < count; ++k) {
    first[k] = all;
    all += made[k].size();
  }
  points.resize(all);
  parallel_for(count, [&](std::size_t k) {
    std::copy(made[k].begin(), made[k].end(), points.begin() + std::ptrdiff_t(first[k]));
    made[k] = {};
    for (Stop& s : found[k].stops)
      if (s.point >= known) s.point += Index(first[k] - known);
  });
  return found;
}

/// Puts what was found in order. `known`: points of the geometry that are not made of crossings.
CurveStops in_order(const DirectedCurves& c, std::span<const Found> found, std::size_t known, Memory memory) {
  CurveStops out(c.geometry.points.size() + c.pieces.size(), memory);
  for (const Found& part : found) {
    for (const auto& [p, q] : part.ties) out.degenerate_vertices.tie(p, q);
    out.opposite.insert(out.opposite.end(), part.opposite.begin(), part.opposite.end());
  }
  StopSorter(c, found, out, memory).run(known);
  return out;
}

}  // namespace

CurveStops find_stops(DirectedCurves& c, Memory memory) {
  const std::size_t known = c.geometry.points.size();
  std::optional<CellGrid> grid(std::in_place, c.geometry, c.pieces, std::span<const Index>(), memory);
  if (const std::size_t count = strip_count(*grid, c.pieces.size()); count > 1) {
    const ArenaVector<Found> found = find_meetings(c, *grid, count, memory);
    grid.reset();
    return in_order(c, found, known, memory);
  }
  Found found(memory);
  found.stops.reserve(c.pieces.size());
  StopFinder finder(c, c.geometry.points, found);
  grid->pairs([&](Index i, Index j) { finder.cross(i, j); });
  grid.reset();
  return in_order(c, std::span(&found, 1), known, memory);
}

CurveStops find_stops(DirectedCurves& c, std::span<const std::pair<Index, Index>> pairs, Memory memory) {
  const std::size_t known = c.geometry.points.size();
  Found found(memory);
  found.stops.reserve(c.pieces.size());
  StopFinder finder(c, c.geometry.points, found);
  for (const auto& [i, j] : pairs) finder.cross(i, j);
  return in_order(c, std::span(&found, 1), known, memory);
}

}  // namespace findspace::plane
