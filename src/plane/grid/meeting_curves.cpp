// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/grid/meeting_curves.h"

#include <algorithm>

#include "plane/base/small_sort.h"
#include "plane/complex/broad_phase.h"
#include "plane/complex/piece_meet.h"

namespace findspace::plane {
namespace {

constexpr Index kFewStops = 8;

/// One crossing, or one degenerate.
bool same_meeting(const Stop& s, const Stop& t) {
  return s.other == t.other && (s.other != kNone || s.point == t.point);
}

}  // namespace

MeetingCurves::MeetingCurves(ReducedConvolution& c, Memory memory)
    : c_(c),
      g_(c.geometry),
      stops_(memory),
      estimates_(memory),
      first_stop_(memory),
      ends_at_(g_.points.size(), kNone, memory),
      opposite_(memory),
      degenerate_vertices_(g_.points.size() + size(), memory),
      memory_(memory) {
  for (Index i = 0; i < size(); ++i) ends_at_[end(i)] = i;
  stops_.reserve(size());
  CellGrid(g_, c_.pieces, {}, memory_).pairs([&](Index i, Index j) { cross(i, j); });
  sort_stops();
  if (!degenerate_vertices_.empty()) add_directed_edges();
}

void MeetingCurves::cross(Index i, Index j) {
  const Piece &p = c_.pieces[i], &q = c_.pieces[j];
  const exact::SupportingCurve &k = g_.supporting_curves[p.supporting_curve],
                               &l = g_.supporting_curves[q.supporting_curve];
  if (p.p0 == q.p1 || p.p1 == q.p0) return;
  if (k.a == l.a && k.b == l.b) return k.c == l.c ? overlap(i, j) : void();
  if (p.p0 == q.p0 || p.p1 == q.p1) return;
  int s0 = g_.side(q.p0, p.supporting_curve), s1 = g_.side(q.p1, p.supporting_curve);
  if (s0 * s1 > 0) return;
  int t0 = g_.side(p.p0, q.supporting_curve), t1 = g_.side(p.p1, q.supporting_curve);
  if (t0 * t1 > 0) return;
  Index q_end = s0 == 0 ? q.p0 : s1 == 0 ? q.p1 : kNone, p_end = t0 == 0 ? p.p0 : t1 == 0 ? p.p1 : kNone;
  if (q_end != kNone && p_end != kNone) return degenerate_vertices_.tie(p_end, q_end);
  if (q_end != kNone) return touch(i, q_end);
  if (p_end != kNone) return touch(j, p_end);
  Index point = g_.add_crossing(p.supporting_curve, q.supporting_curve, 0);
  // The normal (a, b) is to the left of the direction (b, -a), the way to the right if b > 0.
  bool normal_left = (k.b > 0) == right(i);
  bool from_right = ((right(j) ? s0 : s1) > 0) != normal_left;
  stops_.push_back({i, point, j, from_right, kNone});
  stops_.push_back({j, point, i, !from_right, kNone});
}

void MeetingCurves::overlap(Index i, Index j) {
  const Piece &p = c_.pieces[i], &q = c_.pieces[j];
  bool apart = compare_along(g_, p, p.p1, q.p0) <= 0 || compare_along(g_, p, q.p1, p.p0) <= 0;
  if (!apart && right(i) != right(j)) opposite_.push_back(right(i) ? std::pair(i, j) : std::pair(j, i));
  place(i, q.p0);
  place(i, q.p1);
  place(j, p.p0);
  place(j, p.p1);
}

void MeetingCurves::place(Index i, Index node) {
  const Piece& p = c_.pieces[i];
  const Within where = within(g_, p, node);
  if (where == Within::kInside) touch(i, node);
  if (where == Within::kAtStart && node != p.p0) degenerate_vertices_.tie(p.p0, node);
  if (where == Within::kAtEnd && node != p.p1) degenerate_vertices_.tie(p.p1, node);
}

void MeetingCurves::touch(Index i, Index node) {
  degenerate_vertices_.make(node);
  stops_.push_back({i, node, kNone, false, kNone});
}

void MeetingCurves::sort_stops() {
  group_stops();
  for (Index i = 0; i < size(); ++i)
    if (stop_count(i) > 1) {
      sort_stops_of(i);
      tie_stops_of(i);
    }
  degenerate_vertices_.settle(g_.points.size());
  drop_repeated();
  find_twins();
}

void MeetingCurves::group_stops() {
  first_stop_.assign(size() + 1, 0);
  for (const Stop& s : stops_) ++first_stop_[s.piece + 1];
  for (Index i = 0; i < size(); ++i) first_stop_[i + 1] += first_stop_[i];
  std::pmr::vector<Stop> grouped(stops_.size(), Stop{}, memory_);
  std::pmr::vector<Index> at(first_stop_.begin(), first_stop_.end() - 1, memory_);
  for (const Stop& s : stops_) grouped[at[s.piece]++] = s;
  stops_.swap(grouped);
}

void MeetingCurves::sort_stops_of(Index i) {
  const auto first = stops_.begin() + std::ptrdiff_t(first_stop_[i]);
  const auto last = stops_.begin() + std::ptrdiff_t(first_stop_[i + 1]);
  const bool few = stop_count(i) <= kFewStops;
  if (!few) sort_by_estimate(i);
  auto before = [&](const Stop& s, const Stop& t) {
    int order = s.point == t.point ? 0 : compare_along(g_, c_.pieces[i], s.point, t.point);
    if (order == 0) return s.point < t.point;
    return right(i) ? order < 0 : order > 0;
  };
  if (few || !std::is_sorted(first, last, before)) small_sort(first, last, before);
}

void MeetingCurves::sort_by_estimate(Index i) {
  const exact::Point &from = g_.points[start(i)], &to = g_.points[end(i)];
  double dx = to.x - from.x, dy = to.y - from.y;
  estimates_.clear();
  for (Index k = first_stop_[i]; k < first_stop_[i + 1]; ++k) {
    const exact::Point& p = g_.points[stops_[k].point];
    estimates_.push_back({p.x * dx + p.y * dy, stops_[k]});
  }
  std::sort(estimates_.begin(), estimates_.end(), [](const auto& p, const auto& q) { return p.along < q.along; });
  Index k = first_stop_[i];
  for (const Estimate& e : estimates_) stops_[k++] = e.stop;
}

void MeetingCurves::tie_stops_of(Index i) {
  for (Index first = first_stop_[i], k = first; k < first_stop_[i + 1]; ++k) {
    const Stop& s = stops_[first];
    Stop& t = stops_[k];
    if (k == first || (s.point != t.point && compare_along(g_, c_.pieces[i], s.point, t.point) != 0)) {
      first = k;
      continue;
    }
    if (!same_meeting(s, t)) degenerate_vertices_.tie(s.point, t.point);
    t.piece = kNone;
  }
}

void MeetingCurves::drop_repeated() {
  Index kept = 0;
  for (Index i = 0; i < size(); ++i) {
    const Index first = first_stop_[i], last = first_stop_[i + 1];
    first_stop_[i] = kept;
    for (Index k = first; k < last; ++k) {
      Stop s = stops_[k];
      if (s.piece == kNone) continue;
      if (const Index degenerate = degenerate_vertices_.at(s.point); degenerate != kNone) {
        s.other = kNone;
        s.twin = degenerate;
      }
      stops_[kept++] = s;
    }
  }
  first_stop_[size()] = kept;
  stops_.resize(kept);
}

void MeetingCurves::find_twins() {
  std::pmr::vector<Index> first(g_.points.size(), kNone, memory_);
  for (Index s = 0; s < stops_.size(); ++s) {
    if (stops_[s].other == kNone) continue;
    Index& other = first[stops_[s].point];
    if (other != kNone) {
      stops_[s].twin = other - first_stop_[stops_[other].piece];
      stops_[other].twin = s - first_stop_[stops_[s].piece];
    }
    other = s;
  }
}

void MeetingCurves::add_directed_edges() {
  degenerate_vertices_.reserve(2 * stops_.size() + 2 * size());
  for (Index i = 0; i < size(); ++i) {
    const InnerSide& side = c_.sides[i];
    if (const Index from = degenerate_vertices_.at(start(i)); from != kNone)
      degenerate_vertices_.add(directed_edge(from, {i, 0}, true, right(i) ? side.hides_at_p0 : side.hides_at_p1));
    if (const Index to = degenerate_vertices_.at(end(i)); to != kNone)
      degenerate_vertices_.add(
          directed_edge(to, {i, stop_count(i)}, false, right(i) ? side.hides_at_p1 : side.hides_at_p0));
    for (Index k = 0; k < stop_count(i); ++k) {
      if (stop(i, k).other != kNone) continue;
      degenerate_vertices_.add(directed_edge(stop(i, k).twin, {i, k}, false, true));
      degenerate_vertices_.add(directed_edge(stop(i, k).twin, {i, k + 1}, true, true));
    }
  }
}

DirectedEdge MeetingCurves::directed_edge(Index degenerate, CurvePart part, bool starts, bool hides) const {
  const exact::SupportingCurve& k = g_.supporting_curves[supporting_curve(part.curve)];
  // To the right along a*x + b*y = c: (b, -a) or its opposite.
  const bool forward = ((k.b > 0) == right(part.curve)) == starts;
  return {.degenerate = degenerate,
          .curve = part.curve,
          .slot = part.slot,
          .starts = starts,
          .hides = hides,
          .dx = forward ? k.b : -k.b,
          .dy = forward ? -k.a : k.a};
}

std::pmr::vector<CurvePart> MeetingCurves::parts_with_two_inner_sides() const {
  std::pmr::vector<CurvePart> found(memory_);
  for (const auto& both : opposite_) {
    auto on_other = [&](Index point) { return within(g_, c_.pieces[both.second], point) != Within::kOutside; };
    for (CurvePart p{both.first, 0}; p.slot <= stop_count(p.curve); ++p.slot)
      if (on_other(start(p)) && on_other(end(p))) found.push_back(p);
  }
  return found;
}

}  // namespace findspace::plane
