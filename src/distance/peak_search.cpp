// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/peak_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace findspace::distance {

using exact::Real;
using plane::Index;

namespace {

constexpr std::size_t kFewSites = 6;
// Of the scale. Peaks on edges are smooth or sharp; a part this small is left to the exact computation in its place.
constexpr double kSmallBox = 0x1p-30, kSmallPart = 0x1p-24, kRounding = 0x1p-47;

double box_distance(double x0, double y0, double x1, double y1, double x, double y) {
  return std::hypot(std::max({x0 - x, 0.0, x - x1}), std::max({y0 - y, 0.0, y - y1}));
}

}  // namespace

PeakSearch::PeakSearch(const plane::Region& a, const plane::Region& b, std::span<const Site> a_sites,
                       std::span<const Site> b_sites, double px, double py, double scale, double room,
                       double least_value)
    : a_region_(a),
      a_(a_sites),
      b_(b_sites),
      px_(px),
      py_(py),
      scale_(scale),
      room_(room),
      least_value_(least_value),
      locate_a_(a),
      locate_b_(b),
      arc_done_(b_sites.size(), 0) {}

PeakSearch::Spot PeakSearch::on_edge(int edge, double t) const {
  const Site& s = b_[edge];
  if (!s.arc) return {px_ + s.x0 + t * (s.x1 - s.x0), py_ + s.y0 + t * (s.y1 - s.y0)};
  double from = std::atan2(s.y0 - s.cy, s.x0 - s.cx), to = std::atan2(s.y1 - s.cy, s.x1 - s.cx);
  // Ends on the horizontal diameter belong to either half.
  if (s.half > 0 ? from < 0 : from > 0) from = -from;
  if (s.half > 0 ? to < 0 : to > 0) to = -to;
  double angle = from + t * (to - from);
  return {px_ + s.cx + s.r * std::cos(angle), py_ + s.cy + s.r * std::sin(angle)};
}

/// A convex polygon around the range.
std::vector<PeakSearch::Spot> PeakSearch::hull(const Range& r) const {
  if (r.edge < 0) return {{r.x0, r.y0}, {r.x1, r.y0}, {r.x0, r.y1}, {r.x1, r.y1}};
  Spot p = on_edge(r.edge, r.t0), q = on_edge(r.edge, r.t1);
  const Site& s = b_[r.edge];
  if (!s.arc) return {p, q};
  // The end tangents bound the arc: for less than a half circle they meet over its middle.
  Spot m = on_edge(r.edge, (r.t0 + r.t1) / 2);
  double cx = px_ + s.cx, cy = py_ + s.cy;
  double half = std::hypot(p.x - q.x, p.y - q.y) / 2 / s.r, cosine = std::sqrt(std::max(0.0, 1 - half * half));
  if (cosine < 0.5) {
    double h = s.r;
    return {{cx - h, cy - h}, {cx + h, cy - h}, {cx - h, cy + h}, {cx + h, cy + h}};
  }
  return {p, q, {cx + (m.x - cx) / cosine, cy + (m.y - cy) / cosine}};
}

/// The greatest distance of a point of the range from (x, y).
double PeakSearch::farthest(const Range& r, std::span<const Spot> hull, double x, double y) const {
  double far = 0;
  if (r.edge < 0 || !b_[r.edge].arc) {
    for (const Spot& h : hull) far = std::max(far, std::hypot(h.x - x, h.y - y));
    return far;
  }
  // On an arc: an end, or the point opposite to (x, y).
  const Site& e = b_[r.edge];
  Spot p = on_edge(r.edge, r.t0), q = on_edge(r.edge, r.t1);
  far = std::max(std::hypot(p.x - x, p.y - y), std::hypot(q.x - x, q.y - y));
  double dx = px_ + e.cx - x, dy = py_ + e.cy - y, d = std::hypot(dx, dy);
  Site part = e;
  part.x0 = std::min(p.x, q.x) - px_, part.x1 = std::max(p.x, q.x) - px_;
  return d == 0 || part.has_direction(dx, dy) ? std::max(far, d + e.r) : far;
}

/// The least distance of a point around the range from (x, y); never more than that of the range itself.
double PeakSearch::nearest(const Range& r, std::span<const Spot> hull, double x, double y) const {
  if (hull.size() == 2) {
    Site part;
    part.cell = {1, 0};
    part.x0 = hull[0].x, part.y0 = hull[0].y, part.x1 = hull[1].x, part.y1 = hull[1].y;
    return part.distance(x, y);
  }
  double x0 = hull[0].x, x1 = x0, y0 = hull[0].y, y1 = y0;
  for (const Spot& h : hull)
    x0 = std::min(x0, h.x), x1 = std::max(x1, h.x), y0 = std::min(y0, h.y), y1 = std::max(y1, h.y);
  double near = box_distance(x0, y0, x1, y1, x, y);
  if (r.edge < 0) return near;
  const Site& e = b_[r.edge];
  return std::max(near, e.r - std::hypot(px_ + e.cx - x, py_ + e.cy - y));
}

