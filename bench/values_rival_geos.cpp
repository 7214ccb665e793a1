// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// GEOS: distance, and the discrete Hausdorff distance at the vertices.
#include <geos_c.h>

#include <memory>

#include "values_rivals.h"

namespace bench {
namespace {

struct Pair {
  GEOSContextHandle_t handle = GEOS_init_r();
  GEOSGeometry *a, *b;

  Pair(const Polygon& p, const Polygon& q) : a(polygon(p)), b(polygon(q)) {}
  Pair(const Pair&) = delete;
  Pair& operator=(const Pair&) = delete;
  ~Pair() {
    GEOSGeom_destroy_r(handle, a);
    GEOSGeom_destroy_r(handle, b);
    GEOS_finish_r(handle);
  }

  GEOSGeometry* polygon(const Polygon& p) const {
    auto* points = GEOSCoordSeq_create_r(handle, unsigned(p.size() + 1), 2);
    for (std::size_t i = 0; i <= p.size(); ++i)
      GEOSCoordSeq_setXY_r(handle, points, unsigned(i), double(p[i % p.size()].x), double(p[i % p.size()].y));
    return GEOSGeom_createPolygon_r(handle, GEOSGeom_createLinearRing_r(handle, points), nullptr, 0);
  }
};

}  // namespace

ValueRival geos_values(const Polygon& a, const Polygon& b) {
  auto pair = std::make_shared<Pair>(a, b);
  auto distance = [pair] {
    double d = 0;
    GEOSDistance_r(pair->handle, pair->a, pair->b, &d);
    return d;
  };
  auto hausdorff = [pair] {
    double d = 0;
    GEOSHausdorffDistance_r(pair->handle, pair->a, pair->b, &d);
    return d;
  };
  return {distance, hausdorff, {}};
}

}  // namespace bench
