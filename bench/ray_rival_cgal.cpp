// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The Minkowski sum of the pairs of ray_bench by CGAL's Nef polyhedra (minkowski_sum_3), which cuts both bodies into
// convex parts. usage: ray_rival_cgal SPOT.obj FACES
#include <sys/resource.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>

#include "differential/space_nef_sum.h"
#include "ray_inputs.h"

namespace {

using findspace::space::nef_oracle::nef;
using findspace::space::nef_oracle::Nef;

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
  const double volume = findspace::space::nef_oracle::volume(sum);
  std::printf("CGAL minkowski_sum_3: %zu + 8 triangles: %.2f s (processor %.0f), volume %.6f, peak %.0f MiB\n",
              spot.faces.size(), seconds, processor, volume / (ray_bench::kUnit * ray_bench::kUnit * ray_bench::kUnit),
              static_cast<double>(usage.ru_maxrss) / 1024);
  return 0;
}
