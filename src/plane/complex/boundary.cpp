// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/complex/boundary.h"

#include <algorithm>
#include <cmath>

#include "plane/base/parallel.h"

namespace findspace::plane {

using exact::Geometry;
using exact::int128;
using exact::Real;

namespace {

/// The sum of two such coordinates fits a grid coordinate of Geometry.
constexpr std::int64_t kMost = std::int64_t(1) << 61;

bool fits(std::int64_t c) { return c <= kMost && c >= -kMost; }
bool fits(const std::optional<int128>& c) { return c && *c <= kMost && *c >= -kMost; }

}  // namespace

Position Position::of(const Geometry& g, Index point) {
  const exact::Point& p = g.points[point];
  if (p.kind == exact::Point::Kind::kGrid && fits(p.gx) && fits(p.gy)) {
    Position out;
    out.x = p.gx;
    out.y = p.gy;
    return out;
  }
  exact::RealPoint e = g.exact(point);
  return of(e.x, e.y);
}

Position Position::of(const Real& x, const Real& y) {
  Position out;
  auto ix = x.integer(), iy = y.integer();
  if (fits(ix) && fits(iy)) {
    out.x = std::int64_t(*ix);
    out.y = std::int64_t(*iy);
  } else {
    out.real = std::make_shared<const exact::RealPoint>(exact::RealPoint{x, y});
  }
  return out;
}

Position operator+(const Position& p, const Position& q) {
  Position out;
  if (p.grid() && q.grid()) {
    out.x = p.x + q.x;
    out.y = p.y + q.y;
  }
  if (p.grid() && q.grid() && fits(out.x) && fits(out.y)) return out;
  return Position::of(p.real_x() + q.real_x(), p.real_y() + q.real_y());
}

void Position::mirror() {
  if (real)
    *this = of(-real->x, -real->y);
  else {
    x = -x;
    y = -y;
  }
}

Direction Direction::of(const Real& x, const Real& y) {
  Direction d;
  auto ix = x.integer(), iy = y.integer();
  if (fits(ix) && fits(iy)) {
    d.x = std::int64_t(*ix);
    d.y = std::int64_t(*iy);
  } else
    d.real = std::make_shared<const exact::RealPoint>(exact::RealPoint{x, y});
  return d;
}

void Direction::mirror() {
  if (real)
    *this = of(-real->x, -real->y);
  else {
    x = -x;
    y = -y;
  }
}

Direction Direction::operator-() const {
  if (real) return of(-real->x, -real->y);
  Direction out;
  out.x = -x;
  out.y = -y;
  return out;
}

Position Direction::right_normal() const {
  if (real) return Position::of(real->y, -real->x);
  Position axis;
  axis.x = y;
  axis.y = -x;
  if (x == 0 || y == 0) return axis;  // primitive: of length 1
  int128 n2 = int128(x) * x + int128(y) * y;
  Real length = sqrt(Real(n2));
  return Position::of(Real(y) / length, Real(-x) / length);
}

namespace {

int sign_of(int128 k) { return (k > 0) - (k < 0); }

Real real_x(const Direction& d) { return d.real ? d.real->x : Real(d.x); }
Real real_y(const Direction& d) { return d.real ? d.real->y : Real(d.y); }

exact::Approx approx(const Real& r) {
  auto i = r.interval();
  double v = i.lo + (i.hi - i.lo) / 2;
  return {v, std::max(i.hi - v, v - i.lo) * exact::Approx::kGrow};
}

}  // namespace

bool is_lower(const Direction& d) {
  if (d.grid()) return d.y < 0 || (d.y == 0 && d.x < 0);
  int s = d.real->y.sign();
  return s < 0 || (s == 0 && d.real->x.sign() < 0);
}

int cross_sign(const Direction& p, const Direction& q) {
  if (p.grid() && q.grid()) return sign_of(int128(p.x) * q.y - int128(p.y) * q.x);
  Real px = real_x(p), py = real_y(p), qx = real_x(q), qy = real_y(q);
  exact::Approx c = approx(px) * approx(qy) - approx(py) * approx(qx);
  return c.sign() != 0 ? c.sign() : compare(px * qy, py * qx);
}

int dot_sign(const Direction& p, const Direction& q) {
  if (p.grid() && q.grid()) return sign_of(int128(p.x) * q.x + int128(p.y) * q.y);
  Real px = real_x(p), py = real_y(p), qx = real_x(q), qy = real_y(q);
  exact::Approx c = approx(px) * approx(qx) + approx(py) * approx(qy);
  return c.sign() != 0 ? c.sign() : (px * qx + py * qy).sign();
}

int compare_angle(const Direction& p, const Direction& q) {
  int hp = is_lower(p), hq = is_lower(q);
  return hp != hq ? hp - hq : -cross_sign(p, q);
}

Step Step::reversed() const {
  Step s = *this;
  std::swap(s.from, s.to);
  s.start = -end;
  s.end = -start;
  s.ccw = !ccw;
  return s;
}

void Step::mirror() {
  from.mirror();
  to.mirror();
  start.mirror();
  end.mirror();
  if (arc) center.mirror();
  half = std::int8_t(-half);
}

int compare_curvature(const Step& p, const Step& q) {
  int cp = p.arc ? (p.ccw ? 1 : -1) : 0, cq = q.arc ? (q.ccw ? 1 : -1) : 0;
  if (cp != cq) return cp > cq ? 1 : -1;
  return cp == 0 ? 0 : cp * compare(q.radius, p.radius);
}

namespace {

Direction arc_tangent(const Position& p, const Position& center, const Real& radius, bool ccw) {
  Real up = (p.real_y() - center.real_y()) / radius, right = (p.real_x() - center.real_x()) / radius;
  return ccw ? Direction::of(-up, right) : Direction::of(up, -right);
}

Step step_along(const CellComplex& c, Index h) {
  const Edge& e = c.edges[h / 2];
  const exact::SupportingCurve& k = c.supporting_curve(h / 2);
  Step s;
  s.from = Position::of(c.geometry, c.vertices[c.origin(h)].point);
  s.to = Position::of(c.geometry, c.vertices[c.target(h)].point);
  bool forward = c.heading(h).forward;
  if (e.half == 0) {
    s.start.x = forward ? k.b : -k.b;
    s.start.y = forward ? -k.a : k.a;
    s.end = s.start;
    return s;
  }
  s.arc = true;
  s.ccw = forward;
  s.half = e.half;
  s.radius = k.w();
  s.center = Position::of(k.center_x(), k.center_y());
  s.start = arc_tangent(s.from, s.center, s.radius, s.ccw);
  s.end = arc_tangent(s.to, s.center, s.radius, s.ccw);
  return s;
}

constexpr std::size_t kManySteps = 100;  // from here on ranges of them are made at once: tangents take microseconds

Path walk(const CellComplex& c, Index from) {
  std::vector<Index> way;
  Index h = from;
  do {
    way.push_back(h);
    h = c.next(h);
  } while (h != from);
  Path path;
  path.steps.resize(way.size());
  in_ranges(way.size(), kManySteps, [&](IndexRange some) {
    for (std::size_t k = some.first; k < some.end; ++k) path.steps[k] = step_along(c, way[k]);
  });
  return path;
}

Extent extent(const Path& path) {
  Extent e{1e300, 1e300, -1e300, -1e300};
  auto grow = [&](double x, double y) {
    e = {std::min(e.x0, x - 1), std::min(e.y0, y - 1), std::max(e.x1, x + 1), std::max(e.y1, y + 1)};
  };
  if (path.lonely) grow(path.lonely->approx_x(), path.lonely->approx_y());
  for (const Step& s : path.steps) {
    grow(s.from.approx_x(), s.from.approx_y());
    // Of an arc its highest or lowest point too, not its whole circle: a hole must not seem larger than it is.
    double x = s.arc ? s.center.approx_x() : 0;
    if (s.arc && (x - s.from.approx_x()) * (x - s.to.approx_x()) < 0)
      grow(x, s.center.approx_y() + s.half * s.radius.interval().hi);
  }
  return e;
}

}  // namespace

Part face_part(const CellComplex& c, const Face& f, const std::function<bool(Mark)>& wanted) {
  Part part;
  part.unbounded = f.outer == kNone;
  if (!part.unbounded) {
    part.paths.push_back(walk(c, f.outer));
    part.filled = extent(part.paths[0]);
  }
  for (Index h : f.inner) {
    part.paths.push_back(walk(c, h));
    part.holes.push_back(extent(part.paths.back()));
  }
  for (Index v : f.isolated) {
    if (wanted(c.vertices[v].mark)) continue;
    part.paths.push_back({{}, Position::of(c.geometry, c.vertices[v].point)});
    part.holes.push_back(extent(part.paths.back()));
  }
  part.euler = 1 - int(part.holes.size());
  return part;
}

std::vector<Part> face_parts(const CellComplex& c, const std::function<bool(Mark)>& wanted) {
  std::vector<Part> parts;
  for (const Face& f : c.faces)
    if (wanted(f.mark)) parts.push_back(face_part(c, f, wanted));
  return parts;
}

std::vector<Part> flat_parts(const CellComplex& c, const std::function<bool(Mark)>& wanted) {
  std::vector<Part> parts;
  auto touches_face = [&](Index h) { return wanted(c.faces[c.face(h)].mark) || wanted(c.faces[c.face(h ^ 1u)].mark); };
  for (Index e = 0; e < c.edges.size(); ++e) {
    if (!wanted(c.edges[e].mark) || touches_face(2 * e)) continue;
    Part part;
    part.flat = true;
    std::vector<Step> steps{step_along(c, 2 * e)};
    steps.push_back(steps[0].reversed());
    part.paths.push_back({std::move(steps), std::nullopt});
    part.filled = extent(part.paths[0]);
    parts.push_back(std::move(part));
  }
  for (const Vertex& v : c.vertices) {
    if (!wanted(v.mark)) continue;
    bool alone = true;
    if (v.out == kNone) alone = !wanted(c.faces[v.face].mark);
    for (Index h = v.out; h != kNone;) {
      alone = alone && !wanted(c.edges[h / 2].mark) && !touches_face(h);
      h = c.clockwise(h);
      if (h == v.out) break;
    }
    if (!alone) continue;
    Part part;
    part.flat = true;
    part.paths.push_back({{}, Position::of(c.geometry, v.point)});
    part.filled = extent(part.paths[0]);
    parts.push_back(std::move(part));
  }
  return parts;
}

Part mirrored(Part out) {
  for (Path& p : out.paths) {
    for (Step& s : p.steps) s.mirror();
    if (p.lonely) p.lonely->mirror();
  }
  auto turn = [](Extent& e) { e = {-e.x1, -e.y1, -e.x0, -e.y0}; };
  turn(out.filled);
  for (Extent& e : out.holes) turn(e);
  return out;
}

}  // namespace findspace::plane
