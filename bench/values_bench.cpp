// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// values_bench: every distance of two polygons of n vertices at one position, ours exact and continuous against the
// rivals' numbers; shapes that overlap, of growing size; 10,000 positions of one pair; and a formula of 30 atoms over
// 10 shapes of 100 vertices, with its curve of time over the crossings of all boundaries. Prints tables (markdown).
// usage: values_bench [n | depth | positions | atoms]
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <string_view>

#include "distance/planar/at_position.h"
#include "formula/language/evaluate.h"
#include "formula/language/parse.h"
#include "formula/planar/position_functions.h"
#include "formula/planar/solve.h"
#include "plane/complex/overlay.h"
#include "plane/complex/primitives.h"
#include "plane/contour/contour.h"
#include "plane/query/topology.h"
#include "plane/sum/minkowski.h"
#include "values_rivals.h"

namespace {

using namespace bench;
using findspace::distance::AtPosition;
using findspace::distance::ShapePair;
using findspace::distance::Which;
using findspace::exact::Real;
using findspace::exact::RealPoint;
using findspace::plane::Region;

/// The median of repeated runs, in milliseconds; about 0.3 s of them.
template <class Job>
double median_ms(Job&& job) {
  using Clock = std::chrono::steady_clock;
  std::vector<double> times;
  double total = 0;
  while (times.size() < 3 || (total < 300 && times.size() < 1001)) {
    auto begun = Clock::now();
    job();
    times.push_back(std::chrono::duration<double, std::milli>(Clock::now() - begun).count());
    total += times.back();
  }
  std::nth_element(times.begin(), times.begin() + std::ptrdiff_t(times.size() / 2), times.end());
  return times[times.size() / 2];
}

/// Processor time of this thread: short jobs next to long ones are not charged for what others do on the machine.
template <class Job>
double once_ms(Job&& job) {
  const auto now = [] {
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return double(t.tv_sec) * 1e3 + double(t.tv_nsec) * 1e-6;
  };
  const double begun = now();
  job();
  return now() - begun;
}

Region region(const Polygon& polygon) {
  findspace::plane::Contour ring;
  for (const Point& p : polygon) ring.push_back({.start = {p.x, p.y}});
  return findspace::plane::region_of_rings(findspace::plane::make_rings({std::move(ring)}, 1).contours);
}

Polygon moved(Polygon polygon, std::int64_t dx, std::int64_t dy) {
  for (Point& p : polygon) {
    p.x += dx;
    p.y += dy;
  }
  return polygon;
}

struct Row {
  const char* name;
  Which which;
};
constexpr Row kRows[] = {{"gamma1", Which::kGamma1},      {"d1", Which::kD1},           {"gamma2", Which::kGamma2},
                         {"mu(B, A)", Which::kMu},        {"mu(A, B)", Which::kMuBack}, {"h(B, A)", Which::kH},
                         {"hausdorff", Which::kHausdorff}};

std::string cell(double ms) { return ms > 0 ? fmt::format("{:.4f}", ms) : "–"; }

void compare(const char* name, const Polygon& a, const Polygon& b, std::int64_t dx, std::int64_t dy) {
  Region ra = region(a), rb = region(b);
  Polygon placed = moved(b, dx, dy);
  ValueRival geos = geos_values(a, placed), boost = boost_values(placed, a);
  RealPoint p{dx, dy};
  auto pair = std::make_shared<ShapePair>(rb, ra);
  AtPosition prepared(pair);
  for (const Row& r : kRows) {
    // The shapes themselves are there, as the rivals' are; copying them is not counted.
    std::vector<double> times;
    for (int k = 0; k < 101 && (k < 3 || times.back() < 10); ++k) {
      Region b_copy = rb, a_copy = ra;
      times.push_back(once_ms(
          [&] { AtPosition(std::make_shared<ShapePair>(std::move(b_copy), std::move(a_copy))).measure(r.which, p); }));
    }
    std::sort(times.begin(), times.end());
    double fresh = times[times.size() / 2];
    double again = median_ms([&] { prepared.measure(r.which, p); });
    bool plain = r.which == Which::kGamma1 || r.which == Which::kD1, both = r.which == Which::kHausdorff;
    bool one = r.which == Which::kMu || r.which == Which::kH;
    double g = plain ? median_ms(geos.distance) : both ? median_ms(geos.hausdorff) : 0;
    double s = plain ? median_ms(boost.distance) : one ? median_ms(boost.directed_hausdorff) : 0;
    fmt::print("| {} | {} | {:.6g} | {} | {} | {} | {} |\n", name, r.name,
               prepared.measure(r.which, p)->value.to_double(), cell(fresh), cell(again), cell(g), cell(s));
  }
}

void many_positions(const Polygon& a, const Polygon& b) {
  Region ra = region(a), rb = region(b);
  constexpr int kPositions = 10000;
  const std::int64_t size = std::int64_t(1) << 20;
  auto at = [&](int k) {
    double t = 2.399963 * k, r = double(size) * 2.5 * std::sqrt(double(k) / kPositions);  // a sunflower
    return RealPoint{std::int64_t(r * std::cos(t)), std::int64_t(r * std::sin(t))};
  };
  for (const Row& r : kRows) {
    constexpr int kFresh = 12;  // spread over all positions, in and out
    double fresh = once_ms([&] {
                     for (int k = 0; k < kFresh; ++k)
                       AtPosition(std::make_shared<ShapePair>(region(b), region(a)))
                           .measure(r.which, at((2 * k + 1) * kPositions / (2 * kFresh)));
                   }) /
                   kFresh;
    double all = once_ms([&] {
      AtPosition prepared(std::make_shared<ShapePair>(rb, ra));
      for (int k = 0; k < kPositions; ++k) prepared.measure(r.which, at(k));
    });
    fmt::print("| {} | {:.4f} | {:.4f} | {:.1f} |\n", r.name, fresh, all / kPositions, fresh / (all / kPositions));
  }
}

/// Ten shapes of m vertices on a ring of radius `spread` (in 16ths of their size) around the origin and a moving one of
/// m vertices; for each a clearance, a nearness and a reach. Stars far apart cross little, wavy shapes on top of each
/// other everywhere.
void many_atoms(int m, int spread) {
  namespace formula = findspace::formula;
  const std::int64_t size = std::int64_t(1) << 20;
  formula::World world;
  formula::Context context;
  std::string text;
  const auto shape = [&](unsigned seed) { return spread < 16 ? smooth(m, seed) : star(m, seed); };
  const double ring = double(spread) / 16 * double(size);
  for (int k = 0; k < 10; ++k) {
    std::string name = fmt::format("A{}", k);
    double t = 0.6283185 * k;
    world.shapes.emplace(name, region(moved(shape(unsigned(k + 1)), std::int64_t(ring * std::cos(t)),
                                            std::int64_t(ring * std::sin(t)))));
    context.shapes.push_back(name);
    text += fmt::format("{}(gamma1(B, {}) >= {} and gamma1(B, {}) <= {} or gamma2(B, {}) <= {})", k > 0 ? " or " : "",
                        name, size / 8, name, size / 2, name, 4 * size);
  }
  world.shapes.emplace("B", region(shape(11)));
  context.shapes.push_back("B");
  world.moving = context.moving = {"B"};
  world.step = 1;
  const formula::Formula parsed = formula::parse_formula(text, context);
  formula::Solver solver(world);
  std::vector<findspace::plane::SignMap> maps;
  auto made = [&] {
    maps.clear();
    for (const auto& wanted : parsed.sign_maps())
      maps.push_back(objective_distance(solver.prepared(), wanted.distance)->sign_map(wanted.level));
  };
  double maps_ms = median_ms(made);
  std::vector<const findspace::plane::CellComplex*> operands;
  for (const auto& map : maps) operands.push_back(&map);
  // A mark for every combination of signs, so that hardly anything merges: the vertices are the ends and crossings of
  // all curves.
  std::size_t crossings = 0;
  auto rule = [](std::span<const findspace::plane::Mark> marks) {
    unsigned hash = 0;
    for (auto k : marks) hash = hash * 31 + unsigned(k + 1);
    return findspace::plane::Mark(hash % 127);
  };
  crossings = findspace::plane::overlay(operands, rule).vertices.size();
  double overlay_ms = median_ms([&] {
    findspace::plane::overlay(operands, [&](std::span<const findspace::plane::Mark> marks) {
      return findspace::plane::Mark(formula::evaluate(parsed, marks));
    });
  });
  double n = double(crossings);
  fmt::print("| {} | {} | {} | {} | {:.1f} | {:.1f} | {:.1f} |\n", m, spread, parsed.atoms().size(), crossings, maps_ms,
             overlay_ms, overlay_ms * 1e6 / (n * std::log2(n)));
}

void positions_table(int n) {
  fmt::print("\n10,000 positions of two wavy shapes (n = {}): fresh from the vertices, and prepared once\n\n", n);
  fmt::print("| distance | fresh, ms | prepared, ms a position | ratio |\n|---|---|---|---|\n");
  many_positions(smooth(n, 3), smooth(n, 4));
}

/// The depth of shapes that overlap, and eta1 of a shape a quarter as large inside the other; at one position, and at
/// twenty others.
void depth_table() {
  fmt::print(
      "\n| shapes | n | distance | from the shapes, ms | again at 20 other positions, ms each |\n"
      "|---|---|---|---|---|\n");
  const std::int64_t size = std::int64_t(1) << 20;
  auto row = [&](const char* name, int n, const char* distance, Which which, const Region& a, const Region& b) {
    auto prepared = std::make_unique<AtPosition>(std::make_shared<ShapePair>(b, a));
    double first = once_ms([&] { prepared->measure(which, {size / 2, size / 3}); });
    double others = once_ms([&] {
      for (int k = 0; k < 20; ++k) prepared->measure(which, {size / 2 - k * size / 40, size / 3 - k * size / 90});
    });
    fmt::print("| {} | {} | {} | {:.1f} | {:.2f} |\n", name, n, distance, first, others / 20);
  };
  auto quarter = [](Polygon polygon) {
    for (Point& p : polygon) {
      p.x /= 4;
      p.y /= 4;
    }
    return polygon;
  };
  // Corners rounded by discs a fiftieth as large; a hole in which the other shape could stand.
  auto rounded = [&](const Polygon& polygon) {
    return findspace::plane::minkowski_sum(region(polygon), findspace::plane::region_of_disc(0, 0, Real(size / 50)));
  };
  auto ring = [&](const Polygon& polygon) {
    const Region whole = region(polygon), hole = findspace::plane::interior(region(quarter(polygon)));
    const Region* both[] = {&whole, &hole};
    return findspace::plane::subtract(both);
  };
  for (int n : {50, 100, 200, 400}) {
    row("rounded stars", n, "gamma1", Which::kGamma1, rounded(star(n, 1)), rounded(star(n, 2)));
    row("rounded wavy", n, "gamma1", Which::kGamma1, rounded(smooth(n, 3)), rounded(smooth(n, 4)));
    row("rounded star in a star", n, "eta1", Which::kEta1, rounded(star(n, 1)), rounded(quarter(star(n, 2))));
    row("ring, quarter star", n, "gamma1", Which::kGamma1, ring(star(n, 1)), region(quarter(star(n, 2))));
  }
  for (int n : {125, 250, 500, 1000}) {
    row("stars", n, "gamma1", Which::kGamma1, region(star(n, 1)), region(star(n, 2)));
    row("wavy", n, "gamma1", Which::kGamma1, region(smooth(n, 3)), region(smooth(n, 4)));
    row("star in a star", n, "eta1", Which::kEta1, region(star(n, 1)), region(quarter(star(n, 2))));
  }
}

void atoms_table() {
  fmt::print("\nA formula of 30 atoms over 10 shapes of m vertices on a ring (radius in 16ths), one overlay\n\n");
  fmt::print(
      "| m | ring | atoms | vertices of the overlay, n | sign maps, ms | overlay, ms | overlay, ns / (n log2 n) "
      "|\n|---|---|---|---|---|---|---|\n");
  for (int m : {12, 25, 50, 100, 200}) many_atoms(m, 32);
  for (int m : {100, 200, 400, 800, 1600, 3200}) many_atoms(m, 1);
}

}  // namespace

