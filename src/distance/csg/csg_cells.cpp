// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/csg/csg_cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "distance/csg/csg_part.h"
#include "distance/solid/solid_pair.h"
#include "space/shape/box_shape.h"

namespace findspace::distance {

using exact::Real;
using space::Body;
using space::BodyPart;
using space::CsgPart;
using space::CsgSolid;
using space::Point;
using space::RealVector;

namespace {

enum class CellSide { kIn, kOut, kUnsure };

/// The cells of a lattice over the box about a solid: which lie in it, which beside it.
class SolidCells {
 public:
  SolidCells(const CsgSolid& solid, std::size_t across) {
    const auto cells = static_cast<std::int64_t>(across);
    const space::Bounds3 box = bounds(solid);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto low = static_cast<std::int64_t>(floor(box.low[k]));
      const auto length = static_cast<std::int64_t>(-floor(-box.high[k])) - low;
      const std::int64_t step = std::max<std::int64_t>((length + cells - 1) / cells, 1);
      for (std::int64_t i = 0; i <= cells; ++i) at_[k].push_back(low + i * step);
    }
    std::vector<const CsgPart*> parts;
    for (const CsgPart& part : solid.parts) parts.push_back(&part);
    divide({}, across, parts);
  }

  /// No body where there are none.
  std::optional<Body> inside() const { return body(inside_); }
  std::optional<Body> about() const { return body(about_); }
  /// How much of what holds it lies in it.
  double filled() const { return volume(inside_) / volume(about_); }

 private:
  using Index = std::array<std::size_t, 3>;

  void divide(const Index& first, std::size_t across, const std::vector<const CsgPart*>& parts) {
    const Point low = corner(first, 0), high = corner(first, across);
    std::vector<const CsgPart*> left;
    for (const CsgPart* part : parts) {
      const CellSide side = side_of(*part, low, high);
      if (side == CellSide::kIn) {
        take(inside_, low, high);
        take(about_, low, high);
        return;
      }
      if (side == CellSide::kUnsure) left.push_back(part);
    }
    if (left.empty()) return;
    if (across == 1) {
      take(about_, low, high);
      return;
    }
    for (std::size_t i = 0; i < 8; ++i) {
      Index next = first;
      for (std::size_t k = 0; k < 3; ++k) next[k] += (i >> k & 1) * across / 2;
      divide(next, across / 2, left);
    }
  }

  Point corner(const Index& first, std::size_t across) const {
    return {at_[0][first[0] + across], at_[1][first[1] + across], at_[2][first[2] + across]};
  }

  static std::array<Point, 8> corners_of(const Point& low, const Point& high) {
    std::array<Point, 8> out;
    for (std::size_t i = 0; i < 8; ++i)
      out[i] = {(i & 1) != 0 ? high.x : low.x, (i & 2) != 0 ? high.y : low.y, (i & 4) != 0 ? high.z : low.z};
    return out;
  }

  static CellSide side_of(const CsgPart& part, const Point& low, const Point& high) {
    const std::array<Point, 8> corners = corners_of(low, high);
    const auto cell = std::make_shared<const Body>(space::body_of_part(space::part_of(corners, Real())));
    // The set is convex.
    const auto holds_all = [&](const BodyPart& set) {
      return std::all_of(corners.begin(), corners.end(),
                         [&](const Point& x) { return side(set, space::real(x)) <= 0; });
    };
    const auto beside = [&](const BodyPart& set) {
      const TriedAnswer gap =
          solid_pair(cell, std::make_shared<const Body>(space::body_of_part(set))).try_value(Which::kGamma1, {});
      return gap && *gap && *(*gap)->bounds().lower >= Real();
    };
    bool in = true;
    for (const BodyPart& set : part.within) {
      if (holds_all(set)) continue;
      if (beside(set)) return CellSide::kOut;
      in = false;
    }
    for (const BodyPart& set : part.without) {
      if (holds_all(set)) return CellSide::kOut;
      in = in && beside(set);
    }
    return in ? CellSide::kIn : CellSide::kUnsure;
  }

  static void take(std::vector<space::IntervalBox>& cells, const Point& low, const Point& high) {
    const RealVector from = space::real(low), to = space::real(high);
    space::IntervalBox box;
    for (std::size_t k = 0; k < 3; ++k) box[k] = {from[k], to[k], true, true};
    cells.push_back(box);
  }

  static double volume(const std::vector<space::IntervalBox>& cells) {
    double sum = 0;
    for (const space::IntervalBox& box : cells) {
      double one = 1;
      for (const space::Interval& side : box) one *= (*side.to - *side.from).to_double();
      sum += one;
    }
    return sum;
  }

  static std::optional<Body> body(const std::vector<space::IntervalBox>& cells) {
    if (cells.empty()) return std::nullopt;
    return space::body_of(space::BoxComplex::of_boxes(cells).simplified());
  }

  std::array<std::vector<std::int64_t>, 3> at_;
  std::vector<space::IntervalBox> inside_, about_;
};

/// Of a solid in which no cell lies; nothing where no place of the grid is found in it.
std::optional<Body> place_inside(const CsgSolid& solid) {
  const double size = cut_size({}, solid);
  for (const CsgPart& part : solid.parts) {
    const space::Vector at = csg_part_search(part, size).places.deepest({}).place;
    const Point near{std::llround(at.x), std::llround(at.y), std::llround(at.z)};
    if (holds(part, space::real(near))) return space::body_of_part({{}, near, Real()});
  }
  return std::nullopt;
}

}  // namespace

BodiesOfCells bodies_of_cells(const CsgSolid& solid, std::size_t across) {
  const SolidCells cells(solid, across);
  BodiesOfCells out{cells.inside(), cells.about(), cells.filled()};
  if (!out.inside) out.inside = place_inside(solid);
  return out;
}

}  // namespace findspace::distance
