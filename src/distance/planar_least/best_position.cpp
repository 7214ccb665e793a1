// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/planar_least/best_position.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <vector>

#include "distance/planar_features/boundary_features.h"
#include "distance/planar_features/point_set.h"
#include "exact/margins/planar_distance.h"
#include "exact/margins/rounding.h"
#include "plane/base/parallel.h"
#include "plane/base/stage_observer.h"
#include "plane/complex/overlay.h"
#include "plane/complex/primitives.h"
#include "plane/query/locate.h"
#include "plane/query/summary.h"
#include "plane/query/topology.h"

namespace findspace::distance {

using exact::Real;
using exact::RealPoint;
using plane::CellComplex;
using plane::Mark;
using plane::PieceBox;
using plane::Region;

namespace {

using exact::kInfinity;
constexpr Mark kPossible = 1, kCertain = 2;
constexpr std::size_t kAtOnce = 8, kMostVertices = 200, kMostChosen = 32, kMostCorners = 8;

/// A value of f at a position of S; rotated so that less is better.
struct Sample {
  double value = kInfinity;
  RealPoint at;
};

/// Part of S, and what f can be there.
struct Node {
  CellComplex part;
  PieceBox box{};
  double low = -kInfinity;
  Sample sample;
};

RealPoint middle(const PieceBox& b) {
  return {Real::from_double(b.x0 + (b.x1 - b.x0) / 2), Real::from_double(b.y0 + (b.y1 - b.y0) / 2)};
}

/// At least the distance of a point of the box from its middle.
double radius(const PieceBox& b) {
  const double size = std::max({std::abs(b.x0), std::abs(b.x1), std::abs(b.y0), std::abs(b.y1)});
  return std::hypot(b.x1 - b.x0, b.y1 - b.y0) / 2 * margin::kUpward + size * margin::kBoxMiddle;
}

Region filled(const PieceBox& b) {
  const auto x0 = std::int64_t(b.x0), y0 = std::int64_t(b.y0), x1 = std::int64_t(b.x1), y1 = std::int64_t(b.y1);
  plane::Contour ring;
  for (const plane::GridPoint p : {plane::GridPoint{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}) ring.push_back({p});
  return plane::region_of_rings({&ring, 1});
}

/// On the grid, around the box.
PieceBox outward(const PieceBox& b) {
  return {std::floor(b.x0), std::floor(b.y0), std::max(std::ceil(b.x1), std::floor(b.x0) + 1),
          std::max(std::ceil(b.y1), std::floor(b.y0) + 1)};
}

/// Of the grid: not to be halved.
bool is_cell(const PieceBox& b) { return b.x1 - b.x0 <= 1 && b.y1 - b.y0 <= 1; }

class PositionSearch {
 public:
  PositionSearch(const DiscRange& f, const PositionBounds& s, Sense sense, const SearchWindow& window)
      : f_(f), s_(s), window_(window), sense_(sense), rotation_(sense == Sense::kMinimum ? 1 : -1) {}

  Extremum run() {
    if (plane::is_empty(s_.possible)) return no_optimum<Region>(sense_);
    if (!start()) return no_optimum<Region>(sense_, true);
    while (count_ < window_.most_boxes && !open_.empty() && worth_more()) step();
    return finished();
  }

 private:
  /// Of f rotated so that less is better.
  ValueRange range(const RealPoint& p, double r) const {
    const ValueRange v = f_(p, r);
    return rotation_ > 0 ? v : ValueRange{-v.high, -v.low};
  }

  bool start() {
    const CellComplex both =
        plane::overlay(std::array<const CellComplex*, 2>{&s_.certain, &s_.possible}, [](std::span<const Mark> m) {
          return m[0] > 0 ? kCertain : m[1] > 0 ? kPossible : Mark(0);
        });
    const Mark outside = both.faces[0].mark;
    if (outside != 0 && !window_.worse_outside) look_outside(outside);
    if (outside != 0 && window_.worse_outside && rotation_ < 0) return false;
    PieceBox box = window_.box;
    const auto extent = plane::extent(both);
    if (outside == 0 && extent) box = *extent;
    Node root = node(both, outward(box));
    look_at_vertices(both);
    if (root.box.x0 <= root.box.x1 && !plane::is_empty(root.part)) open_.push_back(std::move(root));
    take(open_);
    return true;
  }

  /// One value for all positions beyond the window.
  void look_outside(Mark mark) {
    const PieceBox& b = window_.box;
    const RealPoint far{Real::from_double(std::ceil(b.x1 + 2 * (b.x1 - b.x0))), Real::from_double(std::ceil(b.y1))};
    const ValueRange v = range(far, 0);
    outside_ = v.low;
    if (mark == kCertain && v.high < best_.value) best_ = {v.high, far};
  }

  void look_at_vertices(const CellComplex& s) {
    std::vector<Sample> samples;
    for (const auto& v : s.vertices) {
      if (v.mark == kCertain && samples.size() < kMostVertices) samples.push_back({0, s.geometry.exact(v.point)});
    }
    plane::parallel_for(samples.size(), [&](std::size_t k) { samples[k].value = range(samples[k].at, 0).high; });
    for (const Sample& k : samples) keep(k);
  }

  void keep(const Sample& s) {
    if (s.value < best_.value) best_ = s;
  }
  void take(const std::vector<Node>& nodes) {
    for (const Node& n : nodes) keep(n.sample);
  }

  bool is_possible(double low) const { return low <= best_.value; }
  bool worth_more() const {
    const double low = open_.front().low;
    return best_.value > -kInfinity && low < kInfinity && best_.value - low > window_.enough;
  }

  Node node(const CellComplex& whole, const PieceBox& box) const {
    Node n;
    const Region square = filled(box);
    n.part = plane::overlay(std::array<const CellComplex*, 2>{&whole, &square},
                            [](std::span<const Mark> m) { return m[1] > 0 ? m[0] : Mark(0); });
    n.box = box;
    if (plane::is_empty(n.part)) return n;
    if (const auto tight = plane::extent(n.part)) {
      n.box = {std::max(box.x0, tight->x0), std::max(box.y0, tight->y0), std::min(box.x1, tight->x1),
               std::min(box.y1, tight->y1)};
    }
    n.low = range(middle(n.box), radius(n.box)).low;
    if (n.low > best_.value) return n;
    const Region certain = plane::remark(n.part, [](Mark m) { return Mark(m == kCertain); });
    if (plane::is_empty(certain)) return n;
    n.sample.at = plane::summarize(certain, Real(1)).components.front().sample_point;
    n.sample.value = range(n.sample.at, 0).high;
    if (window_.corners) look_at_corners(certain, n.sample);
    return n;
  }

  void look_at_corners(const CellComplex& certain, Sample& best) const {
    std::size_t count = 0;
    for (const auto& v : certain.vertices) {
      if (v.mark == 0 || ++count > kMostCorners) continue;
      const RealPoint at = certain.geometry.exact(v.point);
      const double value = range(at, 0).high;
      if (value < best.value) best = {value, at};
    }
  }

  static bool by_low(const Node& a, const Node& b) { return a.low < b.low; }

  /// Halves the boxes that bound worst.
  void step() {
    const std::size_t n = std::min(kAtOnce, open_.size());
    std::vector<Node> halves(2 * n);
    plane::parallel_for(halves.size(), [&](std::size_t k) {
      const Node& whole = open_[k / 2];
      const PieceBox box = outward(whole.box);
      if (is_cell(box)) return;
      PieceBox half = box;
      const bool wide = box.x1 - box.x0 > box.y1 - box.y0;
      const double cut = std::floor(wide ? box.x0 + (box.x1 - box.x0) / 2 : box.y0 + (box.y1 - box.y0) / 2);
      (wide ? k % 2 == 0 ? half.x1 : half.x0 : k % 2 == 0 ? half.y1 : half.y0) = cut;
      halves[k] = node(whole.part, half);
    });
    take(halves);
    count_ += halves.size();
    std::vector<Node> kept(std::make_move_iterator(open_.begin() + std::ptrdiff_t(n)),
                           std::make_move_iterator(open_.end()));
    for (std::size_t k = 0; k < n; ++k) {
      const PieceBox& box = open_[k].box;
      if (seen_) seen_.add_box({box.x0, box.y0, 0}, {box.x1, box.y1, 0});
      if (is_cell(outward(box))) done_.push_back(std::move(open_[k]));
    }
    for (Node& h : halves)
      if (!plane::is_empty(h.part)) kept.push_back(std::move(h));
    open_ = std::move(kept);
    std::erase_if(open_, [&](const Node& k) { return !is_possible(k.low); });
    std::stable_sort(open_.begin(), open_.end(), by_low);
  }

  Extremum finished() {
    for (Node& n : open_) done_.push_back(std::move(n));
    std::erase_if(done_, [&](const Node& k) { return !is_possible(k.low); });
    double low = std::min(best_.value, outside_);
    for (const Node& n : done_) low = std::min(low, n.low);
    if (best_.value == -kInfinity) return no_optimum<Region>(sense_, true);
    Extremum e = no_optimum<Region>(sense_);
    if (low == kInfinity) return e;  // undefined everywhere
    const auto number = [&](double v) {
      return std::isfinite(v) ? std::optional(Real::from_double(rotation_ * v)) : std::nullopt;
    };
    e.set_enclosed(number(best_.value), number(low), Way::kSearch);
    if (best_.value == kInfinity) return e;
    places(e);
    return e;
  }

  /// Places of good values, so that no box that may hold a best position is far from all of them.
  void places(Extremum& e) const {
    std::vector<RealPoint> chosen;
    const auto far = [&](const PieceBox& b) {
      double least = kInfinity;
      for (const RealPoint& p : chosen) {
        const double x = near_value(p.x), y = near_value(p.y);
        least = std::min(least, std::hypot(std::max(b.x1 - x, x - b.x0), std::max(b.y1 - y, y - b.y0)));
      }
      return least;
    };
    chosen.push_back(best_.at);
    for (const Node& n : done_) {
      if (chosen.size() >= kMostChosen || !std::isfinite(n.sample.value)) continue;
      if (far(n.box) > 16 * radius(n.box)) chosen.push_back(n.sample.at);
    }
    for (const Node& n : done_) e.within = std::max(e.within, far(n.box));
    if (is_possible(outside_)) e.within = kInfinity;
    e.at = point_set(chosen);
  }

  const DiscRange& f_;
  PositionBounds s_;
  const SearchWindow& window_;
  Sense sense_;
  int rotation_;
  Sample best_;
  double outside_ = kInfinity;
  std::size_t count_ = 0;
  std::vector<Node> open_, done_;  // done: no box of the grid can be halved
  plane::ObservedCells seen_{"boxes of positions halved for the best one", true};
};

}  // namespace

Extremum best_position(const DiscRange& f, const PositionBounds& s, Sense sense, const SearchWindow& window) {
  return PositionSearch(f, s, sense, window).run();
}

}  // namespace findspace::distance