int main(int argc, char** argv) {
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  if (argc > 1 && std::string_view(argv[1]) == "atoms") {
    atoms_table();
    return 0;
  }
  if (argc > 1 && std::string_view(argv[1]) == "depth") {
    depth_table();
    return 0;
  }
  if (argc > 1 && std::string_view(argv[1]) == "positions") {
    positions_table(1000);
    return 0;
  }
  int n = argc > 1 ? std::atoi(argv[1]) : 1000;
  const std::int64_t size = std::int64_t(1) << 20;
  fmt::print(
      "| {} vertices each | distance | value | ours, from the shapes, ms | ours, prepared, ms | GEOS, ms | Boost, ms "
      "|\n",
      n);
  fmt::print("|---|---|---|---|---|---|---|\n");
  struct Input {
    const char* name;
    Polygon a, b;
  };
  for (const Input& i : {Input{"stars", star(n, 1), star(n, 2)}, Input{"wavy", smooth(n, 3), smooth(n, 4)}}) {
    compare(fmt::format("{}, apart", i.name).c_str(), i.a, i.b, 3 * size, size / 3);
    compare(fmt::format("{}, overlapping", i.name).c_str(), i.a, i.b, size / 2, size / 3);
  }
  depth_table();
  positions_table(n);
  atoms_table();
  return 0;
}
