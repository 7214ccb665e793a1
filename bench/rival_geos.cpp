// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// GEOS: buffers with 64 segments a quadrant, and the unary union, both in doubles.
#include <geos_c.h>

#include <memory>
#include <stdexcept>

#include "contenders.h"

namespace bench {
namespace {

struct Session {
  GEOSContextHandle_t handle = GEOS_init_r();
  ~Session() { GEOS_finish_r(handle); }
  Session() = default;
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  GEOSGeometry* polygon(const Polygon& p) const {
    auto* points = GEOSCoordSeq_create_r(handle, unsigned(p.size() + 1), 2);
    for (std::size_t i = 0; i <= p.size(); ++i) {
      const Point& q = p[i % p.size()];
      GEOSCoordSeq_setXY_r(handle, points, unsigned(i), double(q.x), double(q.y));
    }
    return GEOSGeom_createPolygon_r(handle, GEOSGeom_createLinearRing_r(handle, points), nullptr, 0);
  }

  std::size_t count_and_free(GEOSGeometry* g) const {
    if (!g) throw std::runtime_error("GEOS has no result");
    int n = GEOSGetNumCoordinates_r(handle, g);
    GEOSGeom_destroy_r(handle, g);
    return std::size_t(n);
  }
};

std::size_t buffer(const Polygon& a, double r) {
  Session geos;
  GEOSGeometry* p = geos.polygon(a);
  GEOSGeometry* result = GEOSBuffer_r(geos.handle, p, r, 64);
  GEOSGeom_destroy_r(geos.handle, p);
  return geos.count_and_free(result);
}

std::size_t unite(const std::vector<Polygon>& all) {
  Session geos;
  std::vector<GEOSGeometry*> polygons;
  for (const Polygon& p : all) polygons.push_back(geos.polygon(p));
  auto* collection =
      GEOSGeom_createCollection_r(geos.handle, GEOS_MULTIPOLYGON, polygons.data(), unsigned(polygons.size()));
  GEOSGeometry* result = GEOSUnaryUnion_r(geos.handle, collection);
  GEOSGeom_destroy_r(geos.handle, collection);
  return geos.count_and_free(result);
}

}  // namespace

std::vector<Contender> geos_rivals() { return {{.name = "GEOS", .sum = {}, .offset = buffer, .unite = unite}}; }

}  // namespace bench
