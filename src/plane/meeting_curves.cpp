// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/meeting_curves.h"

#include <algorithm>
#include <numeric>

#include "plane/broad_phase.h"
#include "plane/piece_meet.h"
#include "plane/small_sort.h"

namespace findspace::plane {
namespace {

constexpr Index kFewStops = 8;

}  // namespace

bool MeetingCurves::cross_all() {
  ends_at_.assign(g_.points.size(), kNone);
  starts_at_.assign(g_.points.size(), kNone);
  for (Index i = 0; i < size(); ++i) ends_at_[end(i)] = starts_at_[start(i)] = i;
  if (!meet_all() || !sort_stops()) return false;
  tie_knots();
  return true;
}

const Arm& MeetingCurves::clockwise(Index knot, Index i, Index slot) const {
  const Arm* best = nullptr;
  for (const Arm& arm : arms_) {
    if (arm.knot != knot || (arm.starts && arm.curve == i && arm.slot == slot)) continue;
    if (!best || comes_first(i, arm, *best)) best = &arm;
  }
  return *best;
}

bool MeetingCurves::meet_all() {
  CellGrid grid(g_, c_.pieces, {}, memory_);
  bool good = true;
  grid.pairs([&](Index i, Index j) { good = good && cross(i, j); });
  return good;
}

bool MeetingCurves::cross(Index i, Index j) {
  const Piece &p = c_.pieces[i], &q = c_.pieces[j];
  const exact::Carrier &k = g_.carriers[p.carrier], &l = g_.carriers[q.carrier];
  bool parallel = k.a == l.a && k.b == l.b;
  if (p.p0 == q.p1 || p.p1 == q.p0) return true;
  if (parallel) return k.c != l.c || overlap(i, j);
  if (p.p0 == q.p0 || p.p1 == q.p1) return true;
  int s0 = g_.side(q.p0, p.carrier), s1 = g_.side(q.p1, p.carrier);
  if (s0 * s1 > 0) return true;
  int t0 = g_.side(p.p0, q.carrier), t1 = g_.side(p.p1, q.carrier);
  if (t0 * t1 > 0) return true;
  Index q_end = s0 == 0 ? q.p0 : s1 == 0 ? q.p1 : kNone, p_end = t0 == 0 ? p.p0 : t1 == 0 ? p.p1 : kNone;
  if (q_end != kNone && p_end != kNone) return join(p_end, q_end);
  if (q_end != kNone) return touch(i, q_end);
  if (p_end != kNone) return touch(j, p_end);
  Index point = g_.add_crossing(p.carrier, q.carrier, 0);
  // The normal (a, b) is to the left of the direction (b, -a), the way to the right if b > 0.
  bool normal_left = (k.b > 0) == right(i);
  bool from_right = ((right(j) ? s0 : s1) > 0) != normal_left;
  stops_.push_back({i, point, j, from_right, kNone});
  stops_.push_back({j, point, i, !from_right, kNone});
  return true;
}

bool MeetingCurves::overlap(Index i, Index j) {
  const Piece &p = c_.pieces[i], &q = c_.pieces[j];
  bool apart = compare_along(g_, p, p.p1, q.p0) <= 0 || compare_along(g_, p, q.p1, p.p0) <= 0;
  if (!apart && right(i) != right(j)) return false;
  return place(i, q.p0) && place(i, q.p1) && place(j, p.p0) && place(j, p.p1);
}

bool MeetingCurves::place(Index i, Index node) {
  const Piece& p = c_.pieces[i];
  switch (within(g_, p, node)) {
    case Within::kOutside:
      return true;
    case Within::kInside:
      return touch(i, node);
    case Within::kAtStart:
      return node == p.p0 || join(p.p0, node);
    default:
      return node == p.p1 || join(p.p1, node);
  }
}

bool MeetingCurves::make_knot(Index node) {
  if (knot_of_.empty()) knot_of_.assign(ends_at_.size(), kNone);
  if (knot_of_[node] == kNone) knot_of_[node] = knots_++;
  return knots_ <= kMostKnots;
}

bool MeetingCurves::touch(Index i, Index node) {
  if (!make_knot(node)) return false;
  for (const Stop& s : stops_)
    if (s.piece == i && s.point == node) return true;
  stops_.push_back({i, node, kNone, false, kNone});
  return true;
}

bool MeetingCurves::join(Index p, Index q) {
  if (!make_knot(p) || !make_knot(q)) return false;
  Index kept = knot_of_[p], other = knot_of_[q];
  if (kept != other)
    for (Index& k : knot_of_)
      if (k == other) k = kept;
  return true;
}

bool MeetingCurves::sort_stops() {
  for (Stop& s : stops_)
    if (s.other == kNone) s.twin = knot_of_[s.point];
  first_stop_.assign(size() + 1, 0);
  for (const Stop& s : stops_) ++first_stop_[s.piece + 1];
  for (Index i = 0; i < size(); ++i) first_stop_[i + 1] += first_stop_[i];
  std::pmr::vector<Stop> sorted(stops_.size(), Stop{}, memory_);
  std::pmr::vector<Index> at(first_stop_.begin(), first_stop_.end() - 1, memory_);
  for (const Stop& s : stops_) sorted[at[s.piece]++] = s;
  stops_.swap(sorted);
  // Pairs may come twice, and several ends of a knot may touch one curve: each is one stop.
  Index kept = 0;
  for (Index i = 0; i < size(); ++i) {
    Index first = first_stop_[i], last = first_stop_[i + 1];
    first_stop_[i] = kept;
    sort_stops_of(i, first, last);
    for (Index k = first; k < last; ++k) {
      const Stop s = stops_[k];
      bool fresh = kept == first_stop_[i] || compare_along(g_, c_.pieces[i], s.point, stops_[kept - 1].point) != 0;
      if (!fresh && !same_place(s, stops_[kept - 1])) return false;
      if (fresh) stops_[kept++] = s;
    }
  }
  first_stop_[size()] = kept;
  stops_.resize(kept);
  find_twins();
  return true;
}

void MeetingCurves::sort_stops_of(Index i, Index first, Index last) {
  if (last - first > kFewStops) sort_by_estimate(i, first, last);
  auto before = [&](const Stop& s, const Stop& t) {
    int order = s.point == t.point ? 0 : compare_along(g_, c_.pieces[i], s.point, t.point);
    if (order == 0) return s.point < t.point;
    return right(i) ? order < 0 : order > 0;
  };
  auto at = [&](Index k) { return stops_.begin() + std::ptrdiff_t(k); };
  if (last - first <= kFewStops || !std::is_sorted(at(first), at(last), before))
    small_sort(at(first), at(last), before);
}

void MeetingCurves::sort_by_estimate(Index i, Index first, Index last) {
  const exact::Point &from = g_.points[start(i)], &to = g_.points[end(i)];
  double dx = to.x - from.x, dy = to.y - from.y;
  estimates_.clear();
  for (Index k = first; k < last; ++k) {
    const exact::Point& p = g_.points[stops_[k].point];
    estimates_.push_back({p.x * dx + p.y * dy, stops_[k]});
  }
  std::sort(estimates_.begin(), estimates_.end(), [](const auto& p, const auto& q) { return p.along < q.along; });
  for (const Estimate& e : estimates_) stops_[first++] = e.stop;
}

bool MeetingCurves::same_place(const Stop& s, const Stop& t) {
  return s.other == t.other && (s.other != kNone || s.twin == t.twin);
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

void MeetingCurves::tie_knots() {
  if (knots_ == 0) return;
  for (Index i = 0; i < size(); ++i) {
    const InnerSide& side = c_.sides[i];
    Index from = knot_of_[start(i)], to = knot_of_[end(i)];
    if (from != kNone) {
      arms_.push_back({from, i, 0, true});
      covers_[from] += right(i) ? side.hides_at_p0 : side.hides_at_p1;
    }
    if (to != kNone) {
      arms_.push_back({to, i, stop_count(i), false});
      covers_[to] += right(i) ? side.hides_at_p1 : side.hides_at_p0;
    }
    for (Index k = 0; k < stop_count(i); ++k) {
      if (stop(i, k).other != kNone) continue;
      arms_.push_back({stop(i, k).twin, i, k, false});
      arms_.push_back({stop(i, k).twin, i, k + 1, true});
      ++covers_[stop(i, k).twin];
    }
  }
}

bool MeetingCurves::comes_first(Index i, const Arm& p, const Arm& q) const {
  int u = half(i, p), v = half(i, q);
  if (u != v) return u < v;
  int s = cross_sign(p, q);
  return s != 0 ? s < 0 : p.starts && !q.starts;  // of two on one curve, the one that shows an inner side
}

int MeetingCurves::half(Index i, const Arm& arm) const {
  int s = cross_sign({0, i, 0, true}, arm);
  if (s != 0) return s < 0 ? 1 : 3;
  return (right(i) == right(arm.curve)) == arm.starts ? 4 : 2;
}

int MeetingCurves::cross_sign(const Arm& p, const Arm& q) const {
  const exact::Carrier &k = g_.carriers[carrier(p.curve)], &l = g_.carriers[carrier(q.curve)];
  exact::int128 cross = exact::int128(k.a) * l.b - exact::int128(k.b) * l.a;
  auto forward = [&](const exact::Carrier& c, const Arm& arm) { return ((c.b > 0) == right(arm.curve)) == arm.starts; };
  int sign = (cross > 0) - (cross < 0);
  return forward(k, p) == forward(l, q) ? sign : -sign;
}

}  // namespace findspace::plane
