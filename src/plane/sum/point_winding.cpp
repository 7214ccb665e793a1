// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/sum/point_winding.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "exact/planar/geometry_signs.h"

namespace findspace::plane {

using exact::Geometry;

PointWinding::PointWinding(ConvolutionBuilder convolution, std::int32_t base)
    : convolution_(std::move(convolution)), base_(base) {
  const Geometry& g = convolution_.curves.geometry;
  low_.reserve(pieces().size());
  high_.reserve(pieces().size());
  right_.reserve(pieces().size());
  for (const Piece& p : pieces()) {
    const exact::Point &from = g.points[p.p0], &to = g.points[p.p1];
    slack_ = std::max<double>({slack_, from.error, to.error});
    low_.push_back(std::min(from.y - from.error, to.y - to.error));
    high_.push_back(std::max(from.y + from.error, to.y + to.error));
    right_.push_back(to.x + to.error);
  }
  corner_x_.reserve(convolution_.corners.size());
  for (const Corner& k : convolution_.corners) corner_x_.push_back(g.points[end(k.in)].x);
}

Heading PointWinding::ahead(const Geometry& g, Index piece) const {
  const exact::SupportingCurve& k = g.supporting_curves[pieces()[piece].supporting_curve];
  // From p0 to p1: along (b, -a) or its opposite, to the right or straight up.
  return (k.b > 0) == bool(chain(piece).forward) ? Heading{k.b, -k.a} : Heading{-k.b, k.a};
}

void PointWinding::make_bands() {
  if (pieces().empty()) return;
  bottom_ = *std::min_element(low_.begin(), low_.end());
  double height = *std::max_element(high_.begin(), high_.end()) - bottom_;
  Index bands = Index(std::sqrt(double(pieces().size()))) + 1;
  bands_per_step_ = height > 0 ? bands / height : 0;
  band_start_.assign(bands + 1, 0);
  for (std::size_t k = 0; k < pieces().size(); ++k)
    for (Index b = band_of(low_[k]); b <= band_of(high_[k]); ++b) ++band_start_[b + 1];
  for (Index b = 0; b < bands; ++b) band_start_[b + 1] += band_start_[b];
  band_.resize(band_start_.back());
  std::vector<Index> order(pieces().size()), at(band_start_.begin(), band_start_.end() - 1);
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
            [&](Index p, Index q) { return right_[p] != right_[q] ? right_[p] > right_[q] : p < q; });
  for (Index k : order)
    for (Index b = band_of(low_[k]); b <= band_of(high_[k]); ++b) band_[at[b]++] = k;
  for (Index k = 0; k < corner_x_.size(); ++k) places_.push_back({corner_x_[k], k});
  std::sort(places_.begin(), places_.end(),
            [](const Place& p, const Place& q) { return p.x != q.x ? p.x < q.x : p.corner < q.corner; });
}

Index PointWinding::band_of(double y) const {
  double b = (y - bottom_) * bands_per_step_;
  return b <= 0 ? 0 : Index(std::min(b, double(band_start_.size() - 2)));
}

std::int32_t PointWinding::past_curve(const Geometry& g, Index point, std::size_t k) const {
  const Piece& s = pieces()[k];
  int from = compare_y(g, s.p0, point), to = compare_y(g, s.p1, point);
  if (from * to > 0) return 0;
  bool upwards = from < to;  // p0 -> p1
  int side = exact::side(g, point, s.supporting_curve);
  if (side == 0) {
    // On the line: at an end (its corner counts), beside the piece (level ones only), or inside it.
    int x0 = compare_xy(g, s.p0, point), x1 = compare_xy(g, s.p1, point);
    if (x0 >= 0 || x1 <= 0) return 0;
    Heading d = ahead(g, Index(k));
    return ray_crossing(-d, d, chain(k).displaced_left ? -1 : 1);
  }
  if (from == to || std::max(from, to) <= 0) return 0;  // level, or wholly at or below: the ray is a little above
  // The ray to the right crosses it if the point is to its left. (a, b) with a > 0 points to the right of the line.
  if (side > 0) return 0;
  return upwards == chain(k).forward ? 1 : -1;
}

std::int32_t PointWinding::past_curves(const Geometry& g, Index point) const {
  const exact::Point& p = g.points[point];
  double low = p.y - p.error, high = p.y + p.error, left = p.x - p.error;
  std::int32_t number = 0;
  auto beside = [&](std::size_t k) { return high >= low_[k] && low <= high_[k] && right_[k] >= left; };
  // The band of the point holds every piece at its height, unless its error reaches over a border.
  if (!band_start_.empty() && band_of(low) == band_of(high)) {
    Index b = band_of(low);
    for (Index i = band_start_[b]; i < band_start_[b + 1] && right_[band_[i]] >= left; ++i)
      if (beside(band_[i])) number += past_curve(g, point, band_[i]);
    return number;
  }
  for (std::size_t k = 0; k < pieces().size(); ++k)
    if (beside(k)) number += past_curve(g, point, k);
  return number;
}

std::int32_t PointWinding::past_corner(const Geometry& g, Index point, const Corner& k) const {
  Index at = end(k.in);
  if (at != point && compare_xy(g, at, point) != 0) return 0;
  bool left = chain(k.in).displaced_left, both = left == chain(k.out).displaced_left;
  Heading d = ahead(g, k.in);
  return ray_crossing(-d, ahead(g, k.out), both ? (left ? -1 : 1) : k.rotation);
}

std::int32_t PointWinding::past_corners(const Geometry& g, Index point) const {
  const exact::Point& p = g.points[point];
  double tolerance = p.error + slack_ + std::abs(p.x) * exact::Approx::kUnit * 4;
  std::int32_t number = 0;
  if (places_.empty()) {
    for (std::size_t k = 0; k < corner_x_.size(); ++k)
      if (std::abs(corner_x_[k] - p.x) <= tolerance) number += past_corner(g, point, convolution_.corners[k]);
    return number;
  }
  auto k = std::lower_bound(places_.begin(), places_.end(), p.x - tolerance,
                            [](const Place& t, double x) { return t.x < x; });
  for (; k != places_.end() && k->x <= p.x + tolerance; ++k)
    number += past_corner(g, point, convolution_.corners[k->corner]);
  return number;
}

std::int32_t PointWinding::at(const Geometry& g, Index point) {
  constexpr int kFewQueries = 12;
  if (++queries_ == kFewQueries) make_bands();
  return base_ + past_curves(g, point) + past_corners(g, point);
}

}  // namespace findspace::plane
