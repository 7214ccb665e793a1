// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/point_winding.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace findspace::plane {

using exact::Geometry;
using exact::int128;

PointWinding::PointWinding(const ConvolutionBuilder& c, std::int32_t base)
    : base_(base), pieces_(c.curves.pieces), strands_(c.strands) {
  const auto& points = c.curves.geometry.points;
  for (const Piece& p : pieces_) {
    low_.push_back(std::min(points[p.p0].y, points[p.p1].y));
    high_.push_back(std::max(points[p.p0].y, points[p.p1].y));
    right_.push_back(points[p.p1].x);
  }
  make_bands();
  auto ahead = [&](Index k) {
    const exact::Point &p = points[pieces_[k].p0], &q = points[pieces_[k].p1];
    int s = strands_[k].forward ? 1 : -1;
    return Vector{s * (q.gx - p.gx), s * (q.gy - p.gy)};
  };
  for (const Corner& k : c.corners) {
    const Strand& in = strands_[k.in];
    bool left = in.displaced_left, both = left == strands_[k.out].displaced_left;
    Index end = in.forward ? pieces_[k.in].p1 : pieces_[k.in].p0;
    const exact::Point& at = points[end];
    Vector d = ahead(k.in);
    corners_.push_back({{at.gx, at.gy}, end, {-d.x, -d.y}, ahead(k.out), both ? (left ? -1 : 1) : k.rotation});
  }
  std::sort(corners_.begin(), corners_.end(), [](const Turning& p, const Turning& q) { return p.at < q.at; });
}

void PointWinding::make_bands() {
  if (pieces_.empty()) return;
  bottom_ = *std::min_element(low_.begin(), low_.end());
  double height = *std::max_element(high_.begin(), high_.end()) - bottom_;
  Index bands = Index(std::sqrt(double(pieces_.size()))) + 1;
  bands_per_step_ = height > 0 ? bands / height : 0;
  band_start_.assign(bands + 1, 0);
  for (std::size_t k = 0; k < pieces_.size(); ++k)
    for (Index b = band_of(low_[k]); b <= band_of(high_[k]); ++b) ++band_start_[b + 1];
  for (Index b = 0; b < bands; ++b) band_start_[b + 1] += band_start_[b];
  band_.resize(band_start_.back());
  std::vector<Index> order(pieces_.size()), at(band_start_.begin(), band_start_.end() - 1);
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
            [&](Index p, Index q) { return right_[p] != right_[q] ? right_[p] > right_[q] : p < q; });
  for (Index k : order)
    for (Index b = band_of(low_[k]); b <= band_of(high_[k]); ++b) band_[at[b]++] = k;
}

Index PointWinding::band_of(double y) const {
  double b = (y - bottom_) * bands_per_step_;
  return b <= 0 ? 0 : Index(std::min(b, double(band_start_.size() - 2)));
}

int PointWinding::crossing(Vector from, Vector to, int rotation) {
  if (rotation == 0) return 0;
  if (rotation < 0) return -crossing(to, from, 1);
  auto level = [](Vector v) { return v.y == 0 && v.x > 0; };  // along the ray, just below it
  auto half = [](Vector v) { return v.y > 0 || (v.y == 0 && v.x > 0) ? 0 : 1; };
  int128 cross = int128(from.x) * to.y - int128(from.y) * to.x;
  bool same = cross == 0 && int128(from.x) * to.x + int128(from.y) * to.y > 0;
  if (same || level(to)) return 0;
  if (level(from)) return 1;
  // Counter-clockwise from a larger angle in (0, 360) to a smaller one passes the ray.
  bool larger = half(from) != half(to) ? half(from) > half(to) : cross < 0;
  return larger ? 1 : 0;
}

std::int32_t PointWinding::far_and_through(const Geometry& g, Index point) const {
  const exact::Point& p = g.points[point];
  double low = p.y - p.error, high = p.y + p.error;
  std::int32_t number = 0;
  // The band of the point holds every piece at its height, unless its error reaches over a border: then all are looked
  // at.
  Index first = band_of(low), last = band_of(high);
  for (std::size_t i = first == last ? band_start_[first] : 0;
       i < (first == last ? band_start_[first + 1] : pieces_.size()); ++i) {
    std::size_t k = first == last ? band_[i] : i;
    if (first == last && right_[k] < p.x - p.error) break;
    if (high < low_[k] || low > high_[k]) continue;
    const Piece& s = pieces_[k];
    int from = g.compare_y(s.p0, point), to = g.compare_y(s.p1, point);
    if (from * to > 0) continue;
    bool upwards = from < to;  // p0 -> p1
    int side = g.side(point, s.carrier);
    if (side == 0) {
      // On the line: at an end (its corner counts), beside the piece (level ones only), or inside it.
      int x0 = g.compare_xy(s.p0, point), x1 = g.compare_xy(s.p1, point);
      if (x0 >= 0 || x1 <= 0) continue;
      const exact::Point &a = g.points[s.p0], &b = g.points[s.p1];
      int sign = strands_[k].forward ? 1 : -1;
      Vector d{sign * (b.gx - a.gx), sign * (b.gy - a.gy)};
      number += crossing({-d.x, -d.y}, d, strands_[k].displaced_left ? -1 : 1);
      continue;
    }
    if (from == to || std::max(from, to) <= 0) continue;  // level, or wholly at or below: the ray is a little above
    // The ray to the right crosses it if the point is to its left. (a, b) with a > 0 points to the right of the line.
    if (side > 0) continue;
    number += upwards == strands_[k].forward ? 1 : -1;
  }
  return number;
}

std::int32_t PointWinding::at(const Geometry& g, Index point) const {
  std::int32_t number = base_ + far_and_through(g, point);
  const exact::Point& p = g.points[point];
  GridPoint place{std::int64_t(std::llround(p.x)), std::int64_t(std::llround(p.y))};
  auto k = std::lower_bound(corners_.begin(), corners_.end(), place,
                            [](const Turning& t, const GridPoint& q) { return t.at < q; });
  if (k == corners_.end() || k->at != place || g.compare_xy(k->point, point) != 0) return number;
  for (; k != corners_.end() && k->at == place; ++k) number += crossing(k->from, k->to, k->rotation);
  return number;
}

}  // namespace findspace::plane
