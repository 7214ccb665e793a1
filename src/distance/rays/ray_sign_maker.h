// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The sign maps on rays of the five distances that the others follow from, of a moving body B and a fixed body A.
// Internal to ray_signs, which says what they are.
#pragma once

#include <utility>
#include <vector>

#include "distance/planar/shape_pair.h"
#include "distance/rays/ray_covers.h"
#include "space/rays/piece_rays.h"
#include "space/rays/ray_sources.h"

namespace findspace::distance {

class RaySignMaker {
 public:
  RaySignMaker(const space::Body& b, const space::Body& a, const space::RayGrid& grid)
      : b_(b), a_(a), grid_(grid), scale_(b.scale) {}

  space::RaySourcePointer gamma1(const exact::Real& level) const;
  space::RaySourcePointer eta1(const exact::Real& level) const;
  space::RaySourcePointer eta2(const exact::Real& level) const;
  space::RaySourcePointer mu(const exact::Real& level) const;
  space::RaySourcePointer gamma2(const exact::Real& level) const;

 private:
  space::RaySourcePointer constant(int sign) const { return space::constant_rays(grid_, sign); }
  space::RaySourcePointer rays(std::vector<space::LinePiece> pieces,
                               space::PieceRays::Of of = space::PieceRays::Of::kUnion) const {
    space::drop_repeated(pieces);
    return std::make_unique<space::PieceRays>(pieces, scale_, grid_, of);
  }
  space::RaySourcePointer values(Which which, const exact::Real& level) const;
  space::RaySourcePointer balls(const std::vector<std::pair<space::RealVector, exact::Real>>& all) const;
  /// The sign of the signed distance to the cover (negative inside) less a level.
  space::RaySourcePointer cover(const RayCover& cover, const exact::Real& level) const;
  space::RaySourcePointer convex_gap(const space::BodyPart& b, const space::BodyPart& a,
                                     const exact::Real& grown) const;
  space::RaySourcePointer mu_of_vertices(const space::BodyPart& b, const exact::Real& level) const;
  space::RaySourcePointer vertices_near(const exact::Real& level) const;
  void add_near(const space::BodyPart& t, const space::BodyPart& s, const exact::Real& level,
                std::vector<space::LinePiece>& pieces) const;

  const space::Body &b_, &a_;
  space::RayGrid grid_;
  std::int64_t scale_;
};

}  // namespace findspace::distance
