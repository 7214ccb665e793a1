// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/sum/curve_sums.h"

#include <cstdlib>
#include <utility>
#include <vector>

#include "plane/base/real_vector.h"
#include "plane/complex/arrangement.h"

namespace findspace::plane {
namespace {

using exact::Real;
using exact::SupportingCurve;
/// An open edge: x-monotone from p to the lexicographically larger q.
struct OpenEdge {
  SupportingCurve supporting_curve;
  int half = 0;
  RealVector p, q;

  RealVector center() const { return {supporting_curve.center_x(), supporting_curve.center_y()}; }
  /// From the centre to an end, of length 1.
  RealVector unit(const RealVector& end) const { return (Real(1) / supporting_curve.w()) * (end - center()); }
};

struct BoundaryCells {
  std::vector<OpenEdge> edges;
  std::vector<RealVector> vertices;

  explicit BoundaryCells(const Region& r) {
    auto at = [&](Index v) { return r.geometry.exact(r.vertices[v].point); };
    for (const Edge& e : r.edges) {
      if (e.mark > 0) edges.push_back({r.geometry.supporting_curves[e.supporting_curve], e.half, at(e.v0), at(e.v1)});
    }
    for (Index v = 0; v < r.vertices.size(); ++v) {
      if (r.vertices[v].mark > 0) vertices.push_back(at(v));
    }
  }
};

/// Open curves and points, to become a set.
class OpenCurves {
 public:
  void point(const RealVector& p) { points_.push_back(geometry_.add_real_point(p.x, p.y)); }

  void edge(const SupportingCurve& supporting_curve, const RealVector& p, const RealVector& q, int half) {
    Index p0 = geometry_.add_real_point(p.x, p.y), p1 = geometry_.add_real_point(q.x, q.y);
    pieces_.push_back(
        {.supporting_curve = geometry_.add(supporting_curve), .p0 = p0, .p1 = p1, .half = std::int8_t(half)});
  }

  Region region() && {
    Arrangement a = arrange(std::move(geometry_), std::move(pieces_), points_);
    Marks marks;
    marks.faces.assign(a.face_count, 0);
    marks.edges.assign(a.edge_count(), 1);
    marks.vertices.assign(a.vertex_count(), 0);
    for (Index i = 0; i < a.pieces.size(); ++i) {
      for (Index k = a.chain_start[i] + 1; k < a.chain_start[i + 1]; ++k) marks.vertices[a.edges[a.chain[k]].v0] = 1;
    }
    for (Index p : points_) marks.vertices[a.point_vertex[p]] = 1;
    return extract(std::move(a), marks);
  }

 private:
  exact::Geometry geometry_;
  std::vector<Piece> pieces_;
  std::vector<Index> points_;
};

SupportingCurve line_through(const SupportingCurve& line, const RealVector& p) {
  return SupportingCurve::line(line.a, line.b, Real(line.a) * p.x + Real(line.b) * p.y);
}

void add_moved(OpenCurves& to, const OpenEdge& e, const RealVector& by) {
  if (e.half == 0) return to.edge(line_through(e.supporting_curve, e.p + by), e.p + by, e.q + by, 0);
  RealVector c = e.center() + by;
  to.edge(SupportingCurve::circle_at(c.x, c.y, e.supporting_curve.w()), e.p + by, e.q + by, e.half);
}

void add_lines(OpenCurves& to, const OpenEdge& e, const OpenEdge& f) {
  if (e.supporting_curve.a != f.supporting_curve.a || e.supporting_curve.b != f.supporting_curve.b) return;
  to.edge(line_through(e.supporting_curve, e.p + f.p), e.p + f.p, e.q + f.q, 0);
}

/// The place of the arc whose tangent is parallel to the line, if there is one.
void add_line_and_arc(OpenCurves& to, const OpenEdge& line, const OpenEdge& arc) {
  const SupportingCurve& k = line.supporting_curve;
  if (k.b == 0) return;  // vertical tangents are at the ends of arcs only
  Real length = sqrt(Real(exact::int128(k.a) * k.a + exact::int128(k.b) * k.b));
  Real scale = arc.supporting_curve.w() / ((k.b > 0) == (arc.half > 0) ? length : -length);
  RealVector place = arc.center() + scale * RealVector{Real(k.a), Real(k.b)};
  if (compare(place.x, arc.p.x) > 0 && compare(place.x, arc.q.x) < 0) add_moved(to, line, place);
}

/// Arcs with the same tangent: radii add where they bend to one side (sign = 1), else (-1) they are subtracted.
void add_arcs(OpenCurves& to, const OpenEdge& e, const OpenEdge& f, int sign) {
  if (e.half != sign * f.half) return;
  RealVector from = e.unit(e.p), until = e.unit(e.q);  // the common directions from the centres, by growing x
  RealVector other_from = f.unit(sign > 0 ? f.p : f.q), other_until = f.unit(sign > 0 ? f.q : f.p);
  if (sign < 0) {
    other_from = -other_from;
    other_until = -other_until;
  }
  if (compare(other_from.x, from.x) > 0) from = other_from;
  if (compare(other_until.x, until.x) < 0) until = other_until;
  if (compare(from.x, until.x) >= 0) return;
  Real radius =
      sign > 0 ? e.supporting_curve.w() + f.supporting_curve.w() : e.supporting_curve.w() - f.supporting_curve.w();
  RealVector c = e.center() + f.center(), p = c + radius * from, q = c + radius * until;
  int s = radius.sign();
  if (s == 0) return to.point(c);
  SupportingCurve circle = SupportingCurve::circle_at(c.x, c.y, abs(radius));
  if (s > 0)
    to.edge(circle, p, q, e.half);
  else
    to.edge(circle, q, p, -e.half);
}

}  // namespace

Region curve_sums(const Region& a, const Region& b) {
  BoundaryCells p(a), q(b);
  OpenCurves to;
  for (const RealVector& v : p.vertices) {
    for (const RealVector& w : q.vertices) to.point(v + w);
    for (const OpenEdge& f : q.edges) add_moved(to, f, v);
  }
  for (const OpenEdge& e : p.edges) {
    for (const RealVector& w : q.vertices) add_moved(to, e, w);
    for (const OpenEdge& f : q.edges) {
      if (e.half == 0 && f.half == 0)
        add_lines(to, e, f);
      else if (e.half == 0)
        add_line_and_arc(to, e, f);
      else if (f.half == 0)
        add_line_and_arc(to, f, e);
      else {
        add_arcs(to, e, f, 1);
        add_arcs(to, e, f, -1);
      }
    }
  }
  return std::move(to).region();
}

}  // namespace findspace::plane
