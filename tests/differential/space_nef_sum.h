// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Minkowski sums of solids by CGAL's Nef polyhedra, as an oracle for ray maps: the sum, its volume, whether it holds a
// point, and how the signs on rays agree with it at random places. Exact; slow, as CGAL cuts both solids into convex
// parts.
#pragma once

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_incremental_builder_3.h>
#include <CGAL/minkowski_sum_3.h>

#include <cmath>
#include <random>

#include "space/convolution/ray_pair.h"

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

/// A (+) -B: the positions at which A and B + p meet.
inline Nef difference(const Triangles& a, const Triangles& b) {
  Nef of_a = nef(a), of_b = nef(scaled(b, -1));
  return CGAL::minkowski_sum_3(of_a, of_b);
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

using Places = std::vector<std::array<double, 3>>;

/// The vertices around a facet's cycle.
inline Places circuit(Nef::SHalfedge_const_handle start) {
  Places ring;
  const Nef::SHalfedge_around_facet_const_circulator first(start);
  Nef::SHalfedge_around_facet_const_circulator e = first;
  do {
    const auto& p = e->source()->center_vertex()->point();
    ring.push_back({CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())});
  } while (++e != first);
  return ring;
}

/// Of a bounded set: a third of the flow of x through the facets of what belongs to it. In doubles.
inline double volume(const Nef& set) {
  double sum = 0;
  for (Nef::Halffacet_const_iterator f = set.halffacets_begin(); f != set.halffacets_end(); ++f) {
    if (!f->incident_volume()->mark()) continue;
    for (Nef::Halffacet_cycle_const_iterator c = f->facet_cycles_begin(); c != f->facet_cycles_end(); ++c) {
      if (!c.is_shalfedge()) continue;
      const Places ring = circuit(c);
      for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
        const auto &p = ring[0], &q = ring[i], &r = ring[i + 1];
        for (std::size_t k = 0; k < 3; ++k)
          sum += p[k] * (q[(k + 1) % 3] * r[(k + 2) % 3] - q[(k + 2) % 3] * r[(k + 1) % 3]) / 6;
      }
    }
  }
  return std::fabs(sum);
}

struct Agreement {
  int inside = 0, touching = 0, differing = 0;
};

/// The signs on lines x lines rays against `sum`, which is difference(a, b), at random places of random lines. Places
/// where the solids only touch are counted and passed over.
inline Agreement agreement(const Nef& sum, const Triangles& a, const Triangles& b, int lines, int places) {
  const RayBody body(a), other(b);
  const RayGrid grid = ray_grid(body.low - other.high, body.high - other.low, 2, lines);
  const PairRays rays(a, b, grid);
  const std::vector<RayRow> rows = all_rows(rays);
  std::mt19937 random(3);
  const auto pick = [&](std::int64_t low, std::int64_t high) {
    return std::uniform_int_distribution<std::int64_t>(low, high)(random);
  };
  Agreement out;
  for (int k = 0; k < places; ++k) {
    const int i = static_cast<int>(pick(0, grid.nu - 1)), j = static_cast<int>(pick(0, grid.nv - 1));
    const std::int64_t z = pick((body.low.z - other.high.z) * grid.parts, (body.high.z - other.low.z) * grid.parts);
    const int sign = sign_at(rows[static_cast<std::size_t>(j)], i, exact::Real(z));
    out.touching += sign == 0;
    if (sign == 0) continue;
    const Kernel::FT parts(static_cast<double>(grid.parts));
    const auto c = [&](std::int64_t v) { return Kernel::FT(static_cast<double>(v)) / parts; };
    const bool covered = holds(sum, Kernel::Point_3(c(grid.u_at(i)), c(grid.v_at(j)), c(z)));
    out.differing += (sign < 0) != covered;
    out.inside += covered;
  }
  return out;
}

}  // namespace findspace::space::nef_oracle
