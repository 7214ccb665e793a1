// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Distances in and of meshes: by the cells of the mesh and by subtracting its convex parts from a box, which differ by
// the roundings of these only; of hundreds of faces, for which the parts cut each other into too many pieces, against
// the mesh itself.
#include <gtest/gtest.h>

#include "distance/solid/solid_pair.h"
#include "unit/space_bodies.h"
#include "unit/space_bumps.h"

namespace findspace::distance {
namespace distance_solid_mesh {

using exact::Real;
using space::Body;
using space::RealVector;

Body octahedron(std::int64_t r) {
  Body b;
  const std::vector<space::Point> points{{r, 0, 0}, {-r, 0, 0}, {0, r, 0}, {0, -r, 0}, {0, 0, r}, {0, 0, -r}};
  b.parts.push_back({space::Polytope::hull(points), {}, Real()});
  return b;
}

Body ball(std::int64_t r) {
  Body b;
  b.parts.push_back({std::nullopt, {}, Real(r)});
  return b;
}

double number(const std::optional<Answer>& v) { return v ? v->value.to_double() : INFINITY; }

TEST(SolidMesh, CellsAndSubtractedParts) {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const Body a = space::body_of(space::knobbly_ball(2, 100000, seed));
    Body parts = a;
    parts.around.clear();
    for (const Body& small : {octahedron(20000), ball(15000)}) {
      const Body b = space::at_scale(small, a.scale);
      const PairDistances one = solid_pair(space::shared(b), space::shared(a)),
                          other = solid_pair(space::shared(b), space::shared(parts));
      std::mt19937 engine(seed);
      for (int i = 0; i < 4; ++i) {
        RealVector p;
        for (Real& c : p) c = Real(a.scale) * Real(static_cast<std::int64_t>(engine() % 200001) - 100000);
        for (const Which w : {Which::kEta1, Which::kEta2, Which::kMu, Which::kDstarBack})
          EXPECT_NEAR(number(one.value(w, p)), number(other.value(w, p)), 1e-8 * 1e5 * double(a.scale) + 8 * a.moved);
      }
    }
  }
}

TEST(SolidMesh, OfHundredsOfFaces) {
  const space::Mesh mesh = space::knobbly_ball(7, 1000000, 11);
  const Body a = space::body_of(mesh), b = octahedron(150000);
  const PairDistances pair = solid_pair(space::shared(b), space::shared(a));
  std::mt19937 engine(2);
  for (int i = 0; i < 12; ++i) {
    RealVector p;
    for (Real& c : p) c = Real(static_cast<std::int64_t>(engine() % 1800001) - 900000);
    const double eta = number(pair.value(Which::kEta1, p)), mu = number(pair.value(Which::kMu, p));
    // The distance to where it does not fit is that of its points to the mesh: no face is nearer, and with -eta one is.
    bool fits = true;
    for (const auto& face : mesh.faces) {
      for (const int v : face) {
        const RealVector at = space::minus(space::real(mesh.vertices[static_cast<std::size_t>(v)]), p);
        bool inside = true;
        for (const space::HalfSpace& h : b.parts[0].planes()) inside = inside && h.value(at).sign() < 0;
        fits = fits && !inside;
      }
    }
    for (const space::Point& v : b.parts[0].vertices())
      fits = fits && space::side_of_star(mesh, space::plus(p, space::real(v))) >= 0;
    if (!fits) {
      EXPECT_GT(eta, 0);
    }
    if (eta <= 0) {
      EXPECT_NEAR(eta, mu, 1e-6 * 1e6);
    }
    if (eta > 0) {
      EXPECT_GT(mu, -1);
    }
    EXPECT_LE(mu, eta + 1e-6);
  }
}

}  // namespace distance_solid_mesh
}  // namespace findspace::distance
