// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/ray_pair.h"

#include <findspace/error.h>

#include "space/ray_row.h"

namespace findspace::space {
namespace {

Triangles prepared(const Triangles& t, const RayGrid& grid) {
  for (const Point& p : t.points) {
    for (const std::int64_t c : {p.x, p.y, p.z}) {
      if (c > exact::kRayLimit / grid.parts || c < -exact::kRayLimit / grid.parts) {
        throw Error(ErrorCode::kOutOfRange, "a coordinate times the parts of the ray grid exceeds 2^38");
      }
    }
  }
  return with_axis(scaled(t, grid.parts), grid.axis);
}

}  // namespace

PairRays::PairRays(const Triangles& a, const Triangles& b, const RayGrid& grid, Side side_of_a)
    : complement_(side_of_a == Side::kComplement),
      a_(complement_ ? turned_inside_out(prepared(a, grid)) : prepared(a, grid)),
      b_(prepared(b, grid)),
      base_winding_(complement_ ? b_.euler() : 0),
      overlap_(a_, b_, complement_) {
  const RayBody mirrored(scaled(prepared(b, grid), -1));
  sheets_ = std::make_unique<Sheets>(convolution(a_, mirrored), grid);
}

RayRow PairRays::row(int j) const { return RowWork(*this, j).run(); }

}  // namespace findspace::space
