// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "formula/planar/witness.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "plane/complex/extent.h"
#include "plane/query/nearest.h"

namespace findspace::formula {

using exact::RealPoint;
using plane::Index;
using plane::Region;

namespace {

/// How far the point is from the set's boundary, or from the set.
double away(const Region& r, const RealPoint& at, bool inside) {
  if (inside && mark_of(r, locate(r, at)) > 0) return 0;
  auto n = plane::nearest(
      r, [](plane::Mark m) { return m > 0; }, at);
  return n ? n->distance.to_double() : std::numeric_limits<double>::infinity();
}

/// All of a set lies farther than `least` from the point.
bool beyond(const Region& r, const RealPoint& at, double least) {
  if (r.faces[0].mark > 0) return false;
  const std::optional<plane::PieceBox> box = plane::extent(r);
  if (!box) return false;
  const auto apart = [](double low, double high, const exact::Interval& c) {
    return std::max(low - c.hi, c.lo - high);
  };
  return std::max(apart(box->x0, box->x1, at.x.interval()), apart(box->y0, box->y1, at.y.interval())) > least;
}

/// Ends of arcs where a circle was only cut into halves are not vertices.
bool is_joint(const Region& r, Index v) {
  Index h = r.vertices[v].out;
  if (h == plane::kNone) return false;
  Index g = r.clockwise(h);
  return g != h && r.clockwise(g) == h && r.is_arc(h / 2) && r.is_arc(g / 2) &&
         same_supporting_curve(r.supporting_curve(h / 2), r.supporting_curve(g / 2));
}

void set_kind(FeatureAt& out, const Region& r, plane::Cell cell, const exact::Real& step) {
  using Kind = FeatureAt::Kind;
  const auto place = [&](const RealPoint& p) { return distance::coordinates(distance::times(step, p)); };
  if (cell.dimension == 0 && is_joint(r, cell.index)) cell = {1, r.vertices[cell.index].out / 2};
  if (cell.dimension == 2) {
    out.kind = Kind::kInside;
  } else if (cell.dimension == 0) {
    out.kind = Kind::kVertex;
    out.points = {place(r.geometry.exact(r.vertices[cell.index].point))};
  } else if (r.is_arc(cell.index)) {
    const exact::SupportingCurve& k = r.supporting_curve(cell.index);
    out.kind = Kind::kArc;
    out.points = {place({k.center_x(), k.center_y()})};
    out.radius = k.w() * step;
  } else {
    out.kind = Kind::kEdge;
    for (Index v : {r.edges[cell.index].v0, r.edges[cell.index].v1})
      out.points.push_back(place(r.geometry.exact(r.vertices[v].point)));
  }
}

}  // namespace

FeatureAt named_feature(const distance::Feature& f, const Region& region, const std::vector<std::string>& names,
                        const Shapes& shapes, const Parts& parts, const RealPoint& p, const exact::Real& step) {
  FeatureAt out;
  set_kind(out, region, *f.cell, step);
  RealPoint home = f.of_moving ? RealPoint{f.at.x - p.x, f.at.y - p.y} : f.at;
  double least = std::numeric_limits<double>::infinity();
  auto nearer = [&](const Region& r) {
    if (beyond(r, home, least)) return false;
    double d = away(r, home, f.cell->dimension == 2);
    if (!(d < least)) return false;
    least = d;
    return true;
  };
  for (const std::string& name : names)
    if (names.size() == 1 || nearer(shapes.at(name))) out.shape = name;
  least = std::numeric_limits<double>::infinity();
  auto collection = parts.find(out.shape);
  if (collection == parts.end()) return out;
  for (const auto& [part, r] : collection->second)
    if (nearer(r)) out.part = part;
  return out;
}

}  // namespace findspace::formula
