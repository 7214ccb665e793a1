// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/complex/cell_bytes.h"

#include <optional>
#include <span>
#include <utility>

namespace findspace::plane {
namespace {

using exact::Approx;
using exact::Geometry;
using exact::Real;
using exact::SupportingCurve;

constexpr std::uint64_t kLeastBytes = 8;  // of any item here

void put_approx(const Approx& a, ByteWriter& out) {
  out.put(a.value);
  out.put(a.error);
}

Approx take_approx(ByteReader& in) {
  const auto value = in.take<double>(), error = in.take<double>();
  return {value, error};
}

bool put_curve(const SupportingCurve& k, ByteWriter& out) {
  out.put(std::int8_t(k.circle));
  out.put(std::int8_t(k.grid));
  out.put(k.a);
  out.put(k.b);
  out.put(k.c);
  out.put(std::int8_t(k.real() != nullptr));
  if (k.real() && !(put_real(k.real()->x, out) && put_real(k.real()->y, out))) return false;
  for (const Approx& a : {k.x(), k.y(), k.z()}) put_approx(a, out);
  return put_real(k.w(), out);
}

SupportingCurve take_curve(ByteReader& in) {
  SupportingCurve k;
  k.circle = in.take<std::int8_t>() != 0;
  k.grid = in.take<std::int8_t>() != 0;
  k.a = in.take<std::int64_t>();
  k.b = in.take<std::int64_t>();
  k.c = in.take<exact::int128>();
  std::optional<exact::RealPoint> at;
  if (in.take<std::int8_t>() != 0) {
    Real x = take_real(in), y = take_real(in);
    at = {std::move(x), std::move(y)};
  }
  const Approx x = take_approx(in), y = take_approx(in), z = take_approx(in);
  k.set_filter(x, y, z);
  const Real w = take_real(in);
  k.reals = at ? exact::CurveReals(*std::move(at), w) : exact::CurveReals(w);
  return k;
}

void put_point(const exact::Point& p, ByteWriter& out) {
  out.put(p.kind);
  out.put(p.root);
  const bool grid = p.kind == exact::Point::Kind::kGrid;
  out.put(grid ? p.gx : std::int64_t(p.i));
  out.put(grid ? p.gy : std::int64_t(p.j));
  out.put(p.x);
  out.put(p.y);
  out.put(double(p.error));
}

exact::Point take_point(ByteReader& in) {
  exact::Point p;
  p.kind = in.take<exact::Point::Kind>();
  p.root = in.take<std::int8_t>();
  const auto first = in.take<std::int64_t>(), second = in.take<std::int64_t>();
  if (p.kind == exact::Point::Kind::kGrid) {
    p.gx = first;
    p.gy = second;
  } else {
    p.i = std::uint32_t(first);
    p.j = std::uint32_t(second);
  }
  p.x = in.take<double>();
  p.y = in.take<double>();
  p.error = in.take<double>();
  return p;
}

bool put_geometry(const Geometry& g, ByteWriter& out) {
  out.put(std::uint64_t(g.supporting_curves.size()));
  for (const SupportingCurve& k : g.supporting_curves)
    if (!put_curve(k, out)) return false;
  out.put(std::uint64_t(g.points.size()));
  for (const exact::Point& p : g.points) put_point(p, out);
  out.put(std::uint64_t(g.reals.size()));
  for (const exact::RealPoint& p : g.reals)
    if (!put_real(p.x, out) || !put_real(p.y, out)) return false;
  return true;
}

Geometry take_geometry(ByteReader& in) {
  Geometry g;
  for (std::uint64_t n = in.take_count(kLeastBytes); n > 0 && !in.failed(); --n)
    g.supporting_curves.push_back(take_curve(in));
  for (std::uint64_t n = in.take_count(kLeastBytes); n > 0 && !in.failed(); --n) g.points.push_back(take_point(in));
  for (std::uint64_t n = in.take_count(kLeastBytes); n > 0 && !in.failed(); --n) {
    Real x = take_real(in), y = take_real(in);
    g.reals.push_back({std::move(x), std::move(y)});
  }
  return g;
}

Vertex take_vertex(ByteReader& in) {
  Vertex v;
  v.point = in.take<Index>();
  v.mark = in.take<Mark>();
  v.out = in.take<Index>();
  v.face = in.take<Index>();
  return v;
}

Edge take_edge(ByteReader& in) {
  Edge e;
  e.v0 = in.take<Index>();
  e.v1 = in.take<Index>();
  e.supporting_curve = in.take<Index>();
  e.half = in.take<std::int8_t>();
  e.mark = in.take<Mark>();
  return e;
}

Face take_face(ByteReader& in) {
  Face f;
  f.mark = in.take<Mark>();
  f.outer = in.take<Index>();
  f.inner = ShortList<Index>(in.take_all<Index>());
  f.isolated = ShortList<Index>(in.take_all<Index>());
  return f;
}

}  // namespace

bool put_real(const Real& value, ByteWriter& out) {
  const auto fraction = value.fraction();
  if (!fraction) return false;
  out.put(*fraction);
  return true;
}

Real take_real(ByteReader& in) {
  const auto fraction = in.take<std::array<exact::int128, 2>>();
  return in.failed() ? Real() : Real::ratio(fraction[0], fraction[1]);
}

bool put_cells(const CellComplex& c, ByteWriter& out) {
  if (!put_geometry(c.geometry, out)) return false;
  out.put(std::uint64_t(c.vertices.size()));
  for (const Vertex& v : c.vertices) {
    out.put(v.point);
    out.put(v.mark);
    out.put(v.out);
    out.put(v.face);
  }
  out.put(std::uint64_t(c.edges.size()));
  for (const Edge& e : c.edges) {
    out.put(e.v0);
    out.put(e.v1);
    out.put(e.supporting_curve);
    out.put(e.half);
    out.put(e.mark);
  }
  out.put_all(std::span<const HalfEdge>(c.half_edges));
  out.put(std::uint64_t(c.faces.size()));
  for (const Face& f : c.faces) {
    out.put(f.mark);
    out.put(f.outer);
    out.put_all(std::span<const Index>(f.inner));
    out.put_all(std::span<const Index>(f.isolated));
  }
  return true;
}

std::optional<CellComplex> take_cells(ByteReader& in) {
  CellComplex c;
  c.geometry = take_geometry(in);
  for (std::uint64_t n = in.take_count(kLeastBytes); n > 0 && !in.failed(); --n) c.vertices.push_back(take_vertex(in));
  for (std::uint64_t n = in.take_count(kLeastBytes); n > 0 && !in.failed(); --n) c.edges.push_back(take_edge(in));
  c.half_edges = in.take_all<HalfEdge>();
  for (std::uint64_t n = in.take_count(kLeastBytes); n > 0 && !in.failed(); --n) c.faces.push_back(take_face(in));
  if (in.failed()) return std::nullopt;
  return c;
}

}  // namespace findspace::plane