/// At least the greatest distance from a point of the range to the site.
double PeakSearch::most(const Site& s, const Range& r, std::span<const Spot> hull) const {
  if (s.is_vertex()) return farthest(r, hull, s.x0, s.y0);
  if (!s.arc) {
    double far = 0;
    for (const Spot& h : hull) far = std::max(far, s.distance(h.x, h.y));
    return far;
  }
  for (const Spot& h : hull)
    if (!s.has_direction(h.x - s.cx, h.y - s.cy)) return std::numeric_limits<double>::infinity();
  return std::max(farthest(r, hull, s.cx, s.cy) - s.r, s.r - nearest(r, hull, s.cx, s.cy));
}

double PeakSearch::bound(const Range& r) const {
  auto around = hull(r);
  double least = std::numeric_limits<double>::infinity();
  for (Index k : r.a) least = std::min(least, most(a_[k], r, around));
  return least;
}

double PeakSearch::least(const List& list, Spot at) const {
  double d = std::numeric_limits<double>::infinity();
  for (Index k : list) d = std::min(d, a_[k].distance(at.x, at.y));
  return d;
}

PeakSearch::List PeakSearch::close_to(const List& list, Spot at, double radius) const {
  double d = least(list, at);
  List out;
  for (Index k : list)
    if (a_[k].distance(at.x, at.y) <= (d + 2 * radius) * (1 + 0x1p-40) + scale_ * kRounding) out.push_back(k);
  return out;
}

bool PeakSearch::in_a(Spot at) { return locate_a_.mark({Real::from_double(at.x), Real::from_double(at.y)}) > 0; }
bool PeakSearch::in_b(Spot at) {
  return locate_b_.mark({Real::from_double(at.x - px_), Real::from_double(at.y - py_)}) > 0;
}

double PeakSearch::height(const List& list, Spot at) {
  double d = least(list, at);
  return d > best_ - room_ && in_a(at) ? 0 : d;
}

void PeakSearch::record(const Peak& peak) {
  if (peak.value <= least_value_ || peak.value < best_ - room_) return;
  best_ = std::max(best_, peak.value);
  peaks_.push_back(peak);
}

void PeakSearch::visit_vertices(const Range& box) {
  for (Index k : box.b) {
    const Site& s = b_[k];
    Spot at{px_ + s.x0, py_ + s.y0};
    if (!s.is_vertex() || at.x < box.x0 || at.x > box.x1 || at.y < box.y0 || at.y > box.y1) continue;
    record({height(box.a, at), at.x, at.y, s.cell});
  }
}

/// Peaks below the best, by up to `room`, are wanted from boxes only: along an edge they could be a whole interval.
bool PeakSearch::matters(const Range& r) const {
  return r.bound > std::max(least_value_, best_ - (r.edge < 0 ? room_ : 0)) + scale_ * kRounding;
}

void PeakSearch::push(Range r) {
  r.bound = bound(r);
  if (matters(r)) todo_.push(std::move(r));
}

void PeakSearch::split_box(const Range& box) {
  double cx = (box.x0 + box.x1) / 2, cy = (box.y0 + box.y1) / 2;
  for (int k = 0; k < 4; ++k) {
    Range part;
    part.x0 = k & 1 ? cx : box.x0, part.x1 = k & 1 ? box.x1 : cx;
    part.y0 = k & 2 ? cy : box.y0, part.y1 = k & 2 ? box.y1 : cy;
    Spot middle{(part.x0 + part.x1) / 2, (part.y0 + part.y1) / 2};
    double radius = std::hypot(part.x1 - part.x0, part.y1 - part.y0) / 2 * (1 + 0x1p-30) + scale_ * kRounding;
    part.a = close_to(box.a, middle, radius);
    if (least(part.a, middle) > radius && in_a(middle)) continue;
    for (Index e : box.b)
      if (b_[e].distance(middle.x - px_, middle.y - py_) <= radius) part.b.push_back(e);
    if (part.b.empty() && !in_b(middle)) continue;
    push(std::move(part));
  }
}

void PeakSearch::split_edge(const Range& part) {
  double middle = (part.t0 + part.t1) / 2;
  Spot at = on_edge(part.edge, middle), from = on_edge(part.edge, part.t0), to = on_edge(part.edge, part.t1);
  const Site& s = b_[part.edge];
  double length = std::hypot(to.x - from.x, to.y - from.y);
  if (s.arc) length = std::max(length, s.r * 3.2 * (part.t1 - part.t0));
  record({height(part.a, at), at.x, at.y, s.cell});
  if (length < scale_ * kSmallPart) return;
  for (int k = 0; k < 2; ++k) {
    Range half;
    half.edge = part.edge;
    half.t0 = k ? middle : part.t0, half.t1 = k ? part.t1 : middle;
    Spot m = on_edge(part.edge, (half.t0 + half.t1) / 2);
    half.a = close_to(part.a, m, length / 2);
    if (least(half.a, m) > length / 2 && in_a(m)) continue;
    push(std::move(half));
  }
}

