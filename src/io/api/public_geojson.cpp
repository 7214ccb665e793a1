// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The closure of a public region as GeoJSON (RFC 7946): polygons, lines and points, arcs as chords. GeoJSON has no
// unit and no open ends.

#include <fmt/format.h>

#include "api/values/region_data.h"
#include "findspace/error.h"

namespace findspace {
namespace {

using Points = std::vector<Position>;

std::string point_text(const Position& p) { return fmt::format("[{}, {}]", p[0] + 0.0, p[1] + 0.0); }

std::string list_text(const Points& points) {
  std::string out;
  for (const Position& p : points) out += (out.empty() ? "" : ", ") + point_text(p);
  return "[" + out + "]";
}

std::string geometry(const char* type, const std::string& coordinates) {
  return fmt::format("{{\"type\": \"{}\", \"coordinates\": {}}}", type, coordinates);
}

/// Twice the area within a ring, negative where it runs clockwise.
double signed_area(const Points& ring) {
  double sum = 0;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Position &a = ring[k], &b = ring[(k + 1) % ring.size()];
    sum += (a[0] - ring[0][0]) * (b[1] - ring[0][1]) - (a[1] - ring[0][1]) * (b[0] - ring[0][0]);
  }
  return sum;
}

/// The geometries of the components, one after another.
class GeoJsonWriter {
 public:
  GeoJsonWriter(const Region& region, double bound, Region::Towards side)
      : region_(region), bound_(bound), rings_(region.flattened(bound, side)) {}

  std::string run() {
    for (const Region::Component& part : region_.components()) add(part);
    if (polygons_.empty() && others_.size() == 1) return others_[0];
    if (others_.empty() && polygons_.size() == 1) return geometry("Polygon", polygons_[0]);
    if (others_.empty() && !polygons_.empty())
      return geometry("MultiPolygon", fmt::format("[{}]", fmt::join(polygons_, ", ")));
    for (const std::string& p : polygons_) others_.push_back(geometry("Polygon", p));
    return fmt::format("{{\"type\": \"GeometryCollection\", \"geometries\": [{}]}}", fmt::join(others_, ", "));
  }

 private:
  void add(const Region::Component& part) {
    for (std::size_t k = 0; k < part.rings.size(); ++k) {
      Points ring = rings_[next_++];
      const bool outer = signed_area(ring) > 0;
      ring.push_back(ring.front());
      if (outer)
        polygons_.push_back("[" + list_text(ring) + "]");
      else
        polygons_.back().insert(polygons_.back().size() - 1, ", " + list_text(ring));
    }
    for (const std::size_t e : part.curves)
      others_.push_back(geometry("LineString", list_text(curve(region_.edges()[e]))));
    for (const std::size_t v : part.isolated)
      others_.push_back(geometry("Point", point_text(region_.vertices()[v].at)));
  }
  Points curve(const Region::Edge& e) const {
    const Position from = region_.vertices()[e.start].at;
    Points out{from};
    if (e.arc) api::add_arc(e, from, true, bound_, false, out);
    out.push_back(region_.vertices()[e.end].at);
    return out;
  }

  const Region& region_;
  double bound_;
  std::vector<Points> rings_;
  std::size_t next_ = 0;
  std::vector<std::string> polygons_, others_;  // coordinates; whole geometries
};

}  // namespace

std::string Region::geojson(double bound, Towards side) const {
  if (!bounded()) throw Error(ErrorCode::kUnsupported, "an unbounded region has no GeoJSON");
  return GeoJsonWriter(*this, bound, side).run();
}

}  // namespace findspace
