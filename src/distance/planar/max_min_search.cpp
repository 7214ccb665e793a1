// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/planar/max_min_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "exact/margins/planar_distance.h"
#include "exact/margins/rounding.h"

namespace findspace::distance {

using exact::Real;
using plane::Index;

namespace {

constexpr std::size_t kFewFeatures = 3;

double half_diagonal(const SearchRange& box) { return std::hypot(box.x1 - box.x0, box.y1 - box.y0) / 2; }

}  // namespace

MaxMinSearch::MaxMinSearch(const MaxMinSets& sets, double px, double py, const MaxMinQuery& query)
    : sets_(sets),
      a_(sets.a_features),
      b_(sets.b_features, px, py),
      px_(px),
      py_(py),
      query_(query),
      locate_a_(sets.a),
      locate_b_(sets.b),
      arc_done_(b_.size(), 0) {}

double MaxMinSearch::least(const List& list, Spot at) const {
  double d = std::numeric_limits<double>::infinity();
  for (Index k : list) d = std::min(d, a_[k].distance(at.x, at.y));
  return d;
}

/// Those that can be the nearest within the radius.
MaxMinSearch::Close MaxMinSearch::close_to(const List& list, Spot at, double radius) const {
  std::vector<double> distances;
  distances.reserve(list.size());
  double least = std::numeric_limits<double>::infinity();
  for (Index k : list) {
    distances.push_back(a_[k].distance(at.x, at.y));
    least = std::min(least, distances.back());
  }
  const double most = (least + 2 * radius) * margin::kUpward + query_.scale * margin::kMaxMinNoise;
  const double reach = radius + query_.scale * margin::kMaxMinNoise;
  Close out{{}, std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (distances[i] > most || sets_.a_reach.out_of_reach(list[i], at.x, at.y, reach)) continue;
    out.list.push_back(list[i]);
    out.least = std::min(out.least, distances[i]);
  }
  return out;
}

bool MaxMinSearch::agree(const List& list, Spot at) const {
  const double least = this->least(list, at);
  return std::all_of(list.begin(), list.end(), [&](Index k) {
    return a_[k].distance(at.x, at.y) <=
           least + query_.scale * margin::kLostByDoubles;  // no sign: both parts make level curves later
  });
}

/// Whether a formula may lack for the place in this short part of an edge. On a line there is one for any two parts of
/// A, on an arc where these are equally far along a line.
bool MaxMinSearch::unnamed(const SearchRange& part, Spot at) const {
  if (part.a.size() > kMostMaxMins) return true;
  if (!b_[std::size_t(part.edge)].arc) return false;
  const auto beside_line = [&](Index k, Index l) {
    const BoundaryFeature &s = a_[k], &t = a_[l];
    const auto straight = [](const BoundaryFeature& f) { return !f.arc && !f.is_vertex(); };
    const auto within = [&](const BoundaryFeature& f) { return f.arc && plain_length(at.x - f.cx, at.y - f.cy) < f.r; };
    if (straight(s) || straight(t)) return straight(s) && straight(t);
    return s.r == t.r && within(s) == within(t);
  };
  for (std::size_t i = 0; i < part.a.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (!beside_line(part.a[i], part.a[j])) return true;
  return false;
}

bool MaxMinSearch::in_a(Spot at) { return locate_a_.mark({Real::from_double(at.x), Real::from_double(at.y)}) > 0; }
bool MaxMinSearch::in_b(Spot at) {
  return locate_b_.mark({Real::from_double(at.x - px_), Real::from_double(at.y - py_)}) > 0;
}

double MaxMinSearch::height(const List& list, Spot at) {
  const double d = least(list, at);
  return d > best_ - query_.tolerance && in_a(at) ? 0 : d;
}

void MaxMinSearch::record(const MaxMinPlace& max_min) {
  if (max_min.value <= query_.least_value || max_min.value < best_ - query_.tolerance) return;
  best_ = std::max(best_, max_min.value);
  places_found_.push_back(max_min);
}

void MaxMinSearch::visit_vertices(const SearchRange& box) {
  for (Index k : box.b) {
    const BoundaryFeature& s = b_[k];
    const Spot at{px_ + s.x0, py_ + s.y0};
    if (!s.is_vertex() || at.x < box.x0 || at.x > box.x1 || at.y < box.y0 || at.y > box.y1) continue;
    record({height(box.a, at), at.x, at.y, s.cell});
  }
}

bool MaxMinSearch::matters(const SearchRange& r) const {
  return r.bound > std::max(query_.least_value, best_ - query_.tolerance) + query_.scale * margin::kMaxMinNoise;
}

void MaxMinSearch::push(SearchRange r) {
  r.bound = b_.bound(r, a_);
  if (matters(r)) todo_.push(std::move(r));
}

void MaxMinSearch::split_box(const SearchRange& box) {
  const double cx = (box.x0 + box.x1) / 2, cy = (box.y0 + box.y1) / 2;
  for (int k = 0; k < 4; ++k) {
    SearchRange part;
    part.x0 = k & 1 ? cx : box.x0;
    part.x1 = k & 1 ? box.x1 : cx;
    part.y0 = k & 2 ? cy : box.y0;
    part.y1 = k & 2 ? box.y1 : cy;
    const Spot middle{(part.x0 + part.x1) / 2, (part.y0 + part.y1) / 2};
    const double radius = half_diagonal(part) * margin::kBoxRadius + query_.scale * margin::kMaxMinNoise;
    Close near = close_to(box.a, middle, radius);
    if (near.least > radius && in_a(middle)) continue;
    part.a = std::move(near.list);
    for (Index e : box.b)
      if (b_[e].distance(middle.x - px_, middle.y - py_) <= radius) part.b.push_back(e);
    if (part.b.empty() && !in_b(middle)) continue;
    push(std::move(part));
  }
}

void MaxMinSearch::split_edge(SearchRange& part) {
  const double middle = (part.t0 + part.t1) / 2, length = b_.length(part);
  const Spot at = b_.on_edge(part.edge, middle);
  const plane::Cell cell = b_[std::size_t(part.edge)].cell;
  part.a = close_to(part.a, at, length).list;
  const double h = height(part.a, at);
  if (length < query_.scale * query_.effort.short_part) {
    places_.push_back(part);
    return record({h, at.x, at.y, cell, unnamed(part, at)});
  }
  best_ = std::max(best_, h);
  if (agree(part.a, at) && agree(part.a, b_.on_edge(part.edge, part.t0)) &&
      agree(part.a, b_.on_edge(part.edge, part.t1))) {
    for (Index k : part.a)
      for (const Spot& s : b_.max_mins(part, a_[k])) record({height(part.a, s), s.x, s.y, cell});
    return;
  }
  for (int k = 0; k < 2; ++k) {
    SearchRange half;
    half.edge = part.edge;
    half.t0 = k ? middle : part.t0;
    half.t1 = k ? part.t1 : middle;
    const Spot m = b_.on_edge(part.edge, (half.t0 + half.t1) / 2);
    Close near = close_to(part.a, m, length / 2);
    if (near.least > length / 2 && in_a(m)) continue;
    half.a = std::move(near.list);
    push(std::move(half));
  }
}

/// Of parts of A, on the sides that are not in A: a box may reach across a part, so its middle does not tell the side.
std::vector<MaxMinSearch::OuterCurve> MaxMinSearch::outer_curves(const List& list) const {
  std::vector<OuterCurve> out;
  for (Index k : list) {
    const BoundaryFeature& s = a_[k];
    if (s.is_vertex()) out.push_back({k, near_level_curve(sets_.a, s, 0, 0, 1)});
    for (const bool left : {true, false})
      if (!s.is_vertex() && sets_.a.faces[sets_.a.face(2 * s.cell.index + (left ? 0 : 1))].mark <= 0)
        out.push_back({k, level_curve_beside(sets_.a, s.cell.index, left)});
  }
  return out;
}

/// Equally far from three parts, or the centre of an arc: the only places inside B where the distance has a strict
/// maximum.
void MaxMinSearch::inner_candidates(const SearchRange& box) {
  const List list(box.a.begin(), box.a.begin() + std::ptrdiff_t(std::min<std::size_t>(box.a.size(), 8)));
  const bool some = list.size() < box.a.size();
  const double slack = query_.scale * margin::kCandidateBox;
  const auto try_at = [&](const Event& e) {
    if (!e.at) return;
    const Spot at{near_value(e.at->x), near_value(e.at->y)};
    if (!(at.x >= box.x0 - slack && at.x <= box.x1 + slack && at.y >= box.y0 - slack && at.y <= box.y1 + slack)) return;
    if (in_b(at)) record({height(box.a, at), at.x, at.y, {2, 0}, some});
  };
  const std::vector<OuterCurve> curves = outer_curves(list);
  for (std::size_t i = 0; i < curves.size(); ++i) {
    for (const Event& e : events(curves[i].curve)) try_at(e);
    for (std::size_t j = 0; j < i; ++j) {
      if (curves[i].part == curves[j].part) continue;
      if (a_[curves[i].part].arc || a_[curves[j].part].arc)
        for (const Event& e : events(curves[i].curve, curves[j].curve)) try_at(e);
      for (std::size_t k = 0; k < j; ++k) {
        if (curves[k].part == curves[j].part) continue;
        for (const Event& e : events(curves[i].curve, curves[j].curve, curves[k].curve)) try_at(e);
      }
    }
  }
}

void MaxMinSearch::leaf(const SearchRange& box) {
  inner_candidates(box);
  for (Index e : box.b) {
    if (b_[e].is_vertex() || (b_[e].arc && arc_done_[e])) continue;
    SearchRange part;
    part.edge = int(e);
    if (!b_[e].arc) {
      // The part of the segment in the box.
      const Spot p = b_.on_edge(part.edge, 0), q = b_.on_edge(part.edge, 1);
      const auto clip = [&](double from, double to, double low, double high) {
        if (from == to) return;
        const double a = (low - from) / (to - from), b = (high - from) / (to - from);
        part.t0 = std::max(part.t0, std::min(a, b));
        part.t1 = std::min(part.t1, std::max(a, b));
      };
      clip(p.x, q.x, box.x0, box.x1);
      clip(p.y, q.y, box.y0, box.y1);
      if (part.t0 > part.t1) continue;
    }
    const Spot m = b_.on_edge(part.edge, (part.t0 + part.t1) / 2);
    if (b_[e].arc) {
      arc_done_[e] = 1;  // whole, so once
      part.a.resize(a_.size());
      for (Index k = 0; k < a_.size(); ++k) part.a[k] = k;
      part.a = close_to(part.a, m, 2 * b_[e].r).list;
    } else {
      part.a = box.a;
    }
    push(std::move(part));
  }
}

/// A box around B + p.
SearchRange MaxMinSearch::root() const {
  SearchRange root;
  root.x0 = root.y0 = std::numeric_limits<double>::infinity();
  root.x1 = root.y1 = -root.x0;
  for (Index k = 0; k < b_.size(); ++k) {
    const BoundaryFeature& s = b_[k];
    const auto take = [&](double x, double y) {
      root.x0 = std::min(root.x0, px_ + x);
      root.x1 = std::max(root.x1, px_ + x);
      root.y0 = std::min(root.y0, py_ + y);
      root.y1 = std::max(root.y1, py_ + y);
    };
    take(s.x0, s.y0);
    take(s.x1, s.y1);
    if (s.arc) take(s.cx, s.cy + s.half * s.r);
    root.b.push_back(k);
  }
  for (Index k = 0; k < a_.size(); ++k)
    if (!sets_.a_reach.nowhere(k)) root.a.push_back(k);
  return root;
}

void MaxMinSearch::look(SearchRange& r) {
  if (r.edge >= 0) return split_edge(r);
  visit_vertices(r);
  const bool small = std::max(r.x1 - r.x0, r.y1 - r.y0) < query_.scale * margin::kMaxMinBox;
  if (r.a.size() <= kFewFeatures || small)
    leaf(r);
  else
    split_box(r);
}

std::vector<MaxMinPlace> MaxMinSearch::found() {
  todo_.run(
      query_.effort.most_ranges, [](const SearchRange&) { return false; },
      [&](SearchRange r) {
        if (matters(r)) look(r);
      });
  std::erase_if(places_found_, [&](const MaxMinPlace& p) {
    return p.value <= query_.least_value || p.value < best_ - query_.tolerance;
  });
  std::sort(places_found_.begin(), places_found_.end(),
            [](const MaxMinPlace& p, const MaxMinPlace& q) { return p.value > q.value; });
  return places_found_;
}

std::vector<MaxMinPlace> MaxMinSearch::run() {
  if (b_.size() == 0 || a_.empty()) return {};
  push(root());
  return found();
}

std::vector<MaxMinPlace> MaxMinSearch::finer(const MaxMinQuery& query) {
  query_ = query;
  for (SearchRange& part : std::exchange(places_, {})) push(std::move(part));
  return found();
}

}  // namespace findspace::distance
