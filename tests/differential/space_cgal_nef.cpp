// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Overlap of solids that are not convex on rays against CGAL's Minkowski sum of Nef polyhedra: random positions on the
// lines, operands off the origin, in both orders, a body in the hole of a ring, and a passage of no width.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_incremental_builder_3.h>
#include <CGAL/minkowski_sum_3.h>
#include <gtest/gtest.h>

#include <random>

#include "differential/space_voxels.h"
#include "space/ray_pair.h"

namespace findspace::space {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Nef = CGAL::Nef_polyhedron_3<Kernel>;

struct Build : CGAL::Modifier_base<Polyhedron::HalfedgeDS> {
  const Triangles& t;
  explicit Build(const Triangles& mesh) : t(mesh) {}
  void operator()(Polyhedron::HalfedgeDS& hds) override {
    CGAL::Polyhedron_incremental_builder_3<Polyhedron::HalfedgeDS> b(hds, true);
    b.begin_surface(t.points.size(), t.faces.size());
    for (const Point& p : t.points)
      b.add_vertex(Kernel::Point_3(static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)));
    for (const auto& f : t.faces) {
      b.begin_facet();
      for (const int v : f) b.add_vertex_to_facet(static_cast<std::size_t>(v));
      b.end_facet();
    }
    b.end_surface();
  }
};

Nef nef(const Triangles& t) {
  Polyhedron p;
  Build build(t);
  p.delegate(build);
  return Nef(p);
}

bool holds(const Nef& set, const Kernel::Point_3& p) {
  const Nef::Object_handle at = set.locate(p);
  Nef::Volume_const_handle volume;
  Nef::Halffacet_const_handle facet;
  Nef::Halfedge_const_handle edge;
  Nef::Vertex_const_handle vertex;
  if (CGAL::assign(volume, at)) return volume->mark();
  if (CGAL::assign(facet, at)) return facet->mark();
  if (CGAL::assign(edge, at)) return edge->mark();
  return CGAL::assign(vertex, at) && vertex->mark();
}

/// A (+) -B against the rays at random places of random lines. Places where the solids only touch are passed over.
void compare(const Triangles& a, const Triangles& b, int places) {
  Nef of_a = nef(a), of_b = nef(scaled(b, -1));
  const Nef sum = CGAL::minkowski_sum_3(of_a, of_b);
  const RayBody body(a), other(b);
  const RayGrid grid = ray_grid(body.low - other.high, body.high - other.low, 2, 24);
  const PairRays rays(a, b, grid);
  std::mt19937 random(3);
  const auto pick = [&](std::int64_t low, std::int64_t high) {
    return std::uniform_int_distribution<std::int64_t>(low, high)(random);
  };
  int inside = 0;
  for (int k = 0; k < places; ++k) {
    const int i = static_cast<int>(pick(0, grid.nu - 1)), j = static_cast<int>(pick(0, grid.nv - 1));
    const std::int64_t z = pick((body.low.z - other.high.z) * grid.parts, (body.high.z - other.low.z) * grid.parts);
    const int sign = sign_at(rays.row(j), i, exact::Real(z));
    if (sign == 0) continue;
    const Kernel::FT parts(static_cast<double>(grid.parts));
    const auto c = [&](std::int64_t v) { return Kernel::FT(static_cast<double>(v)) / parts; };
    const bool covered = holds(sum, Kernel::Point_3(c(grid.u_at(i)), c(grid.v_at(j)), c(z)));
    ASSERT_EQ(sign < 0, covered) << i << " " << j << " " << z;
    inside += covered;
  }
  EXPECT_GT(inside, places / 20);
  EXPECT_LT(inside, places);
}

const LinearMap kSkew{{{100, 17, 3}, {-9, 90, 11}, {5, -13, 120}}}, kTilt{{{50, 3, -8}, {7, 40, 9}, {-5, 2, 60}}};

TEST(NefCgal, BracketAndCube) {
  const Triangles bracket = moved(surface(extruded({"##", "#."}, 1), kSkew), {1000, -500, 77});
  const Triangles cube = moved(surface(extruded({"#"}, 1), kTilt), {-30, 40, 500});
  compare(bracket, cube, 400);
  compare(cube, bracket, 400);
}

TEST(NefCgal, BarInTheHoleOfARing) {
  compare(surface(extruded({"###", "#.#", "###"}, 1), kSkew), surface(extruded({"#"}, 3), stretch(20)), 300);
}

TEST(NefCgal, BracketsOnALattice) {
  const Triangles u = surface(extruded({"#.#..#", "######"}, 1), stretch(10)),
                  cube = surface(extruded({"#"}, 1), stretch(10));
  compare(u, cube, 400);  // the cube just fits in: a passage of no width
}

}  // namespace
}  // namespace findspace::space
