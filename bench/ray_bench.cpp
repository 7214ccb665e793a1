// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Ray maps of pairs of meshes at n x n lines, from triangles to the events of every line.
// usage: ray_bench SPOT.obj [N [ROW]]
// Only rows whose name holds ROW. Prints seconds with one thread and with all, the convolution alone, what it took,
// volume, and the max_min resident memory.
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "differential/space_wheels.h"
#include "plane/base/parallel.h"
#include "ray_inputs.h"
#include "space/convolution/ray_ball.h"
#include "space/convolution/ray_pair.h"

namespace {

using findspace::plane::ThreadLimit;
using findspace::space::PairRays;
using findspace::space::RayBody;
using findspace::space::RayGrid;
using findspace::space::RayRow;
using ray_bench::Triangles;

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

double cpu() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

double peak_mib() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

/// In units, of the places with sign -.
double volume(const findspace::space::RaySource& rays) {
  double sum = 0;
  const RayGrid& grid = rays.grid();
  findspace::space::each_row(rays, [&](int, RayRow&& row) {
    for (int i = 0; i < grid.nu; ++i) {
      double from = 0;
      int sign = row.before[i];
      for (int e = row.first[i]; e < row.first[i + 1]; ++e) {
        if (sign < 0) sum += row.events[e].at.value - from;
        from = row.events[e].at.value;
        sign = row.events[e].after;
      }
    }
  });
  const double unit = ray_bench::kUnit * static_cast<double>(grid.parts);
  return sum * static_cast<double>(grid.du) * static_cast<double>(grid.dv) / (unit * unit * unit);
}

struct Run {
  double total = 1e9, cpu = 1e9, convolution = 1e9, volume = 0;
};

/// A grown by a ball.
Run once_ball(const Triangles& a, double radius, int n) {
  Run run;
  const double start = now(), start_cpu = cpu();
  const auto r = static_cast<std::int64_t>(radius * ray_bench::kUnit);
  ray_bench::Point low = a.points[0], high = low;
  for (const ray_bench::Point& p : a.points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const ray_bench::Point margin{r, r, r};
  const RayGrid grid = findspace::space::ray_grid(low - margin, high + margin, 2, n);
  const findspace::space::BallRays rays(a, findspace::exact::Real(r), grid);
  run.convolution = cpu() - start_cpu;
  run.volume = volume(rays);
  run.total = now() - start;
  run.cpu = cpu() - start_cpu;
  std::printf("  cells decided by distance %ld, lines done exactly %ld\n", static_cast<long>(rays.cell_tests()),
              static_cast<long>(rays.exact_lines()));
  return run;
}

Run once(const Triangles& a, const Triangles& b, int n) {
  Run run;
  const double start = now(), start_cpu = cpu();
  const RayBody p(a), q(b);
  const RayGrid grid = findspace::space::ray_grid(p.low - q.high, p.high - q.low, 2, n);
  const PairRays rays(a, b, grid);
  run.convolution = cpu() - start_cpu;
  run.volume = volume(rays);
  run.total = now() - start;
  run.cpu = cpu() - start_cpu;
  const auto& c = rays.counts();
  std::printf("  tests: cells %ld walls %ld sheets %ld, dirty lines %ld, lines met %ld\n",
              static_cast<long>(c.cell_tests), static_cast<long>(c.wall_tests), static_cast<long>(c.sheet_tests),
              static_cast<long>(c.dirty_lines), static_cast<long>(c.hits));
  return run;
}

std::string only;

template <class Once>
void line(const std::string& name, int n, Once measure) {
  if (name.find(only) == std::string::npos) return;
  std::printf("%s, %d x %d lines\n", name.c_str(), n, n);
  Run one, all;
  for (int round = 0; round < 3; ++round) {
    {
      const ThreadLimit limit(1);
      const Run r = measure();
      if (r.cpu < one.cpu) one = r;
    }
    const Run r = measure();
    if (r.total < all.total) all = r;
  }
  std::printf(
      "  one thread %.3f s (processor %.3f, of it %.3f before the first line), all threads %.3f s (processor %.3f), "
      "volume %.6f, peak %.0f MiB\n",
      one.total, one.cpu, one.convolution, all.total, all.cpu, one.volume, peak_mib());
  std::fflush(stdout);
}

void pair_line(const char* name, const Triangles& a, const Triangles& b, int n) {
  line(
      std::string(name) + ": " + std::to_string(a.faces.size()) + " + " + std::to_string(b.faces.size()) + " triangles",
      n, [&] { return once(a, b, n); });
}

void ball_line(const char* name, const Triangles& a, double radius, int n) {
  line(std::string(name) + ": " + std::to_string(a.faces.size()) + " triangles + ball of radius " +
           std::to_string(radius),
       n, [&] { return once_ball(a, radius, n); });
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "usage: ray_bench SPOT.obj [N [ROW]]\n");
    return 2;
  }
  const int n = argc > 2 ? std::atoi(argv[2]) : 512;
  only = argc > 3 ? argv[3] : "";
  const Triangles spot = ray_bench::read_obj(argv[1]), spot2000 = ray_bench::coarser(spot, 2000);
  pair_line("spot and octahedron", spot2000, ray_bench::octahedron(0.2), n);
  using ray_bench::kUnit;
  const Triangles torus = findspace::space::torus(0.25 * kUnit, 0.08 * kUnit, 24, 10);
  pair_line("spot and torus", spot2000, torus, n);
  const Triangles bumpy = ray_bench::bumpy_sphere(1, 0.3, 4, 40, 26);
  pair_line("bumpy sphere and torus", bumpy, torus, n);
  ball_line("bumpy sphere", ray_bench::bumpy_sphere(1, 0.3, 4, 320, 158), 0.1, n);
  ball_line("spot", spot, 0.1, n);
  return 0;
}
