// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "io/export/write_wkt.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "findspace/error.h"
#include "io/draw/face_rings.h"
#include "io/export/arc_places.h"
#include "plane/query/curve_net.h"
#include "plane/query/topology.h"

namespace findspace::io {
namespace {

using plane::CurveNet;
using plane::Index;
using plane::kNone;
using plane::Place;
using plane::Region;
using Curve = CurveNet::Curve;
using Ring = CurveNet::Ring;
using Side = CurveNet::Side;

std::string text(const Place& p) {
  auto number = [](double v) { return fmt::format("{}", v == 0 ? 0.0 : v); };
  return number(p[0]) + " " + number(p[1]);
}

class WktWriter {
 public:
  explicit WktWriter(const CurveNet& net) : net_(net), faces_(net), s_(net.complex()) {}

  std::vector<std::string> geometries() const {
    std::vector<std::string> out;
    for (const plane::Face& f : s_.faces) {
      if (f.mark != 0) out.push_back(polygon(f));
    }
    for (const Curve& k : net_.curves()) {
      if (faces_.is_free(k)) out.push_back(string(k, k.arc ? "CIRCULARSTRING" : "LINESTRING"));
    }
    for (Index v = 0; v < s_.vertices.size(); ++v) {
      if (s_.vertices[v].mark != 0 && s_.vertices[v].out == kNone) out.push_back("POINT (" + text(net_.at(v)) + ")");
    }
    return out;
  }

 private:
  std::vector<std::string> points(const Side& side) const {
    const Curve& k = net_.curves()[side.curve];
    std::vector<std::string> out;
    if (k.arc)
      for (const ArcPlace& p : three_point_arcs(net_, k)) out.push_back(text(p.at));
    else
      out = {text(net_.at(k.from)), text(net_.at(k.to))};
    if (!side.forward) std::reverse(out.begin(), out.end());
    return out;
  }

  /// The points of a side after its first.
  void add_points(const Side& side, std::vector<std::string>& out) const {
    const std::vector<std::string> all = points(side);
    out.insert(out.end(), all.begin() + 1, all.end());
  }

  std::string string(const Curve& k, const char* kind) const {
    return fmt::format("{} ({})", kind, fmt::join(points({Index(&k - net_.curves().data()), true}), ", "));
  }

  std::string ring(const Ring& sides) const {
    const bool curved =
        std::any_of(sides.begin(), sides.end(), [&](const Side& s) { return net_.curves()[s.curve].arc; });
    if (!curved) {
      std::vector<std::string> all = points(sides.front());
      for (std::size_t i = 1; i < sides.size(); ++i) add_points(sides[i], all);
      return fmt::format("({})", fmt::join(all, ", "));
    }
    std::vector<std::string> parts;
    for (const Side& s : sides) {
      parts.push_back(
          fmt::format("{}({})", net_.curves()[s.curve].arc ? "CIRCULARSTRING " : "", fmt::join(points(s), ", ")));
    }
    return parts.size() == 1 ? parts[0] : fmt::format("COMPOUNDCURVE ({})", fmt::join(parts, ", "));
  }

  std::string polygon(const plane::Face& f) const {
    std::vector<std::string> rings;
    for (const Ring& loop : faces_.of(f)) rings.push_back(ring(loop));
    const bool curved = std::any_of(rings.begin(), rings.end(), [](const std::string& r) { return r[0] == 'C'; });
    return fmt::format("{} ({})", curved ? "CURVEPOLYGON" : "POLYGON", fmt::join(rings, ", "));
  }

  const CurveNet& net_;
  FaceRings faces_;
  const Region& s_;
};

}  // namespace

WktText region_wkt(const Region& region, const exact::Real& step) {
  if (!plane::is_bounded(region)) throw Error(ErrorCode::kUnsupported, "WKT cannot hold an unbounded region");
  const Region closed = plane::closure(region);  // a curve that the region lacks parts no areas
  const CurveNet net(closed, step);
  const std::vector<std::string> all = WktWriter(net).geometries();
  WktText out;
  if (all.empty())
    out.text = "GEOMETRYCOLLECTION EMPTY\n";
  else if (all.size() == 1)
    out.text = all[0] + "\n";
  else
    out.text = fmt::format("GEOMETRYCOLLECTION ({})\n", fmt::join(all, ", "));
  if (!plane::is_closed(region)) out.lost = "WKT knows closed sets only: which edges and points do not belong is lost";
  return out;
}

}  // namespace findspace::io
