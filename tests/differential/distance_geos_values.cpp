// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Values at a position against GEOS (distance of areas, Hausdorff distance of lines at densified vertices) and against
// dense samples of the definition, with the bounds that the spacing of the samples gives.

#include <geos_c.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "distance/planar/at_position.h"
#include "plane/complex/primitives.h"
#include "plane/contour/contour.h"
#include "plane/query/locate.h"

namespace findspace::distance {
namespace distance_geos_values {

using exact::Real;
using exact::RealPoint;
using plane::GridPoint;

constexpr double kTolerance = 1e-9;  // of coordinates around 1000

class Geos {
 public:
  ~Geos() { GEOS_finish_r(handle_); }
  GEOSGeometry* line(const std::vector<GridPoint>& points, GridPoint by, bool area) const {
    unsigned n = unsigned(points.size()) + (area ? 1 : 0);
    auto* s = GEOSCoordSeq_create_r(handle_, n, 2);
    for (unsigned k = 0; k < n; ++k) {
      const GridPoint& q = points[k % points.size()];
      GEOSCoordSeq_setXY_r(handle_, s, k, double(q.x + by.x), double(q.y + by.y));
    }
    if (!area) return GEOSGeom_createLineString_r(handle_, s);
    return GEOSGeom_createPolygon_r(handle_, GEOSGeom_createLinearRing_r(handle_, s), nullptr, 0);
  }
  template <class F>
  double value(GEOSGeometry* a, GEOSGeometry* b, F&& f) const {
    double d = 0;
    f(handle_, a, b, &d);
    GEOSGeom_destroy_r(handle_, a);
    GEOSGeom_destroy_r(handle_, b);
    return d;
  }

 private:
  GEOSContextHandle_t handle_ = GEOS_init_r();
};

class Jagged {
 public:
  explicit Jagged(unsigned seed) : random_(seed) {}
  std::int64_t pick(std::int64_t low, std::int64_t high) {
    return std::uniform_int_distribution<std::int64_t>(low, high)(random_);
  }
  std::vector<GridPoint> ring(int n) {
    std::vector<GridPoint> out;
    for (int k = 0; k < n; ++k) {
      double r = double(pick(300, 1000)), t = 2 * M_PI * k / n;
      out.push_back({std::llround(r * std::cos(t)), std::llround(r * std::sin(t))});
    }
    return out;
  }

 private:
  std::mt19937 random_;
};

plane::Contour contour(const std::vector<GridPoint>& points) {
  plane::Contour c;
  for (const GridPoint& p : points) c.push_back({.start = p});
  return c;
}

plane::Region area(const std::vector<GridPoint>& points) {
  return plane::region_of_rings(std::vector<plane::Contour>{contour(points)});
}

double number(const AtPosition& at, Which w, GridPoint p) { return at.measure(w, {p.x, p.y})->value.to_double(); }

TEST(Geos, DistanceOfAreas) {
  Geos geos;
  Jagged random(1);
  for (int k = 0; k < 30; ++k) {
    auto a = random.ring(30), b = random.ring(20);
    AtPosition at(std::make_shared<ShapePair>(area(b), area(a)));
    GridPoint p{random.pick(-2500, 2500), random.pick(-2500, 2500)};
    double theirs = geos.value(geos.line(a, {}, true), geos.line(b, p, true),
                               [](auto h, auto* x, auto* y, double* d) { GEOSDistance_r(h, x, y, d); });
    EXPECT_NEAR(number(at, Which::kD1, p), theirs, kTolerance);
  }
}

TEST(Geos, HausdorffDistanceOfChains) {
  Geos geos;
  Jagged random(2);
  for (int k = 0; k < 20; ++k) {
    auto a = random.ring(12), b = random.ring(9);
    AtPosition at(std::make_shared<ShapePair>(plane::region_of_chain(contour(b)), plane::region_of_chain(contour(a))));
    GridPoint p{random.pick(-900, 900), random.pick(-900, 900)};
    constexpr double kFraction = 1.0 / 256;
    double theirs =
        geos.value(geos.line(a, {}, false), geos.line(b, p, false),
                   [](auto h, auto* x, auto* y, double* d) { GEOSHausdorffDistanceDensify_r(h, x, y, kFraction, d); });
    double longest = 2000;  // of a segment; a sample is at most half its share away
    double ours = number(at, Which::kHausdorff, p);
    EXPECT_GE(ours, theirs - kTolerance);
    EXPECT_LE(ours, theirs + longest * kFraction / 2);
  }
}

/// Places of the polygon on a lattice of the given spacing, and on its boundary.
std::vector<std::pair<double, double>> samples(const std::vector<GridPoint>& ring, const plane::Region& r,
                                               int spacing) {
  std::vector<std::pair<double, double>> out;
  plane::Locator locator(r);
  for (int x = -1000; x <= 1000; x += spacing)
    for (int y = -1000; y <= 1000; y += spacing)
      if (locator.mark({x, y}) > 0) out.emplace_back(x, y);
  for (std::size_t k = 0; k < ring.size(); ++k) {
    GridPoint p = ring[k], q = ring[(k + 1) % ring.size()];
    int parts = int(std::hypot(double(q.x - p.x), double(q.y - p.y)) / spacing) + 1;
    for (int i = 0; i < parts; ++i)
      out.emplace_back(double(p.x) + double(q.x - p.x) * i / parts, double(p.y) + double(q.y - p.y) * i / parts);
  }
  return out;
}

TEST(Samples, DirectedHausdorffDistance) {
  Jagged random(3);
  constexpr int kSpacing = 50;
  for (int k = 0; k < 6; ++k) {
    auto a = random.ring(14), b = random.ring(10);
    plane::Region ra = area(a), rb = area(b);
    AtPosition at(std::make_shared<ShapePair>(rb, ra));
    GridPoint p{random.pick(-600, 600), random.pick(-600, 600)};
    auto in_a = samples(a, ra, kSpacing), in_b = samples(b, rb, kSpacing);
    double most = 0;
    for (auto [bx, by] : in_b) {
      double least = INFINITY;
      for (auto [ax, ay] : in_a) least = std::min(least, std::hypot(bx + double(p.x) - ax, by + double(p.y) - ay));
      most = std::max(most, least);
    }
    // Every point of a set is within this of a sample: half a diagonal of the lattice, or half a step along the
    // boundary more.
    double room = kSpacing * 1.5;
    double ours = number(at, Which::kH, p);
    EXPECT_LE(ours, most + room);
    EXPECT_GE(ours, most - room);
  }
}

}  // namespace distance_geos_values
}  // namespace findspace::distance
