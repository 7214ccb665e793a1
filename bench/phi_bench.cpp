// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Phi-functions against their rivals, on the same input in the same run. One thread.
//   build    gamma12 with its facets, exactly, from two polytopes: against CGAL minkowski_sum_3 and against Qhull of
//   all
//            differences. Input: k random points on a sphere (k = 8 .. 2048), and the convex polytopes given as files.
//   depth    penetration depth at random overlapping positions: against FCL and libccd, with the share of answers that
//            are off by more than 1e-3 of the true depth.
// usage: phi_bench [--cgal-limit SECONDS] [--quick] [FILE.obj|.stl ...]
// Time of ours: the least of several runs. A rival that took longer than the limit at one size is left out at the next.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

#include "io/mesh/read_mesh.h"
#include "phi_rivals.h"
#include "space/phi/depth_grid.h"

namespace phi_bench {

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

namespace {

using findspace::space::ContactSurface;
using findspace::space::DepthGrid;
using findspace::space::PhiFunction;
using findspace::space::Point;
using findspace::space::Polytope;
using findspace::space::Vector;

constexpr double kRadius = 1e6;

Polytope random_polytope(int k, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  std::vector<Point> points;
  for (int i = 0; i < k; ++i) {
    const double x = normal(random), y = normal(random), z = normal(random),
                 r = kRadius / std::sqrt(x * x + y * y + z * z);
    points.push_back({std::llround(x * r), std::llround(y * r), std::llround(z * r)});
  }
  return Polytope::hull(points);
}

Body body(const Polytope& p, double unit = 1) {
  Body b;
  for (const Point& v : p.vertices())
    b.vertices.push_back({double(v.x) / unit, double(v.y) / unit, double(v.z) / unit});
  for (int f = 0; f < p.facet_count(); ++f) b.faces.push_back(p.circuit(f));
  return b;
}

Built ours(const Polytope& a, const Polytope& b) {
  Built best{1e9, 0};
  const double begin = now();
  for (int round = 0; round < 1000 && (round < 5 || now() - begin < 0.3); ++round) {
    const double start = now();
    const ContactSurface surface(a, b);
    best = {std::min(best.seconds, now() - start), surface.facet_count()};
  }
  return best;
}

/// Times of the rivals, 0 where left out.
struct Limits {
  double cgal = 20, qhull = 30;
  bool with_cgal = true, with_qhull = true;
};

void build_line(const std::string& name, const Polytope& a, const Polytope& b, Limits& limits) {
  const Built own = ours(a, b);
  const Body p = body(a), q = body(b);
  std::printf("%-24s %7d %12.2f", name.c_str(), own.facets, own.seconds * 1e6);
  if (limits.with_qhull) {
    Built qhull = build_with_qhull(p, q);
    if (qhull.seconds < 0.1) {
      for (int i = 0; i < 20; ++i) qhull.seconds = std::min(qhull.seconds, build_with_qhull(p, q).seconds);
    }
    limits.with_qhull = qhull.seconds < limits.qhull;
    std::printf(" %12.1f %9.0f", qhull.seconds * 1e6, qhull.seconds / own.seconds);
  } else {
    std::printf(" %12s %9s", "-", "-");
  }
  if (limits.with_cgal) {
    const Built cgal = build_with_cgal(p, q);
    limits.with_cgal = cgal.seconds < limits.cgal;
    std::printf(" %14.0f %9.0f  facets %s", cgal.seconds * 1e6, cgal.seconds / own.seconds,
                cgal.facets == own.facets ? "equal" : "DIFFER");
  } else {
    std::printf(" %14s %9s", "-", "-");
  }
  std::printf("\n");
  std::fflush(stdout);
}

struct Answers {
  double per_second = 0, off = 0;
};

/// `unit`: the rivals have absolute tolerances for bodies of about size 1, so they get the bodies in that unit.
Answers ask(const DepthQuery& query, const std::vector<Vector>& at, const std::vector<double>& depth, double unit,
            double seconds) {
  Answers answers;
  const double start = now();
  std::size_t done = 0, off = 0;
  while (done < at.size() && now() - start < seconds) {
    const double d = unit * query({at[done].x / unit, at[done].y / unit, at[done].z / unit});
    off += std::fabs(d - depth[done]) > 1e-3 * depth[done];
    ++done;
  }
  answers.per_second = static_cast<double>(done) / (now() - start);
  answers.off = static_cast<double>(off) / static_cast<double>(done);
  return answers;
}

void depth_line(const std::string& name, const Polytope& a, const Polytope& b, std::mt19937_64& random) {
  const PhiFunction phi(a, b);
  Vector low = phi.vertex(0), high = low;
  for (int v = 0; v < phi.surface().vertex_count(); ++v) {
    const Vector& p = phi.vertex(v);
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  std::uniform_real_distribution<double> x(low.x, high.x), y(low.y, high.y), z(low.z, high.z);
  std::vector<Vector> at;
  std::vector<double> depth;
  while (at.size() < 200000) {
    const Vector u{x(random), y(random), z(random)};
    const double value = phi.max_form(u);
    if (value >= 0) continue;
    at.push_back(u);
    depth.push_back(-value);
  }
  double start = now();
  const DepthGrid grid(phi);
  const double building = now() - start;
  std::vector<double> values(at.size());
  std::vector<int> facets(at.size());
  double scan = 1e9, fast = 1e9;
  for (int i = 0; i < 7; ++i) {
    start = now();
    grid.evaluate(at, values, facets);
    fast = std::min(fast, now() - start);
  }
  std::size_t off = 0;
  for (std::size_t i = 0; i < at.size(); ++i) off += -values[i] != depth[i];
  start = now();
  phi.evaluate(at, values, facets);
  scan = now() - start;
  const auto millions = [&](double seconds) { return static_cast<double>(at.size()) / seconds / 1e6; };
  const double unit = (high.x - low.x) / 4;
  const Body p = body(a, unit), q = body(b, unit);
  const Answers fcl = ask(depth_with_fcl(p, q), at, depth, unit, 2),
                ccd = ask(depth_with_ccd(p, q), at, depth, unit, 2);
  std::printf("%-24s %7d %9.2f %9.2f %9.1f %7.1f%% %10.4f %7.1f%% %10.4f %7.1f%%\n", name.c_str(),
              phi.surface().facet_count(), millions(fast), millions(scan), building * 1e3,
              100.0 * static_cast<double>(off) / static_cast<double>(at.size()), fcl.per_second / 1e6, 100 * fcl.off,
              ccd.per_second / 1e6, 100 * ccd.off);
  std::fflush(stdout);
}

std::vector<std::pair<std::string, Polytope>> read_polytopes(const std::vector<std::string>& files) {
  std::vector<std::pair<std::string, Polytope>> polytopes;
  for (const std::string& file : files) {
    findspace::io::ReadContext context;
    std::ifstream in(file, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    const auto mesh = findspace::io::parse_mesh(bytes, file.substr(file.find_last_of('.')), context,
                                                [](const auto&) { return findspace::exact::Real(1); });
    polytopes.emplace_back(file.substr(file.find_last_of('/') + 1), Polytope::hull(mesh.vertices));
  }
  return polytopes;
}

void run(const std::vector<std::string>& files, Limits limits, bool quick) {
  const std::vector<int> sizes = quick ? std::vector<int>{8, 32} : std::vector<int>{8, 32, 128, 512, 2048};
  std::printf("build gamma12, microseconds; ratio = rival / ours\n%-24s %7s %12s %12s %9s %14s %9s\n", "input",
              "facets", "ours", "qhull", "ratio", "cgal", "ratio");
  Limits random_limits = limits;
  for (const int k : sizes) {
    std::mt19937_64 random(static_cast<unsigned>(k));
    const Polytope a = random_polytope(k, random), b = random_polytope(k, random);
    build_line("sphere k=" + std::to_string(k), a, b, random_limits);
  }
  const auto real = read_polytopes(files);
  for (std::size_t i = 0; i < real.size(); ++i) {
    const auto& [name, b] = real[(i + 1) % real.size()];
    build_line(real[i].first + " - " + name, real[i].second, b, limits);
  }
  std::printf(
      "\npenetration depth, million queries a second; off = share of answers off by more than 1e-3 of the depth (ours: "
      "not the same bits)\n"
      "%-24s %7s %9s %9s %9s %8s %10s %8s %10s %8s\n",
      "input", "facets", "ours", "ours scan", "build ms", "off", "fcl", "off", "libccd", "off");
  for (const int k : sizes) {
    if (k > 512) continue;
    std::mt19937_64 random(static_cast<unsigned>(k));
    const Polytope a = random_polytope(k, random), b = random_polytope(k, random);
    depth_line("sphere k=" + std::to_string(k), a, b, random);
  }
  for (std::size_t i = 0; i < real.size(); ++i) {
    std::mt19937_64 random(7);
    const auto& [name, b] = real[(i + 1) % real.size()];
    depth_line(real[i].first + " - " + name, real[i].second, b, random);
  }
}

}  // namespace
}  // namespace phi_bench

int main(int argc, char** argv) {
  std::vector<std::string> files;
  phi_bench::Limits limits;
  bool quick = false;
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--quick") == 0)
      quick = true;
    else if (std::strcmp(argv[i], "--cgal-limit") == 0 && i + 1 < argc)
      limits.cgal = std::atof(argv[++i]);
    else
      files.emplace_back(argv[i]);
  }
  phi_bench::run(files, limits, quick);
  return 0;
}
