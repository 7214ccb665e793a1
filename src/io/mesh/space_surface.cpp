// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "io/mesh/space_surface.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "space/box/box_topology.h"

namespace findspace::io {
namespace {

using exact::Real;
using Cell = std::array<int, 3>;

/// Collects the open faces between a box that is in and one that is out.
class BoxSurface {
 public:
  BoxSurface(const space::BoxComplex& solid, const Real& step) : solid_(solid), step_(step) {}

  Surface take() && {
    boundary(solid_).in().each([&](int x, int y, int z) {
      for (std::size_t k = 0; k < 3; ++k) add_face({x, y, z}, k);
    });
    return std::move(surface_);
  }

 private:
  bool in(const Cell& c) const { return solid_.mark(c[0], c[1], c[2]) != 0; }
  /// An open interval with two ends: the unbounded ones have no corners to draw.
  bool bounded(const Cell& c, std::size_t k) const {
    return c[k] % 2 == 0 && c[k] != 0 && c[k] != solid_.cells(static_cast<int>(k)) - 1;
  }

  /// The cell, if it is an open face across axis k on the boundary.
  void add_face(const Cell& c, std::size_t k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    if (c[k] % 2 == 0 || !bounded(c, i) || !bounded(c, j)) return;
    Cell below = c, above = c;
    --below[k];
    ++above[k];
    if (in(below) == in(above)) return;
    std::vector<int> face;
    for (const auto& [di, dj] : {std::pair{-1, -1}, std::pair{1, -1}, std::pair{1, 1}, std::pair{-1, 1}}) {
      Cell corner = c;
      corner[i] += di;
      corner[j] += dj;
      face.push_back(vertex(corner));
    }
    if (in(above)) std::reverse(face.begin(), face.end());
    surface_.faces.push_back(std::move(face));
  }

  int vertex(const Cell& at) {
    const auto [found, fresh] = numbers_.emplace(at, static_cast<int>(surface_.vertices.size()));
    if (fresh) {
      std::array<double, 3> p{};
      for (std::size_t k = 0; k < 3; ++k) p[k] = (solid_.at()[k][std::size_t(at[k] / 2)] * step_).to_double();
      surface_.vertices.push_back(p);
    }
    return found->second;
  }

  const space::BoxComplex& solid_;
  const Real& step_;
  Surface surface_;
  std::map<Cell, int> numbers_;
};

}  // namespace

Surface box_surface(const space::BoxComplex& set, const Real& step) {
  const space::BoxComplex solid = interior(set);
  return BoxSurface(solid, step).take();
}

Surface convex_surface(const space::ConvexSet& set, const Real& step) {
  Surface surface;
  for (const auto& v : set.region.vertices())
    surface.vertices.push_back(
        {(v.at[0] * step).to_double(), (v.at[1] * step).to_double(), (v.at[2] * step).to_double()});
  if (set.region.dimension() < 3) return surface;
  surface.faces = set.region.circuits();
  return surface;
}

}  // namespace findspace::io
