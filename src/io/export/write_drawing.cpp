// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/export/write_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "findspace/error.h"
#include "io/draw/face_rings.h"
#include "io/export/arc_places.h"
#include "io/write/write_json.h"
#include "plane/query/topology.h"

namespace findspace::io {
namespace {

using plane::CurveNet;
using plane::Index;
using plane::Place;

std::string number_text(double v) { return fmt::format("{}", v == 0 ? 0.0 : v); }

void require_bounded(const plane::Region& region) {
  if (!plane::is_bounded(region)) throw Error(ErrorCode::kUnsupported, "a drawing cannot hold an unbounded region");
}

std::string lost_of(std::span<const NamedRegion> regions) {
  const bool closed =
      std::all_of(regions.begin(), regions.end(), [](const NamedRegion& r) { return plane::is_closed(*r.region); });
  return closed ? "" : "a drawing knows closed sets only: which edges and points do not belong is lost";
}

/// All corners of a side but its last.
void add_corners(const CurveNet& net, const CurveNet::Side& side, std::vector<DrawnCorner>& corners) {
  const CurveNet::Curve& k = net.curves()[side.curve];
  if (!k.arc) {
    const Place at = net.at(side.forward ? k.from : k.to);
    return corners.push_back({at[0], at[1], 0});
  }
  std::vector<ArcPlace> places = divided_arc(net, k);
  if (!side.forward) std::reverse(places.begin(), places.end());
  for (std::size_t i = 0; i + 1 < places.size(); ++i)
    corners.push_back({places[i].at[0], places[i].at[1], std::tan((places[i + 1].angle - places[i].angle) / 4)});
}

void draw_sides(DxfWriter& writer, const std::string& layer, const CurveNet& net, const CurveNet::Ring& ring,
                bool closed) {
  const CurveNet::Curve& first = net.curves()[ring.front().curve];
  if (ring.size() == 1 && first.from == first.to)
    return writer.circle(layer, first.center[0], first.center[1], first.radius);
  std::vector<DrawnCorner> corners;
  for (const CurveNet::Side& side : ring) add_corners(net, side, corners);
  if (!closed) {
    const Place last = net.at(ring.back().forward ? first.to : first.from);
    corners.push_back({last[0], last[1], 0});
  }
  writer.polyline(layer, corners, closed);
}

/// Whether curves that bound no face of the set go round something.
bool free_curves_close(const CurveNet& net, const FaceRings& rings) {
  std::map<Index, Index> joined;  // of a vertex: one that it hangs together with, or itself
  const auto first = [&](Index v) {
    while (joined.try_emplace(v, v).first->second != v) v = joined[v] = joined[joined[v]];  // and the way gets shorter
    return v;
  };
  for (const CurveNet::Curve& k : net.curves()) {
    if (!rings.is_free(k)) continue;
    const Index a = first(k.from), b = first(k.to);
    if (a == b) return true;
    joined[a] = b;
  }
  return false;
}

/// Whether what is drawn has the inside of the region, and no more.
bool draw_region(DxfWriter& writer, const std::string& layer, const plane::Region& set, const exact::Real& step) {
  const plane::Region region = plane::closure(set);  // a curve that the set lacks parts no areas
  const CurveNet net(region, step);
  const FaceRings rings(net);
  for (const plane::Face& f : region.faces) {
    if (f.mark == 0) continue;
    for (const CurveNet::Ring& ring : rings.of(f)) draw_sides(writer, layer, net, ring, true);
  }
  for (Index k = 0; k < net.curves().size(); ++k)
    if (rings.is_free(net.curves()[k])) draw_sides(writer, layer, net, {{k, true}}, false);
  for (Index v = 0; v < region.vertices.size(); ++v) {
    if (region.vertices[v].mark == 0 || region.vertices[v].out != plane::kNone) continue;
    writer.point(layer, net.at(v)[0], net.at(v)[1]);
  }
  return !free_curves_close(net, rings);
}

std::string ring_json(const CurveNet& net, const CurveNet::Ring& ring) {
  std::string out;
  auto add = [&](const Place& p) {
    out += fmt::format("{}[{}, {}]", out.empty() ? "" : ", ", number_text(p[0]), number_text(p[1]));
  };
  auto start = [&](const CurveNet::Side& side) {
    const CurveNet::Curve& k = net.curves()[side.curve];
    if (k.arc) throw Error(ErrorCode::kUnsupported, "GeoJSON knows no arcs; DXF, SVG and WKT do");
    return net.at(side.forward ? k.from : k.to);
  };
  for (const CurveNet::Side& side : ring) add(start(side));
  add(start(ring.front()));
  return fmt::format("[{}]", out);
}

/// The geometries of one region.
std::vector<std::string> geometries_json(const plane::Region& set, const exact::Real& step) {
  const plane::Region region = plane::closure(set);
  const CurveNet net(region, step);
  const FaceRings rings(net);
  std::vector<std::string> all;
  for (const plane::Face& f : region.faces) {
    if (f.mark == 0) continue;
    std::vector<std::string> polygon;
    for (const CurveNet::Ring& ring : rings.of(f)) polygon.push_back(ring_json(net, ring));
    all.push_back(fmt::format(R"({{"type": "Polygon", "coordinates": [{}]}})", fmt::join(polygon, ", ")));
  }
  for (const CurveNet::Curve& k : net.curves()) {
    if (!rings.is_free(k)) continue;
    if (k.arc) throw Error(ErrorCode::kUnsupported, "GeoJSON knows no arcs; DXF, SVG and WKT do");
    const Place a = net.at(k.from), b = net.at(k.to);
    all.push_back(fmt::format(R"({{"type": "LineString", "coordinates": [[{}, {}], [{}, {}]]}})", number_text(a[0]),
                              number_text(a[1]), number_text(b[0]), number_text(b[1])));
  }
  for (Index v = 0; v < region.vertices.size(); ++v) {
    if (region.vertices[v].mark == 0 || region.vertices[v].out != plane::kNone) continue;
    const Place p = net.at(v);
    all.push_back(fmt::format(R"({{"type": "Point", "coordinates": [{}, {}]}})", number_text(p[0]), number_text(p[1])));
  }
  return all;
}

}  // namespace

DrawingText shapes_dxf(std::span<const NamedRegion> regions, const exact::Real& step, std::optional<formula::Unit> unit,
                       DxfVersion version) {
  std::vector<std::string> layers;
  for (const NamedRegion& r : regions) {
    require_bounded(*r.region);
    if (std::find(layers.begin(), layers.end(), r.name) == layers.end()) layers.emplace_back(r.name);
  }
  DxfWriter writer(version, unit, layers);
  std::string lost = lost_of(regions);
  for (const NamedRegion& r : regions)
    if (!draw_region(writer, std::string(r.name), *r.region, step))
      lost += fmt::format("{}a drawing cannot say that lines which go round have no inside, as those of '{}': lost",
                          lost.empty() ? "" : "; ", r.name);
  return {writer.take(), lost};
}

DrawingText shapes_geojson(std::span<const NamedRegion> regions, const exact::Real& step) {
  std::vector<std::string> features;
  for (const NamedRegion& r : regions) {
    require_bounded(*r.region);
    const std::vector<std::string> all = geometries_json(*r.region, step);
    const std::string geometry =
        all.size() == 1 ? all[0]
                        : fmt::format(R"({{"type": "GeometryCollection", "geometries": [{}]}})", fmt::join(all, ", "));
    features.push_back(fmt::format(R"({{"type": "Feature", "properties": {{"name": {}}}, "geometry": {}}})",
                                   json_string(r.name), geometry));
  }
  return {fmt::format("{{\"type\": \"FeatureCollection\", \"features\": [{}]}}\n", fmt::join(features, ",\n")),
          lost_of(regions)};
}

}  // namespace findspace::io
