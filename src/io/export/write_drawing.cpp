// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/export/write_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

#include "findspace/error.h"
#include "io/export/face_rings.h"
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

/// Names of layers in R12 are short of blanks and signs.
std::string layer_name(std::string_view name) {
  std::string out;
  for (char c : name) out += std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_' || c == '$' ? c : '_';
  return out.empty() ? "0" : out;
}

int insunits(std::optional<formula::Unit> unit) {
  if (!unit) return 0;
  switch (*unit) {
    case formula::Unit::kMicrometre:
      return 13;
    case formula::Unit::kMillimetre:
      return 4;
    case formula::Unit::kCentimetre:
      return 5;
    case formula::Unit::kMetre:
      return 6;
    case formula::Unit::kInch:
      return 1;
    case formula::Unit::kMil:
      return 9;
  }
  return 0;
}

class DxfWriter {
 public:
  void group(int code, std::string_view value) { text_ += fmt::format("{:>3}\n{}\n", code, value); }
  void group(int code, int value) { group(code, std::to_string(value)); }
  void number(int code, double value) { group(code, number_text(value)); }

  void begin_section(std::string_view name) {
    group(0, "SECTION");
    group(2, name);
  }
  void end_section() { group(0, "ENDSEC"); }

  void header(std::optional<formula::Unit> unit) {
    begin_section("HEADER");
    group(9, "$ACADVER");
    group(1, "AC1009");
    group(9, "$INSUNITS");
    group(70, insunits(unit));
    end_section();
  }

  void layers(const std::set<std::string>& names) {
    begin_section("TABLES");
    group(0, "TABLE");
    group(2, "LAYER");
    group(70, static_cast<int>(names.size()));
    for (const std::string& name : names) {
      group(0, "LAYER");
      group(2, name);
      group(70, 0);
      group(62, 7);
      group(6, "CONTINUOUS");
    }
    group(0, "ENDTAB");
    end_section();
  }

  void region(const plane::Region& region, const exact::Real& step, const std::string& layer) {
    layer_ = layer;
    const CurveNet net(region, step);
    const FaceRings rings(net);
    for (const plane::Face& f : region.faces) {
      if (f.mark == 0) continue;
      for (const CurveNet::Ring& ring : rings.of(f)) sides(net, ring, true);
    }
    for (Index k = 0; k < net.curves().size(); ++k)
      if (rings.is_free(net.curves()[k])) sides(net, {{k, true}}, false);
    for (Index v = 0; v < region.vertices.size(); ++v)
      if (region.vertices[v].mark != 0 && region.vertices[v].out == plane::kNone) point(net.at(v));
  }

  std::string take() { return std::move(text_); }

 private:
  void entity(std::string_view type) {
    group(0, type);
    group(8, layer_);
  }

  void place(const Place& p) {
    number(10, p[0]);
    number(20, p[1]);
  }

  void point(const Place& p) {
    entity("POINT");
    place(p);
  }

  void vertex(const Place& p, double bulge) {
    entity("VERTEX");
    place(p);
    if (bulge != 0) number(42, bulge);
  }

  void sides(const CurveNet& net, const CurveNet::Ring& ring, bool closed) {
    const CurveNet::Curve& first = net.curves()[ring.front().curve];
    if (ring.size() == 1 && first.from == first.to) {
      entity("CIRCLE");
      place(first.center);
      return number(40, first.radius);
    }
    entity("POLYLINE");
    group(66, 1);
    group(70, closed ? 1 : 0);
    for (const CurveNet::Side& side : ring) {
      const CurveNet::Curve& k = net.curves()[side.curve];
      const double bulge = k.arc ? std::tan(k.angle / 4) : 0;
      vertex(net.at(side.forward ? k.from : k.to), side.forward ? bulge : -bulge);
    }
    if (!closed) vertex(net.at(ring.back().forward ? first.to : first.from), 0);
    entity("SEQEND");
  }

  std::string text_, layer_;
};

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
std::vector<std::string> geometries_json(const plane::Region& region, const exact::Real& step) {
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

DrawingText shapes_dxf(std::span<const NamedRegion> regions, const exact::Real& step,
                       std::optional<formula::Unit> unit) {
  std::set<std::string> layers;
  for (const NamedRegion& r : regions) {
    require_bounded(*r.region);
    layers.insert(layer_name(r.name));
  }
  DxfWriter writer;
  writer.header(unit);
  writer.layers(layers);
  writer.begin_section("ENTITIES");
  for (const NamedRegion& r : regions) writer.region(*r.region, step, layer_name(r.name));
  writer.end_section();
  writer.group(0, "EOF");
  return {writer.take(), lost_of(regions)};
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
