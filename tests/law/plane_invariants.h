// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The invariants of cell_complex.h, checked cell by cell.
#pragma once

#include <fmt/format.h>

#include <set>
#include <string>

#include "exact/planar/geometry_signs.h"
#include "plane/complex/cell_complex.h"

namespace findspace::plane {
namespace invariants {

inline std::string at(const char* what, Index k) { return fmt::format("{} {}", what, k); }

inline std::string edge_fault(const CellComplex& c, Index e) {
  const Edge& d = c.edges[e];
  const auto& g = c.geometry;
  Index p = c.vertices[d.v0].point, q = c.vertices[d.v1].point;
  if (compare_xy(g, p, q) >= 0) return at("ends out of order at edge", e);
  if (!lies_on(g, p, d.supporting_curve) || !lies_on(g, q, d.supporting_curve))
    return at("an end off its supporting curve at edge", e);
  if (g.supporting_curves[d.supporting_curve].circle != (d.half != 0)) return at("half of a line at edge", e);
  if (d.half != 0 &&
      (above_center(g, p, d.supporting_curve) * d.half < 0 || above_center(g, q, d.supporting_curve) * d.half < 0))
    return at("an end on the other half of the circle at edge", e);
  if (d.mark == c.faces[c.face(2 * e)].mark && d.mark == c.faces[c.face(2 * e + 1)].mark) return at("needless edge", e);
  return {};
}

inline std::string half_edge_fault(const CellComplex& c, Index h) {
  Index n = c.next(h);
  if (n >= c.half_edges.size() || c.face(h) >= c.faces.size()) return at("link out of range at half-edge", h);
  if (c.origin(n) != c.target(h)) return at("next starts elsewhere at half-edge", h);
  if (c.face(n) != c.face(h)) return at("next has another face at half-edge", h);
  return {};
}

/// All half-edges of the cycle of h.
inline std::set<Index> cycle(const CellComplex& c, Index h) {
  std::set<Index> all;
  for (Index k = h; all.insert(k).second;) k = c.next(k);
  return all;
}

inline std::string face_faults(const CellComplex& c) {
  std::set<Index> seen;
  std::size_t cycles = 0;
  for (Index f = 0; f < c.faces.size(); ++f) {
    const Face& face = c.faces[f];
    if ((f == 0) != (face.outer == kNone)) return at("outer boundary missing or too many at face", f);
    std::vector<Index> starts(face.inner.begin(), face.inner.end());
    if (face.outer != kNone) starts.push_back(face.outer);
    for (Index h : starts) {
      if (c.face(h) != f) return at("a boundary cycle of another face at face", f);
      std::set<Index> all = cycle(c, h);
      seen.insert(all.begin(), all.end());
      cycles += all.size();
    }
    for (Index v : face.isolated)
      if (c.vertices[v].out != kNone || c.vertices[v].face != f)
        return at("an isolated vertex of another face at face", f);
  }
  if (seen.size() != c.half_edges.size() || cycles != seen.size())
    return "boundary cycles do not cover the half-edges once";
  return {};
}

inline std::string vertex_fault(const CellComplex& c, Index v, Index degree) {
  const Vertex& w = c.vertices[v];
  if (w.out == kNone) {
    if (degree != 0) return at("edges at isolated vertex", v);
    return w.mark == c.faces[w.face].mark ? at("needless vertex", v) : std::string();
  }
  if (c.origin(w.out) != v) return at("out leads from elsewhere at vertex", v);
  Index count = 0, h = w.out;
  do {
    h = c.clockwise(h);
    ++count;
  } while (h != w.out && count <= degree);
  if (count != degree) return at("edges in several fans at vertex", v);
  // From `out` counter-clockwise: first those to the right (and straight up), 2e, then those to the left, 2e + 1.
  for (Index k = w.out, before = c.clockwise(k); before != w.out; k = before, before = c.clockwise(k)) {
    if (k == w.out) continue;
    bool later =
        (before & 1u) != (k & 1u) ? (before & 1u) : turn(c.geometry, w.point, c.heading(before), c.heading(k)) < 0;
    if (later) return at("out is not the first at vertex", v);
  }
  return {};
}

}  // namespace invariants

/// What is wrong with the links of a complex, or "".
inline std::string fault(const CellComplex& c) {
  if (c.faces.empty() || c.half_edges.size() != 2 * c.edges.size()) return "sizes";
  std::vector<Index> degree(c.vertices.size(), 0);
  for (Index e = 0; e < c.edges.size(); ++e) {
    if (std::string f = invariants::edge_fault(c, e); !f.empty()) return f;
    ++degree[c.edges[e].v0];
    ++degree[c.edges[e].v1];
  }
  for (Index h = 0; h < c.half_edges.size(); ++h)
    if (std::string f = invariants::half_edge_fault(c, h); !f.empty()) return f;
  if (std::string f = invariants::face_faults(c); !f.empty()) return f;
  for (Index v = 0; v < c.vertices.size(); ++v)
    if (std::string f = invariants::vertex_fault(c, v, degree[v]); !f.empty()) return f;
  return {};
}

}  // namespace findspace::plane
