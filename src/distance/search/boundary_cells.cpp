// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/search/boundary_cells.h"

namespace findspace::distance {

using space::Vector;

space::Extent askew(const space::Extent& box) {
  const Vector wide = box.high - box.low;
  return {box.low - Vector{0.0371 * wide.x, 0.0493 * wide.y, 0.0287 * wide.z},
          space::plus(box.high, {0.0231 * wide.x, 0.0419 * wide.y, 0.0527 * wide.z})};
}

double longest_edge(const Tetrahedron& t, std::size_t& a, std::size_t& b) {
  double most = -1;
  for (std::size_t v = 0; v < 4; ++v) {
    for (std::size_t w = v + 1; w < 4; ++w) {
      const double d = space::length(t[v] - t[w]);
      if (d > most) {
        most = d;
        a = v;
        b = w;
      }
    }
  }
  return most;
}

Vector centre(const Tetrahedron& t) {
  return space::scaled(0.25, space::plus(space::plus(t[0], t[1]), space::plus(t[2], t[3])));
}

std::array<Tetrahedron, 2> halves(const Tetrahedron& t, std::size_t a, std::size_t b) {
  std::array<Tetrahedron, 2> out{t, t};
  out[0][a] = out[1][b] = space::scaled(0.5, space::plus(t[a], t[b]));
  return out;
}

Vector mean(const std::array<double, 4>& weights, const Tetrahedron& t) {
  Vector out;
  for (std::size_t v = 0; v < 4; ++v) out = space::plus(out, space::scaled(weights[v], t[v]));
  return out;
}

void TetrahedralCell::draw(plane::ObservedCells& seen) const {
  const auto at = [&](std::size_t v) { return plane::StageDrawing::Corner{corner[v].x, corner[v].y, corner[v].z}; };
  seen.add_tetrahedron({at(0), at(1), at(2), at(3)});
}

double beyond_faces(const Tetrahedron& t, const Vector& x) {
  double out = -exact::kInfinity;
  for (std::size_t v = 0; v < 4; ++v) {
    const Vector& a = t[(v + 1) % 4];
    const Vector n = space::cross(t[(v + 2) % 4] - a, t[(v + 3) % 4] - a);
    const double own = space::dot(n, t[v] - a), there = space::dot(n, x - a), size = space::length(n);
    out = std::max(out, (own > 0 ? -there : there) / size);
  }
  return out;
}

}  // namespace findspace::distance