/// Equally far from three parts, or the centre of an arc: the only places inside B where the distance has a strict
/// maximum.
void PeakSearch::inner_candidates(const Range& box) {
  List list(box.a.begin(), box.a.begin() + std::ptrdiff_t(std::min(box.a.size(), kFewSites + 2)));
  double cx = (box.x0 + box.x1) / 2, cy = (box.y0 + box.y1) / 2, slack = scale_ * 0x1p-40;
  std::vector<Front> fronts;
  for (Index k : list) fronts.push_back(near_front(a_region_, a_[k], cx, cy, 1));
  auto try_at = [&](const Event& e) {
    if (!e.at) return;
    Spot at{near_value(e.at->x), near_value(e.at->y)};
    if (!(at.x >= box.x0 - slack && at.x <= box.x1 + slack && at.y >= box.y0 - slack && at.y <= box.y1 + slack)) return;
    if (in_b(at)) record({height(box.a, at), at.x, at.y, {2, 0}});
  };
  for (std::size_t i = 0; i < fronts.size(); ++i) {
    for (const Event& e : events(fronts[i])) try_at(e);
    for (std::size_t j = 0; j < i; ++j) {
      if (a_[list[i]].arc || a_[list[j]].arc)
        for (const Event& e : events(fronts[i], fronts[j])) try_at(e);
      for (std::size_t k = 0; k < j; ++k)
        for (const Event& e : events(fronts[i], fronts[j], fronts[k])) try_at(e);
    }
  }
}

void PeakSearch::leaf(const Range& box) {
  inner_candidates(box);
  for (Index e : box.b) {
    if (b_[e].is_vertex() || (b_[e].arc && arc_done_[e])) continue;
    Range part;
    part.edge = int(e);
    if (!b_[e].arc) {
      // The part of the segment in the box.
      Spot p = on_edge(part.edge, 0), q = on_edge(part.edge, 1);
      auto clip = [&](double from, double to, double low, double high) {
        if (from == to) return;
        double a = (low - from) / (to - from), b = (high - from) / (to - from);
        part.t0 = std::max(part.t0, std::min(a, b)), part.t1 = std::min(part.t1, std::max(a, b));
      };
      clip(p.x, q.x, box.x0, box.x1);
      clip(p.y, q.y, box.y0, box.y1);
      if (part.t0 > part.t1) continue;
    }
    Spot m = on_edge(part.edge, (part.t0 + part.t1) / 2);
    if (b_[e].arc) {
      arc_done_[e] = 1;  // whole, so once
      part.a.resize(a_.size());
      for (Index k = 0; k < a_.size(); ++k) part.a[k] = k;
      part.a = close_to(part.a, m, 2 * b_[e].r);
    } else {
      part.a = box.a;
    }
    push(std::move(part));
  }
}

std::vector<Peak> PeakSearch::run() {
  if (b_.empty() || a_.empty()) return {};
  Range root;
  root.x0 = root.y0 = std::numeric_limits<double>::infinity(), root.x1 = root.y1 = -root.x0;
  for (Index k = 0; k < b_.size(); ++k) {
    const Site& s = b_[k];
    auto take = [&](double x, double y) {
      root.x0 = std::min(root.x0, px_ + x), root.x1 = std::max(root.x1, px_ + x);
      root.y0 = std::min(root.y0, py_ + y), root.y1 = std::max(root.y1, py_ + y);
    };
    take(s.x0, s.y0), take(s.x1, s.y1);
    if (s.arc) take(s.cx, s.cy + s.half * s.r);
    root.b.push_back(k);
  }
  for (Index k = 0; k < a_.size(); ++k) root.a.push_back(k);
  push(std::move(root));
  while (!todo_.empty()) {
    Range r = todo_.top();
    todo_.pop();
    if (!matters(r)) continue;
    if (r.edge >= 0) {
      split_edge(r);
      continue;
    }
    visit_vertices(r);
    bool small = std::max(r.x1 - r.x0, r.y1 - r.y0) < scale_ * kSmallBox;
    if (r.a.size() <= kFewSites || small)
      leaf(r);
    else
      split_box(r);
  }
  std::erase_if(peaks_, [&](const Peak& p) { return p.value < best_ - room_; });
  std::sort(peaks_.begin(), peaks_.end(), [](const Peak& p, const Peak& q) { return p.value > q.value; });
  return std::move(peaks_);
}

}  // namespace findspace::distance
