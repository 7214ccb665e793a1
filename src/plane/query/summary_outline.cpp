// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/query/summary_outline.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "exact/margins/rounding.h"
#include "plane/base/parallel.h"

namespace findspace::plane {
namespace {

constexpr int kLines = 24;                       // vertical lines tried
constexpr double kBudget = 2e6;                  // distances computed for one face, about
constexpr std::size_t kManyDistances = 1 << 16;  // from here on in several threads
constexpr std::size_t kFewCurves = 64;           // so many are kept
constexpr double kEmptyFrame = 1000;             // half width of the frame where there is nothing to go by

/// From the point of a segment that is nearest to (px, py) to that.
template <class Segment>
std::array<double, 2> way_from_segment(double px, double py, const Segment& s) {
  double dx = s.x1 - s.x0, dy = s.y1 - s.y0, l2 = dx * dx + dy * dy;
  double t = l2 > 0 ? std::clamp(((px - s.x0) * dx + (py - s.y0) * dy) / l2, 0.0, 1.0) : 0;
  return {px - s.x0 - t * dx, py - s.y0 - t * dy};
}

}  // namespace

FaceOutline::FaceOutline(const CellComplex& c, const CellMeasures& measures, Index face,
                         std::span<const Index> half_edges)
    : c_(c), measures_(measures), face_(face), half_edges_(half_edges) {
  for (Index v : c.faces[face].isolated) points_.push_back({measures.x(v).hi, measures.y(v).hi});
  if (half_edges.size() <= kFewCurves) {
    std::vector<Curve> few;
    few.reserve(half_edges.size());
    each_curve([&](const Curve& k) { few.push_back(k); });
    few_ = std::move(few);
  }
  set_frame();
}

template <class F>
void FaceOutline::each_curve(F&& f) const {
  for (const Curve& k : few_) f(k);
  if (!few_.empty()) return;
  for (Index h : half_edges_)
    if (!(h & 1u) || c_.face(h ^ 1u) != face_) f(curve(h / 2));
}

FaceOutline::Curve FaceOutline::curve(Index edge) const {
  const Edge& e = c_.edges[edge];
  Curve k{measures_.x(e.v0).hi,
          measures_.y(e.v0).hi,
          measures_.x(e.v1).hi,
          measures_.y(e.v1).hi,
          0,
          0,
          -1,
          e.half,
          c_.face(2 * edge) == face_,
          c_.face(2 * edge + 1) == face_};
  if (c_.is_arc(edge)) {
    const CellMeasures::Circle& circle = measures_.circle(edge);
    k.cx = circle.x.hi;
    k.cy = circle.y.hi;
    k.r = circle.radius.hi;
  }
  return k;
}

void FaceOutline::set_frame() {
  if (half_edges_.empty() && points_.empty()) {
    x0_ = y0_ = -kEmptyFrame;
    x1_ = y1_ = kEmptyFrame;
    return;
  }
  x0_ = y0_ = HUGE_VAL;
  x1_ = y1_ = -HUGE_VAL;
  auto see = [this](double x, double y) {
    x0_ = std::min(x0_, x);
    x1_ = std::max(x1_, x);
    y0_ = std::min(y0_, y);
    y1_ = std::max(y1_, y);
  };
  each_curve([&](const Curve& k) {
    ++curve_count_;
    see(k.x0, k.y0);
    see(k.x1, k.y1);
    if (k.half != 0) see(std::clamp(k.cx, k.x0, k.x1), k.cy + k.half * k.r);
  });
  for (const auto& p : points_) see(p[0], p[1]);
  if (face_ != 0) return;
  double tolerance = std::max({(x1_ - x0_) / 2, (y1_ - y0_) / 2, 1.0});
  x0_ -= tolerance;
  x1_ += tolerance;
  y0_ -= tolerance;
  y1_ += tolerance;
}

double FaceOutline::distance(const Curve& k, double x, double y) {
  if (k.r < 0) {
    const auto [dx, dy] = way_from_segment(x, y, k);
    return std::hypot(dx, dy);
  }
  const double dx = x - k.cx, dy = y - k.cy, length = std::hypot(dx, dy), projection = k.cx + dx / length * k.r;
  const bool on_arc = projection >= k.x0 && projection <= k.x1 && dy * k.half >= 0;
  return on_arc ? std::abs(length - k.r) : std::min(std::hypot(x - k.x0, y - k.y0), std::hypot(x - k.x1, y - k.y1));
}

bool FaceOutline::is_farther(const Curve& k, double x, double y, double than) {
  if (than < 0) return true;
  if (k.r < 0) {
    const auto [dx, dy] = way_from_segment(x, y, k);
    return dx * dx + dy * dy > than * than * (1 + margin::kRoundings8);
  }
  // Its ends lie on the circle as well.
  const double dx = x - k.cx, dy = y - k.cy, square = dx * dx + dy * dy, far = k.r + than, near = k.r - than;
  return square > far * far * (1 + margin::kRoundings8) ||
         (near > 0 && square < near * near * (1 - margin::kRoundings8));
}

double FaceOutline::clearance(double x, double y, double enough) const {
  double least = std::min({x - x0_, x1_ - x, y - y0_, y1_ - y});
  const auto see = [&](const Curve& k) {
    if (least > enough && !is_farther(k, x, y, least)) least = std::min(least, distance(k, x, y));
  };
  each_curve(see);
  for (const auto& p : points_) least = std::min(least, std::hypot(x - p[0], y - p[1]));
  return least;
}

/// The middle of the longest part of the vertical line at x that lies in the face.
FaceOutline::Spot FaceOutline::widest_gap(double x) const {
  std::vector<Crossing> crossings;
  if (face_ == 0) crossings = {{y0_, true, false}, {y1_, false, true}};
  each_curve([&](const Curve& k) {
    if (!(k.x0 <= x && x < k.x1)) return;
    double y = k.half == 0 ? k.y0 + (k.y1 - k.y0) * ((x - k.x0) / (k.x1 - k.x0))
                           : k.cy + k.half * std::sqrt(std::max(0.0, (k.r - (x - k.cx)) * (k.r + (x - k.cx))));
    crossings.push_back({y, k.face_above, k.face_below});
  });
  std::sort(crossings.begin(), crossings.end(), [](const Crossing& a, const Crossing& b) { return a.y < b.y; });
  Spot spot;
  for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
    double gap = crossings[i + 1].y - crossings[i].y;
    if (!crossings[i].face_above || !crossings[i + 1].face_below || gap <= 2 * spot.clearance) continue;
    spot = {x, crossings[i].y + gap / 2, gap / 2};
  }
  if (spot.clearance >= 0) spot.clearance = clearance(spot.x, spot.y);
  return spot;
}

