// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/rotation/rough_overlap.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "exact/margins/plane.h"

namespace findspace::plane {
namespace {

using Line = RoughSet::Line;

RoughPoint middle(const Line& e) {
  if (e.radius <= 0) return (e.p + e.q) / 2.0;
  const RoughPoint chord = e.q - e.p;
  return e.center + e.radius * chord * RoughPoint(0, -1) / std::abs(chord);
}

/// At most `tolerance` away from the edge.
bool is_near(const Line& e, RoughPoint at, double tolerance) {
  const double ends = std::min(std::norm(at - e.p), std::norm(at - e.q)), square = tolerance * tolerance;
  if (ends <= square) return true;
  const RoughPoint d = e.q - e.p;
  if (e.radius > 0) {
    const RoughPoint way = at - e.center;
    const double far = length(way);
    const RoughPoint projection = far > 0 ? e.center + way / far * e.radius : e.p;
    return cross(d, projection - e.p) <= 0 && std::abs(far - e.radius) <= tolerance;
  }
  const double along = dot(d, at - e.p), whole = std::norm(d), off = cross(d, at - e.p);
  return along > 0 && along < whole && off * off <= square * whole;
}

/// How often an upward ray from `at` crosses the edge, modulo 2.
bool crosses_upwards(const Line& e, RoughPoint at) {
  const double x = at.real();
  if ((e.p.real() <= x) == (e.q.real() <= x)) return false;  // edges are x-monotone only as they are drawn
  return cross(e.q - e.p, at - e.p) * (e.q.real() > e.p.real() ? 1 : -1) < 0;
}

/// The same for an arc: its chord, and the piece of disc between, whose boundary a ray meets an odd number of times
/// from inside. A point on the chord counts as above it, on a vertical one as to the right, as for the chord itself.
bool crosses_upwards_arc(const Line& e, RoughPoint at) {
  const RoughPoint d = e.q - e.p;
  const double side = cross(d, at - e.p), tie = d.real() != 0 ? d.real() : -d.imag();
  const bool beyond_chord = side < 0 || (side == 0 && tie < 0);
  return crosses_upwards(e, at) != (beyond_chord && std::abs(at - e.center) < e.radius);
}

/// Well inside the edge, for a point of its line or circle.
bool within(const Line& e, RoughPoint at, double tolerance) {
  const RoughPoint d = e.q - e.p;
  const double whole = length(d);
  if (e.radius > 0) return cross(d, at - e.p) < -tolerance * whole;
  const double along = dot(d, at - e.p);
  return along > tolerance * whole && along < (whole - tolerance) * whole;
}

bool steep(RoughPoint a, RoughPoint b) {
  return std::abs(cross(a, b)) > margin::kSteepCrossing * std::abs(a) * std::abs(b);
}

bool segments_cross(const Line& e, const Line& f, double tolerance) {
  const RoughPoint d = e.q - e.p, g = f.q - f.p;
  const double a = cross(d, f.p - e.p), b = cross(d, f.q - e.p);
  if ((a > 0) == (b > 0)) return false;
  const double r = tolerance * length(d), s = tolerance * length(g);
  if (!((a > r && b < -r) || (a < -r && b > r))) return false;
  const double u = cross(g, e.p - f.p), v = cross(g, e.q - f.p);
  return (u > s && v < -s) || (u < -s && v > s);
}

bool segment_crosses_arc(const Line& e, const Line& f, double tolerance) {
  const RoughPoint d = (e.q - e.p) / std::abs(e.q - e.p);
  const double height = cross(d, f.center - e.p), rest = f.radius * f.radius - height * height;
  if (rest <= margin::kNearTangentSquare * f.radius * f.radius) return false;
  const RoughPoint projection = f.center - height * d * RoughPoint(0, 1);
  for (double side : {-1.0, 1.0}) {
    const RoughPoint at = projection + side * std::sqrt(rest) * d;
    if (within(e, at, tolerance) && within(f, at, tolerance)) return true;
  }
  return false;
}

bool arcs_cross(const Line& e, const Line& f, double tolerance) {
  const RoughPoint way = f.center - e.center;
  const double d = std::abs(way);
  if (d <= tolerance) return false;
  const double along = (d * d + e.radius * e.radius - f.radius * f.radius) / (2 * d),
               rest = e.radius * e.radius - along * along;
  if (rest <= margin::kNearTangentSquare * e.radius * e.radius) return false;
  for (double side : {-1.0, 1.0}) {
    const RoughPoint at = e.center + way / d * RoughPoint(along, side * std::sqrt(rest));
    if (steep(at - e.center, at - f.center) && within(e, at, tolerance) && within(f, at, tolerance)) return true;
  }
  return false;
}

bool cross_surely(const Line& e, const Line& f, double tolerance) {
  if (e.radius > 0) return f.radius > 0 ? arcs_cross(e, f, tolerance) : segment_crosses_arc(f, e, tolerance);
  return f.radius > 0 ? segment_crosses_arc(e, f, tolerance) : segments_cross(e, f, tolerance);
}

Line moved(Line e, RoughPoint by) {
  e.p += by;
  e.q += by;
  e.center += by;
  return e;
}

}  // namespace

RoughSet::RoughSet(const CellComplex& c, const exact::RealPoint& about, const std::function<bool(Mark)>& inside)
    : unbounded_(inside(c.faces[0].mark)) {
  const RotatedNet net(c, about);
  std::vector<char> seen(net.vertex_count());
  for (const Index k : net.edges()) {
    const RotatedEdge e = net.edge(k);
    Line line{rough(e.p), rough(e.q), {}, 0};
    if (e.arc) {
      line.center = rough(e.center);
      line.radius = plane::rough(e.radius);
    }
    const bool left = inside(c.faces[c.face(2 * e.cell)].mark), right = inside(c.faces[c.face(2 * e.cell + 1)].mark);
    line.separates = left != right;
    line.bounds = left || right;
    lines_.push_back(line);
    points_.push_back(middle(line));
    seen[e.v0] = seen[e.v1] = 1;
  }
  for (Index v = 0; v < net.vertex_count(); ++v) {
    const bool isolated_inside =
        seen[v] == 0 && c.vertices[v].face != kNone && inside(c.faces[c.vertices[v].face].mark);
    points_.push_back(rough(net.vertex(v)));
    if (isolated_inside) lines_.push_back({points_.back(), points_.back(), {}, 0});
  }
}

RoughSet RoughSet::rotated(RoughPoint by) const {
  RoughSet out = *this;
  for (Line& e : out.lines_) {
    e.p *= by;
    e.q *= by;
    e.center *= by;
  }
  for (RoughPoint& p : out.points_) p *= by;
  return out;
}

bool RoughSet::contains(RoughPoint at, double tolerance) const {
  bool inside = unbounded_;
  for (const Line& e : lines_) {
    if (is_near(e, at, tolerance)) return false;
    if (e.separates && (e.radius > 0 ? crosses_upwards_arc(e, at) : crosses_upwards(e, at))) inside = !inside;
  }
  return inside;
}

double RoughSet::reach() const {
  double most = 0;
  for (const Line& e : lines_)
    most = std::max({most, std::abs(e.p), std::abs(e.q), e.radius > 0 ? std::abs(e.center) + e.radius : 0});
  for (const RoughPoint& p : points_) most = std::max(most, std::abs(p));
  return most;
}

bool well_inside(const RoughSet& b, const RoughSet& o, RoughPoint by, double tolerance) {
  for (const RoughPoint& p : b.points()) {
    if (o.contains(p + by, tolerance)) return true;
  }
  for (const RoughPoint& p : o.points()) {
    if (b.contains(p - by, tolerance)) return true;
  }
  return false;
}

bool surely_meets(const RoughSet& b, const RoughSet& o, RoughPoint by, bool either_way, double tolerance) {
  if (well_inside(b, o, by, tolerance)) return true;
  for (const Line& e : b.lines()) {
    const Line here = moved(e, by);
    for (const Line& f : o.lines()) {
      if ((f.bounds || (either_way && e.bounds)) && cross_surely(here, f, tolerance)) return true;
    }
  }
  return false;
}

}  // namespace findspace::plane
