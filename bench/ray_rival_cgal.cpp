// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The Minkowski sum of the pairs of ray_bench by CGAL's Nef polyhedra (minkowski_sum_3), which cuts both bodies into
// convex parts. usage: ray_rival_cgal SPOT.obj FACES
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_incremental_builder_3.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/minkowski_sum_3.h>
#include <sys/resource.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>

#include "ray_inputs.h"

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Nef = CGAL::Nef_polyhedron_3<Kernel>;

struct Build : CGAL::Modifier_base<Polyhedron::HalfedgeDS> {
  const ray_bench::Triangles& t;
  explicit Build(const ray_bench::Triangles& mesh) : t(mesh) {}
  void operator()(Polyhedron::HalfedgeDS& hds) override {
    CGAL::Polyhedron_incremental_builder_3<Polyhedron::HalfedgeDS> b(hds, true);
    b.begin_surface(t.points.size(), t.faces.size());
    for (const auto& p : t.points)
      b.add_vertex(Kernel::Point_3(static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)));
    for (const auto& f : t.faces) {
      b.begin_facet();
      for (const int v : f) b.add_vertex_to_facet(v);
      b.end_facet();
    }
    b.end_surface();
  }
};

Nef nef(const ray_bench::Triangles& t) {
  Polyhedron p;
  Build build(t);
  p.delegate(build);
  // Nef polyhedra of surfaces that cross themselves make the cut into convex parts run for ever.
  if (CGAL::Polygon_mesh_processing::does_self_intersect(p)) {
    std::fprintf(stderr, "the mesh of %zu triangles crosses itself: take another number\n", t.faces.size());
    std::exit(1);
  }
  return Nef(p);
}

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) return 2;
  const ray_bench::Triangles spot = ray_bench::coarser(ray_bench::read_obj(argv[1]), std::atoi(argv[2]));
  const double start = now();
  Nef a = nef(spot), b = nef(ray_bench::octahedron(0.2));
  const Nef sum = CGAL::minkowski_sum_3(a, b);
  const double seconds = now() - start;
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const double processor = static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec);
  Polyhedron surface;
  sum.convert_to_polyhedron(surface);
  CGAL::Polygon_mesh_processing::triangulate_faces(surface);
  const double volume = CGAL::to_double(CGAL::Polygon_mesh_processing::volume(surface));
  std::printf("CGAL minkowski_sum_3: %zu + 8 triangles: %.2f s (processor %.0f), volume %.6f, peak %.0f MiB\n",
              spot.faces.size(), seconds, processor, volume / (ray_bench::kUnit * ray_bench::kUnit * ray_bench::kUnit),
              static_cast<double>(usage.ru_maxrss) / 1024);
  return 0;
}