FaceOutline::Spot FaceOutline::climb(Spot best, int steps) const {
  static constexpr std::array<std::array<int, 2>, 8> kWays{
      {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {1, -1}, {-1, 1}, {-1, -1}}};
  // Moves are never longer than the clearance, so the path stays in the face.
  double step = best.clearance;
  while (steps > 0 && step > best.clearance / 64) {
    Spot next = best;
    for (const auto& way : kWays) {
      Spot s{best.x + way[0] * step / 2, best.y + way[1] * step / 2, 0};
      s.clearance = clearance(s.x, s.y, next.clearance);
      if (s.clearance > next.clearance) next = s;
    }
    steps -= int(kWays.size());
    if (next.clearance > best.clearance)
      best = next;
    else
      step /= 2;
  }
  return best;
}

FaceOutline::Spot FaceOutline::clearest() const {
  const double n = double(curve_count_ + points_.size()) + 1;
  const int budget = int(std::clamp(kBudget / n, 8.0, 400.0)), lines = std::min(kLines, budget);
  Spot best;
  std::vector<Spot> spots(static_cast<std::size_t>(lines));
  // Never at the ends nor in the very middle, where vertices like to be.
  at_once(spots.size(), spots.size() * curve_count_, kManyDistances,
          [&](std::size_t i) { spots[i] = widest_gap(x0_ + (x1_ - x0_) * ((static_cast<double>(i) + 0.5) / lines)); });
  for (const Spot& s : spots)
    if (s.clearance > best.clearance) best = s;
  if (best.clearance > 0) return climb(best, budget - lines);
  return best;
}

}  // namespace findspace::plane
