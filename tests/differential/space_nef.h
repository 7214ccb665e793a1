// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Overlap of solids on rays against CGAL's Minkowski sum of Nef polyhedra at random places of random lines.
#pragma once

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_incremental_builder_3.h>
#include <CGAL/minkowski_sum_3.h>
#include <gtest/gtest.h>

#include <random>

#include "space/ray_pair.h"

namespace findspace::space::nef_oracle {

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

inline Nef nef(const Triangles& t) {
  Polyhedron p;
  Build build(t);
  p.delegate(build);
  return Nef(p);
}

inline bool holds(const Nef& set, const Kernel::Point_3& p) {
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
inline void compare(const Triangles& a, const Triangles& b, int places) {
  Nef of_a = nef(a), of_b = nef(scaled(b, -1));
  const Nef sum = CGAL::minkowski_sum_3(of_a, of_b);
  const RayBody body(a), other(b);
  const RayGrid grid = ray_grid(body.low - other.high, body.high - other.low, 2, 24);
  const PairRays rays(a, b, grid);
  const std::vector<RayRow> rows = all_rows(rays);
  std::mt19937 random(3);
  const auto pick = [&](std::int64_t low, std::int64_t high) {
    return std::uniform_int_distribution<std::int64_t>(low, high)(random);
  };
  int inside = 0;
  for (int k = 0; k < places; ++k) {
    const int i = static_cast<int>(pick(0, grid.nu - 1)), j = static_cast<int>(pick(0, grid.nv - 1));
    const std::int64_t z = pick((body.low.z - other.high.z) * grid.parts, (body.high.z - other.low.z) * grid.parts);
    const int sign = sign_at(rows[static_cast<std::size_t>(j)], i, exact::Real(z));
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

}  // namespace findspace::space::nef_oracle
