// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/nfp/no_fit_polygon.h"

#include <findspace/error.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "packing/problem/arc_corners.h"
#include "packing/problem/round_part.h"
#include "plane/base/result_store.h"
#include "plane/complex/cell_bytes.h"
#include "plane/complex/overlay.h"
#include "plane/complex/primitives.h"
#include "plane/contour/decimal_grid.h"
#include "plane/sum/minkowski.h"

namespace findspace::packing {
namespace {

constexpr std::size_t kMostEdges = 65535;  // that a depth field numbers
constexpr int kSides = 32;                 // of the polygon about the disc of a gap
constexpr int kSearchDigits = 7;           // of the search's grid, at most

/// A polygon of the grid that holds the disc; its corners are rounded away from the centre.
SearchShape about_disc(double radius, double step) {
  SearchShape result;
  result.step = step;
  auto& ring = result.rings.emplace_back();
  const double out = radius / step / std::cos(std::numbers::pi / kSides);
  const auto away = [](double c) { return std::int64_t(c < 0 ? std::floor(c) : std::ceil(c)); };
  for (int k = 0; k < kSides; ++k) {
    const double angle = (2 * k + 1) * std::numbers::pi / kSides;
    ring.emplace_back(away(out * std::cos(angle)), away(out * std::sin(angle)));
  }
  return result;
}

/// Of the faces with a negative mark. What bounds them counts as free; what has them on both sides only where its own
/// mark is not negative.
class Boundary {
 public:
  Boundary(const plane::SignMap& map, double step) : map_(map), step_(step) {
    for (plane::Index e = 0; e < map.edges.size(); ++e) add_edge(e);
    for (const plane::Vertex& v : map.vertices)
      if (v.out == plane::kNone && v.mark >= 0 && map.faces[v.face].mark < 0) add({at(v.point), at(v.point), true});
  }
  NoFitPolygon take() { return std::move(result_); }

 private:
  Vec at(plane::Index point) const {
    const exact::Point& p = map_.geometry.points[point];
    if (p.kind == exact::Point::Kind::kGrid) return {double(p.gx) * step_, double(p.gy) * step_};
    return {p.x * step_, p.y * step_};
  }
  void add_edge(plane::Index e) {
    const bool left = map_.faces[map_.face(2 * e)].mark < 0, right = map_.faces[map_.face(2 * e + 1)].mark < 0;
    if ((!left && !right) || (left && right && map_.edges[e].mark < 0)) return;
    Vec from = at(map_.vertices[map_.edges[e].v0].point), to = at(map_.vertices[map_.edges[e].v1].point);
    if (!left) std::swap(from, to);
    if (!map_.is_arc(e)) return add({from, to, left && right});
    add_arc(map_.supporting_curve(e), from, to, (map_.edges[e].half < 0) == left, left && right);
  }
  /// Chords where the overlap is outside the circle, tangents where it is inside: they lie on the free side.
  void add_arc(const exact::SupportingCurve& circle, Vec from, Vec to, bool ccw, bool slit) {
    const Arc arc{{circle.x().value * step_, circle.y().value * step_}, circle.z().value * step_, from, to, ccw};
    for (const Vec next : corners_of(arc, ccw && !slit)) {
      add({from, next, slit});
      from = next;
    }
    add({from, to, slit});
  }
  void add(const NoFitEdge& edge) {
    result_.edges.push_back(edge);
    for (const Vec p : {edge.from, edge.to}) {
      result_.low = {std::min(result_.low.x, p.x), std::min(result_.low.y, p.y)};
      result_.high = {std::max(result_.high.x, p.x), std::max(result_.high.y, p.y)};
    }
  }

