// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Random shapes for the laws of distances: polygons with and without a hole, discs, unions of two boxes; small
// coordinates, so that ties and exact fits are common.
#pragma once

#include <array>
#include <random>

#include "../unit/distance_shapes.h"
#include "distance/planar/shape_pair.h"
#include "plane/sum/minkowski.h"
#include "plane/walk/unite.h"

namespace findspace::distance {

using namespace findspace::testing;
using exact::Real;
using exact::RealPoint;
using plane::Region;

class Shapes {
 public:
  explicit Shapes(unsigned seed) : random_(seed) {}

  std::int64_t number(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
  RealPoint position() { return {Real::ratio(number(-40, 40), 4), Real::ratio(number(-40, 40), 4)}; }

  Region rectangle() {
    std::int64_t x = number(-5, 3), y = number(-5, 3);
    return box(x, y, x + number(1, 6), y + number(1, 6));
  }

  Region shape() {
    switch (number(0, 5)) {
      case 0:
        return rectangle();
      case 1:
        return plane::region_of_disc(number(-3, 3), number(-3, 3), number(1, 4));
      case 2:
        return polygon({{0, 0}, {number(3, 8), number(-2, 2)}, {number(0, 3), number(3, 7)}});
      case 3:
        return polygon({{-4, -4}, {5, -4}, {5, 4}, {-4, 4}}, {{{-2, -2}, {-2, number(-1, 3)}, {number(-1, 3), -2}}});
      case 4:
        return polygon({{0, 0}, {6, 0}, {6, number(4, 6)}, {4, 4}, {number(2, 3), 2}, {1, 5}, {0, 5}});
      default: {
        Region a = rectangle(), b = rectangle();
        std::array<const Region*, 2> both{&a, &b};
        return plane::unite(both);
      }
    }
  }

 private:
  std::mt19937 random_;
};

inline constexpr std::array kAll{Which::kGamma1,    Which::kGamma2,    Which::kEta1,     Which::kEta2,
                                 Which::kDelta1,    Which::kDelta2,    Which::kMu,       Which::kMuBack,
                                 Which::kHausdorff, Which::kD1,        Which::kH,        Which::kHBack,
                                 Which::kDstar,     Which::kDstarBack, Which::kDiameter, Which::kPenetration};

inline Region moved(const Region& r, const RealPoint& by) {
  Region point = plane::CellComplex::uniform(0);
  plane::Vertex v;
  v.point = point.geometry.add_real_point(by.x, by.y);
  v.mark = 1;
  v.face = 0;
  point.vertices.push_back(v);
  point.faces[0].isolated.push_back(0);
  return plane::minkowski_sum(r, point);
}

}  // namespace findspace::distance
