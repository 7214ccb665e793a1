// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The displaced winding number (winding.h) of a convolution of segments at one point, without arranging it: a ray to
// the right, turned up by an infinitesimal, counts what it crosses; curves and corners through the point itself count
// by the side they are displaced to. Guarantee: exact for every point. Cost: the first few queries look at every curve,
// a comparison of doubles each; then the curves are sorted into bands of y, O(n log n), and a query looks at those to
// the right of the point in its band.
#pragma once

#include <vector>

#include "plane/base/ray_crossing.h"
#include "plane/sum/convolution.h"

namespace findspace::plane {

class PointWinding {
 public:
  /// `base`: number of the unbounded face.
  PointWinding(ConvolutionBuilder convolution, std::int32_t base);

  /// The convolution's geometry, to be extended by the points asked about and handed to `at`.
  exact::Geometry take_geometry() { return std::move(convolution_.curves.geometry); }

  std::int32_t at(const exact::Geometry& geometry, Index point);

 private:
  struct Place {  // where a corner is
    double x;
    Index corner;
  };
  const std::vector<Piece>& pieces() const { return convolution_.curves.pieces; }
  const Chain& chain(std::size_t piece) const { return convolution_.chains[piece]; }
  /// Of the way along a curve.
  Heading ahead(const exact::Geometry& g, Index piece) const;
  Index end(Index piece) const { return chain(piece).forward ? pieces()[piece].p1 : pieces()[piece].p0; }
  void make_bands();
  Index band_of(double y) const;
  std::int32_t past_curve(const exact::Geometry& g, Index point, std::size_t piece) const;
  std::int32_t past_curves(const exact::Geometry& g, Index point) const;
  std::int32_t past_corner(const exact::Geometry& g, Index point, const Corner& corner) const;
  std::int32_t past_corners(const exact::Geometry& g, Index point) const;

  ConvolutionBuilder convolution_;
  std::int32_t base_;
  int queries_ = 0;
  std::vector<double> low_, high_, right_;  // y range and greatest x of each piece
  std::vector<double> corner_x_;
  double slack_ = 0;  // no point of the convolution is off by more
  // Bands of y: the pieces that reach into each, those that reach furthest to the right first.
  double bottom_ = 0, bands_per_step_ = 0;
  std::vector<Index> band_start_, band_;
  std::vector<Place> places_;  // by x
};

}  // namespace findspace::plane