  static constexpr double kFar = std::numeric_limits<double>::infinity();
  const plane::SignMap& map_;
  double step_;
  NoFitPolygon result_{{}, {kFar, kFar}, {-kFar, -kFar}};
};

/// Free is what is free in the map and in every region.
plane::SignMap tied(const plane::SignMap& map, const std::vector<plane::Region>& regions) {
  std::vector<const plane::CellComplex*> operands{&map};
  for (const plane::Region& region : regions) operands.push_back(&region);
  return plane::overlay(operands, [](std::span<const plane::Mark> marks) {
    return std::all_of(marks.begin() + 1, marks.end(), plane::is_in) ? marks[0] : plane::Mark(-1);
  });
}

/// Where all that is far away is not a place, the polygon reaches that far; where no place is free, one that is too
/// far.
void reach_out(NoFitPolygon& polygon, double reach) {
  if (polygon.edges.empty()) polygon.edges.push_back({{reach, reach}, {reach, reach}, true});
  polygon.low = {-reach, -reach};
  polygon.high = {reach, reach};
}

}  // namespace

plane::SharedRegion region_of(const SearchShape& shape) {
  if (shape.round) return *shape.round;
  std::vector<plane::Contour> contours;
  for (const auto& ring : shape.rings) {
    plane::Contour& contour = contours.emplace_back();
    for (const auto& [x, y] : ring) contour.push_back({.start = {x, y}});
  }
  return plane::region_of_rings(contours);
}

SearchShape search_shape(const Problem& problem, const Polygon& shape) {
  SearchShape result;
  const int digits = problem.digits, most = problem.has_round_parts() ? digits : kSearchDigits;
  const int128 drop = power_of_ten(std::max(0, digits - most));
  result.step = 1 / double(power_of_ten(std::min(digits, most)));
  const auto rounded = [&](int128 c) { return std::int64_t((c + (c < 0 ? -drop : drop) / 2) / drop); };
  for (const Ring& ring : shape.rings) {
    auto& out = result.rings.emplace_back();
    for (const LatticePoint& p : ring) {
      const std::pair<std::int64_t, std::int64_t> q{rounded(p.x), rounded(p.y)};
      if (out.empty() || out.back() != q) out.push_back(q);
    }
    while (out.size() > 1 && out.back() == out.front()) out.pop_back();
  }
  return result;
}

SearchShape search_shape(const Problem& problem, const Part& part, const Fraction& angle, bool mirrored) {
  SearchShape result = search_shape(problem, rotated(part, angle, mirrored));
  if (part.round) result.round = part.round->at(angle, mirrored).region;
  return result;
}

namespace {

NoFitPolygon made_polygon(const SearchShape& a, const SearchShape& b, double gap, const Tie* tie) {
  const bool round = a.round || b.round;
  const auto disc = [&] {
    if (!round) return region_of(about_disc(gap, a.step));
    return plane::SharedRegion(plane::region_of_disc(0, 0, plane::decimal_of(gap) / plane::decimal_of(a.step)));
  };
  const plane::SharedRegion grown =
      gap > 0 ? plane::SharedRegion(plane::minkowski_sum(region_of(a), disc())) : region_of(a);
  plane::SignMap map = plane::contact_map(grown, region_of(b));
  if (tie != nullptr) map = tied(map, tie->regions);
  NoFitPolygon result = Boundary(map, a.step).take();
  if (tie != nullptr && map.faces[0].mark < 0) reach_out(result, tie->reach);
  if (result.edges.size() > kMostEdges)
    throw Error(ErrorCode::kUnsupported, "two parts have too many corners to be packed together");
  return result;
}

/// False where it has no bytes.
bool put_shape(const SearchShape& shape, plane::ByteWriter& out) {
  out.put(shape.step);
  out.put(std::uint64_t(shape.rings.size()));
  for (const auto& ring : shape.rings) {
    out.put(std::uint64_t(ring.size()));
    for (const auto& [x, y] : ring) {
      out.put(x);
      out.put(y);
    }
  }
  return !shape.round || plane::put_cells(*shape.round, out);
}

void put_vec(Vec v, plane::ByteWriter& out) {
  out.put(v.x);
  out.put(v.y);
}

Vec take_vec(plane::ByteReader& in) {
  const auto x = in.take<double>(), y = in.take<double>();
  return {x, y};
}

bool put_polygon(const NoFitPolygon& polygon, plane::ByteWriter& out) {
  put_vec(polygon.low, out);
  put_vec(polygon.high, out);
  out.put(std::uint64_t(polygon.edges.size()));
  for (const NoFitEdge& e : polygon.edges) {
    put_vec(e.from, out);
    put_vec(e.to, out);
    out.put(std::int8_t(e.slit));
  }
  return true;
}

std::optional<NoFitPolygon> take_polygon(plane::ByteReader& in) {
  NoFitPolygon polygon;
  polygon.low = take_vec(in);
  polygon.high = take_vec(in);
  constexpr std::uint64_t kEdgeBytes = 4 * sizeof(double) + 1;
  for (std::uint64_t n = in.take_count(kEdgeBytes); n > 0; --n) {
    NoFitEdge e;
    e.from = take_vec(in);
    e.to = take_vec(in);
    e.slit = in.take<std::int8_t>() != 0;
    polygon.edges.push_back(e);
  }
  return polygon;
}

}  // namespace

NoFitPolygon no_fit_polygon(const SearchShape& a, const SearchShape& b, double gap, const Tie* tie) {
  const auto make = [&] { return made_polygon(a, b, gap, tie); };
  if (tie != nullptr) return make();
  const auto content = [&](plane::ByteWriter& out) {
    out.put(gap);
    return put_shape(a, out) && put_shape(b, out);
  };
  return plane::stored<NoFitPolygon>({"no-fit polygon", content, make, put_polygon, take_polygon});
}

}  // namespace findspace::packing
