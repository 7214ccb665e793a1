// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The grown meshes of ray_bench by OpenVDB, on voxels as wide as the lines are apart: a narrow level set moved outwards
// by its filter, and a level set whose outer band is as wide as the ball's radius, read at that level.
// usage: ray_rival_openvdb SPOT.obj [N]
// Prints seconds with one thread and with all, the volume within, and the max_min resident memory of each way.
#include <openvdb/openvdb.h>
#include <openvdb/tools/LevelSetFilter.h>
#include <openvdb/tools/LevelSetMeasure.h>
#include <openvdb/tools/LevelSetRebuild.h>
#include <openvdb/tools/MeshToVolume.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <tbb/global_control.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "ray_inputs.h"
#include "space/rays/ray_map.h"

namespace {

using ray_bench::Triangles;

struct Mesh {
  std::vector<openvdb::Vec3s> points;
  std::vector<openvdb::Vec3I> faces;
  double voxel = 0;  // as far apart as the n lines of ray_bench
};

Mesh mesh_of(const Triangles& t, double radius, int n) {
  Mesh out;
  const auto r = static_cast<std::int64_t>(radius * ray_bench::kUnit);
  ray_bench::Point low = t.points[0], high = low;
  for (const ray_bench::Point& p : t.points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    const auto unit = [](std::int64_t c) { return static_cast<float>(static_cast<double>(c) / ray_bench::kUnit); };
    out.points.emplace_back(unit(p.x), unit(p.y), unit(p.z));
  }
  for (const auto& f : t.faces) out.faces.emplace_back(f[0], f[1], f[2]);
  const ray_bench::Point margin{r, r, r};
  const auto grid = findspace::space::ray_grid(low - margin, high + margin, 2, n);
  out.voxel = static_cast<double>(std::max(grid.du, grid.dv)) / static_cast<double>(grid.parts) / ray_bench::kUnit;
  return out;
}

/// A narrow band, moved outwards step by step.
double by_filter(const Mesh& mesh, double radius) {
  const auto transform = openvdb::math::Transform::createLinearTransform(mesh.voxel);
  auto grid = openvdb::tools::meshToLevelSet<openvdb::FloatGrid>(*transform, mesh.points, mesh.faces);
  openvdb::tools::LevelSetFilter<openvdb::FloatGrid> filter(*grid);
  filter.offset(static_cast<float>(-radius));
  return openvdb::tools::levelSetVolume(*grid);
}

/// The distance itself out to the radius, and the narrow band about that level.
double by_wide_band(const Mesh& mesh, double radius) {
  const auto transform = openvdb::math::Transform::createLinearTransform(mesh.voxel);
  const std::vector<openvdb::Vec4I> quads;
  const auto outer = static_cast<float>(radius / mesh.voxel + 4), inner = 4.0F;
  auto grid = openvdb::tools::meshToSignedDistanceField<openvdb::FloatGrid>(*transform, mesh.points, mesh.faces, quads,
                                                                            outer, inner);
  grid = openvdb::tools::levelSetRebuild(*grid, static_cast<float>(radius), 3.0F);
  return openvdb::tools::levelSetVolume(*grid);
}

/// In a process of its own, so that the memory is its own.
void in_process(const std::string& name, std::size_t threads, const std::function<double()>& run) {
  std::fflush(stdout);
  const pid_t child = fork();
  if (child != 0) {
    waitpid(child, nullptr, 0);
    return;
  }
  openvdb::initialize();
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  const auto start = std::chrono::steady_clock::now();
  const double volume = run();
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto time = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  std::printf("  %s, %zu threads: %.3f s (processor %.3f), volume %.6f, peak %.0f MiB\n", name.c_str(), threads,
              seconds, time(usage.ru_utime) + time(usage.ru_stime), volume,
              static_cast<double>(usage.ru_maxrss) / 1024);
  std::fflush(stdout);
  _exit(0);
}

void measure(const char* name, const Triangles& triangles, double radius, int n) {
  const Mesh mesh = mesh_of(triangles, radius, n);
  std::printf("%s: %zu triangles + ball of radius %g, voxels of %.5f\n", name, mesh.faces.size(), radius, mesh.voxel);
  const auto all = static_cast<std::size_t>(std::max(1L, sysconf(_SC_NPROCESSORS_ONLN)));
  for (const std::size_t threads : {std::size_t{1}, all}) {
    in_process("level set, filter", threads, [&] { return by_filter(mesh, radius); });
    in_process("wide band", threads, [&] { return by_wide_band(mesh, radius); });
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "usage: ray_rival_openvdb SPOT.obj [N]\n");
    return 2;
  }
  const int n = argc > 2 ? std::atoi(argv[2]) : 512;
  measure("bumpy sphere", ray_bench::bumpy_sphere(1, 0.3, 4, 320, 158), 0.1, n);
  measure("spot", ray_bench::read_obj(argv[1]), 0.1, n);
  return 0;
}
