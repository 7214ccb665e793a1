// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Shapes on different grids come together on one that holds both.

#include <fmt/format.h>

#include <numeric>

#include "api/values/shape_data.h"
#include "findspace/error.h"
#include "plane/query/scaled.h"
#include "space/polytope/solid.h"

namespace findspace::api {

using exact::int128;
using exact::Real;

namespace {

/// Numbers times a factor, within the grid.
class Scaling {
 public:
  explicit Scaling(std::int64_t factor) : factor_(factor), length_(factor) {}

  std::int64_t operator()(std::int64_t v) const {
    const int128 scaled = int128(v) * factor_;
    if (scaled > plane::Grid::kLimit || scaled < -plane::Grid::kLimit)
      throw Error(ErrorCode::kOutOfRange, "a shape leaves the finer grid of the one it is combined with");
    return std::int64_t(scaled);
  }
  Real operator()(const Real& v) const { return v * length_; }
  plane::GridPoint operator()(const plane::GridPoint& p) const { return {(*this)(p.x), (*this)(p.y)}; }
  void operator()(std::vector<plane::Contour>& contours) const {
    for (plane::Contour& contour : contours)
      for (plane::ContourEdge& e : contour) {
        e.start = (*this)(e.start);
        if (e.arc)
          e.arc = std::make_shared<const plane::ArcCircle>(
              plane::ArcCircle{(*this)(e.arc->cx), (*this)(e.arc->cy), (*this)(e.arc->r)});
      }
  }
  plane::ShapePtr operator()(const plane::Shape& shape) const {
    plane::Shape out = shape;
    for (plane::ShapePtr& child : out.children) child = (*this)(*child);
    (*this)(out.contours);
    for (plane::GridPoint& p : out.points) p = (*this)(p);
    out.amount = (*this)(out.amount);
    out.lift = (*this)(out.lift);
    if (out.cells) out.cells = std::make_shared<const plane::CellComplex>(plane::scaled(*out.cells, factor_));
    if (const space::Solid* given = space::solid_of(shape)) out.solid = solid(*given);
    return std::make_shared<const plane::Shape>(std::move(out));
  }

 private:
  std::shared_ptr<const space::Solid> solid(space::Solid out) const {
    for (space::Point& v : out.mesh.vertices) v = {(*this)(v.x), (*this)(v.y), (*this)(v.z)};
    (*this)(out.contours);
    out.radius = (*this)(out.radius);
    out.low = (*this)(out.low);
    out.high = (*this)(out.high);
    return std::make_shared<const space::Solid>(std::move(out));
  }

  std::int64_t factor_;
  Real length_;
};

int128 common_divisor(int128 a, int128 b) {
  while (b != 0) {
    const int128 rest = a % b;
    a = b;
    b = rest;
  }
  return a;
}

[[noreturn]] void no_common(const plane::Grid& a, const plane::Grid& b) {
  throw Error(ErrorCode::kOutOfRange,
              fmt::format("no grid of 2^40 steps holds both grids, {} and {}", a.step().text(), b.step().text()));
}

}  // namespace

plane::Grid common_grid(const plane::Grid& a, const plane::Grid& b) {
  if (a.step() == b.step()) return a;
  // Of p/q and r/s in lowest terms the largest step that both are multiples of: gcd(p s, r q) / (q s).
  const auto p = a.step().fraction(), r = b.step().fraction();
  constexpr int128 kMost = int128(1) << 62;
  for (const auto& f : {p, r})
    if (!f || (*f)[0] > kMost || (*f)[1] > kMost) no_common(a, b);
  const int128 first = (*p)[0] * (*r)[1], second = (*r)[0] * (*p)[1];
  const Real step = Real(common_divisor(first, second)) / (Real((*p)[1]) * Real((*r)[1]));
  if (abs(a.step() / step) > Real(plane::Grid::kLimit) || abs(b.step() / step) > Real(plane::Grid::kLimit))
    no_common(a, b);
  return plane::Grid(step);
}

plane::ShapePtr tree_on(const Shape& shape, const plane::Grid& grid) {
  const Real factor = shape.data().grid.step() / grid.step();
  if (factor == Real(1)) return tree_of(shape);
  return Scaling(std::int64_t(*factor.integer()))(*tree_of(shape));
}

}  // namespace findspace::api
