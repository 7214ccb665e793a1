// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Ray maps of small pairs against CGAL's Minkowski sums of Nef polyhedra: membership at random places, and volumes, on
// N x N lines along z and on those of all three axes. usage: ray_nef SPOT.obj [N [PLACES [PAIR]]]
// Only pairs whose name holds PAIR. One line of a table a pair and order.
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>

#include "differential/space_nef_sum.h"
#include "differential/space_voxels.h"
#include "differential/space_wheels.h"
#include "ray_inputs.h"
#include "space/convolution/mesh_crossing.h"
#include "space/rays/ray_axes.h"

namespace {

using namespace findspace::space;  // NOLINT: a table of its shapes

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

double volume_on_lines(const Triangles& a, const Triangles& b, int n) {
  const RayBody body(a), other(b);
  const Point low = body.low - other.high, high = body.high - other.low;
  const RayGrid grid = ray_grid(low, high, 2, n);
  RaySummarizer summarizer(grid, low, high);
  each_row(PairRays(a, b, grid), [&](int j, RayRow&& row) { summarizer.add(j, row); });
  return summarizer.finish().volume;
}

double volume_on_axes(const Triangles& a, const Triangles& b, int n) {
  const RayBody body(a), other(b);
  const RayLattice lattice = ray_lattice(body.low - other.high, body.high - other.low, n);
  const auto source = [&](int axis) { return std::make_unique<PairRays>(a, b, lattice.grid(axis)); };
  return ray_axes(lattice, source, [](std::int8_t sign) { return sign <= 0; }).summary.volume;
}

void line(const char* name, const Triangles& a, const Triangles& b, int n, int places) {
  const double start = now();
  const auto sum = nef_oracle::difference(a, b);
  const double cgal = now() - start, exact = nef_oracle::volume(sum);
  const auto found = nef_oracle::agreement(sum, a, b, n, places);
  const double z_start = now(), on_lines = volume_on_lines(a, b, n), ours = now() - z_start;
  const double on_axes = volume_on_axes(a, b, n);
  std::printf("| %s | %zu, %zu | %d | %d | %d | %.9g | %.1e | %.1e | %.2f | %.3f |\n", name, a.faces.size(),
              b.faces.size(), found.inside, found.touching, found.differing, exact, (on_lines - exact) / exact,
              (on_axes - exact) / exact, cgal, ours);
  std::fflush(stdout);
}

Triangles whole(Triangles mesh) {
  if (self_contact(RaySheet(mesh)).crossing) {
    std::fprintf(stderr, "a mesh crosses itself\n");
    std::exit(1);
  }
  return mesh;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "usage: ray_nef SPOT.obj [N [PLACES [PAIR]]]\n");
    return 2;
  }
  const int n = argc > 2 ? std::atoi(argv[2]) : 512, places = argc > 3 ? std::atoi(argv[3]) : 100000;
  const std::string only = argc > 4 ? argv[4] : "";
  const LinearMap skew{{{100, 17, 3}, {-9, 90, 11}, {5, -13, 120}}}, tilt{{{50, 3, -8}, {7, 40, 9}, {-5, 2, 60}}};
  const Triangles bracket = moved(surface(extruded({"##", "#."}, 1), skew), {1000, -500, 77});
  const Triangles wheel = moved(gear(5, 40, 90, 60), {-30, 40, 500});
  const Triangles ring = moved(torus(200, 70, 8, 5), {77, 5, -60}), block = surface(extruded({"#"}, 1), tilt);
  const Triangles frame = surface(extruded({"###", "#.#", "###"}, 1), skew), small_ring = torus(60, 15, 6, 4);
  const Triangles u = surface(extruded({"#.#..#", "######"}, 1), stretch(10)),
                  cube = surface(extruded({"#"}, 1), stretch(10));
  const Triangles spot = whole(ray_bench::coarser(ray_bench::read_obj(argv[1]), 300));
  const Triangles octahedron = moved(ray_bench::octahedron(0.2), {300000, -50000, 20000});
  struct Pair {
    const char *name, *back;
    const Triangles &a, &b;
  };
  const Pair pairs[] = {{"L-bracket, gear", "gear, L-bracket", bracket, wheel},
                        {"torus, block", "block, torus", ring, block},
                        {"torus in a hole", "frame about a torus", frame, small_ring},
                        {"passage of no width", "passage of no width, back", u, cube},
                        {"Spot, octahedron", "octahedron, Spot", spot, octahedron}};
  std::printf(
      "| pair | triangles | of %d places inside | touching | differing | volume by CGAL | ours on %d x %d lines "
      "| on three axes | CGAL s | ours s |\n|---|---|---|---|---|---|---|---|---|---|\n",
      places, n, n);
  for (const Pair& p : pairs) {
    if (std::string(p.name).find(only) != std::string::npos) line(p.name, p.a, p.b, n, places);
    if (std::string(p.back).find(only) != std::string::npos) line(p.back, p.b, p.a, n, places);
  }
  return 0;
}
