// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The displaced winding number (winding.h) of a convolution of segments at one point, without arranging it: a ray to
// the right, turned up by an infinitesimal, counts what it crosses; curves and corners through the point itself count
// by the side they are displaced to. Guarantee: exact for every point. Cost: building O(n log n); a query looks at the
// curves to the right of the point in its band of y, a comparison of doubles each.
#pragma once

#include <vector>

#include "plane/convolution.h"

namespace findspace::plane {

class PointWinding {
 public:
  /// Copies what it needs of the convolution, whose points are grid points. `base`: number of the unbounded face.
  PointWinding(const ConvolutionBuilder& convolution, std::int32_t base);

  /// `geometry`: that of the convolution, with more points and carriers.
  std::int32_t at(const exact::Geometry& geometry, Index point) const;

 private:
  struct Vector {
    std::int64_t x, y;
  };
  struct Turning {  // a corner: from the back direction of one curve to the direction of the next
    GridPoint at;
    Index point;  // the same, in the convolution's geometry
    Vector from, to;
    int rotation;  // +1 counter-clockwise
  };
  /// +1, -1 or 0: how a path that turns from one direction to another around the point crosses the ray.
  static int crossing(Vector from, Vector to, int rotation);
  void make_bands();
  Index band_of(double y) const;
  std::int32_t far_and_through(const exact::Geometry& g, Index point) const;

  std::int32_t base_;
  std::vector<Piece> pieces_;
  std::vector<Strand> strands_;
  std::vector<double> low_, high_, right_;  // y range and greatest x of each piece
  // Bands of y: the pieces that reach into each, those that reach furthest to the right first.
  double bottom_ = 0, bands_per_step_ = 0;
  std::vector<Index> band_start_, band_;
  std::vector<Turning> corners_;  // by place
};

}  // namespace findspace::plane
