// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/query/summary.h"

#include <algorithm>
#include <numeric>

#include "exact/planar/geometry_signs.h"
#include "plane/query/summary_connect.h"
#include "plane/query/summary_sample.h"
#include "plane/query/topology.h"

namespace findspace::plane {
namespace {

/// Everything about one component, gathered cell by cell; numbers in grid steps.
struct Gathered {
  Index number = 0;  // in the Connection
  int dimension = 0;
  bool unbounded = false, boxed = false;
  Twofold area, dangling;
  Index face = kNone, edge = kNone,
        vertex = kNone;  // the largest face, the longest edge, a vertex: of the highest dimension
  Twofold face_area, edge_length;
  Index first = kNone;  // lexicographically smallest vertex of its closure
  Bounds box;
};

class Summarizer {
 public:
  Summarizer(const Region& s, const exact::Real& step)
      : s_(s), step_(step), measures_(s), connection_(connect(s)), parts_(connection_.count()) {
    for (Index k = 0; k < parts_.size(); ++k) parts_[k].number = k;
  }

  Summary run() {
    Summary r;
    set_truths(r);
    gather_faces();
    gather_edges(r);
    gather_vertices(r);
    add_components(r);
    return r;
  }

 private:
  void set_truths(Summary& r) const {
    r.empty = is_empty(s_);
    r.whole = is_whole(s_);
    r.bounded = is_bounded(s_);
    r.open = is_open(s_);
    r.closed = is_closed(s_);
    r.regular = is_regular(s_);
  }

  double scaled(const Twofold& steps) const { return (steps * step_).value(); }
  Place position(Index v) const { return {scaled(measures_.x(v)), scaled(measures_.y(v))}; }
  static bool longer(const Twofold& a, const Twofold& b) { return a.hi > b.hi || (a.hi == b.hi && a.lo > b.lo); }

  void extend(Gathered& g, const Place& p) const {
    if (!g.boxed) g.box = {p, p};
    g.boxed = true;
    for (int i : {0, 1}) {
      g.box.low[i] = std::min(g.box.low[i], p[i]);
      g.box.high[i] = std::max(g.box.high[i], p[i]);
    }
  }

  void see_vertex(Gathered& g, Index v) const {
    extend(g, position(v));
    auto point = [this](Index w) { return s_.vertices[w].point; };
    if (g.first == kNone || compare_xy(s_.geometry, point(v), point(g.first)) < 0) g.first = v;
  }

  void see_edge(Gathered& g, Index e) const {
    const Edge& edge = s_.edges[e];
    see_vertex(g, edge.v0);
    see_vertex(g, edge.v1);
    if (edge.half == 0 || right_of_center(s_.geometry, s_.vertices[edge.v0].point, edge.supporting_curve) >= 0 ||
        right_of_center(s_.geometry, s_.vertices[edge.v1].point, edge.supporting_curve) <= 0) {
      return;
    }
    const CellMeasures::Circle& k = measures_.circle(e);
    extend(g, {scaled(k.x), scaled(edge.half > 0 ? k.y + k.radius : k.y - k.radius)});
  }

  void gather_faces() {
    std::vector<Twofold> areas = measures_.face_areas();
    for (Index f = 0; f < s_.faces.size(); ++f) {
      if (s_.faces[f].mark == 0) continue;
      Gathered& g = parts_[connection_.faces[f]];
      g.dimension = 2;
      if (f == 0) g.unbounded = true;
      g.area += areas[f];
      if (g.face == kNone || (g.face != 0 && longer(areas[f], g.face_area))) {
        g.face = f;
        g.face_area = areas[f];
      }
    }
    for (Index h = 0; h < s_.half_edges.size(); ++h) {
      if (s_.faces[s_.face(h)].mark != 0) see_edge(parts_[connection_.faces[s_.face(h)]], h / 2);
    }
  }

  void gather_edges(Summary& r) {
    Twofold cracks;
    for (Index e = 0; e < s_.edges.size(); ++e) {
      const bool left = s_.faces[s_.face(2 * e)].mark != 0, right = s_.faces[s_.face(2 * e + 1)].mark != 0;
      const bool in = s_.edges[e].mark != 0;
      if (!in && left && right) cracks += measures_.length(e);
      if (!in || left || right) continue;  // an edge with a face of the set beside it was seen with the face
      Gathered& g = parts_[connection_.edges[e]];
      Twofold length = measures_.length(e);
      g.dimension = std::max(g.dimension, 1);
      g.dangling += length;
      if (g.edge == kNone || longer(length, g.edge_length)) {
        g.edge = e;
        g.edge_length = length;
      }
      see_edge(g, e);
    }
    r.crack_length = scaled(cracks);
  }

  void gather_vertices(Summary& r) {
    std::vector<Index> alone;
    for (Index v = 0; v < s_.vertices.size(); ++v) {
      if (s_.vertices[v].mark == 0) continue;
      Gathered& g = parts_[connection_.vertices[v]];
      g.vertex = v;
      see_vertex(g, v);
      if (g.dimension == 0) alone.push_back(v);  // faces and edges have been seen: the component is this point
    }
    std::sort(alone.begin(), alone.end(), [this](Index v, Index w) {
      return compare_xy(s_.geometry, s_.vertices[v].point, s_.vertices[w].point) < 0;
    });
    for (Index v : alone) r.isolated.push_back(position(v));
  }

  bool comes_before(const Gathered& a, const Gathered& b) const {
    if (a.unbounded != b.unbounded) return a.unbounded;
    if (a.dimension != b.dimension) return a.dimension > b.dimension;
    if (a.first != b.first && a.first != kNone && b.first != kNone) {
      return compare_xy(s_.geometry, s_.vertices[a.first].point, s_.vertices[b.first].point) < 0;
    }
    if (a.box.high != b.box.high) return a.box.high < b.box.high;
    return a.number < b.number;
  }

  Component component(const Gathered& g, Sampler& sampler) const {
    Component c;
    c.dimension = g.dimension;
    c.holes = connection_.holes[g.number];
    c.dangling_length = scaled(g.dangling);
    if (!g.unbounded) {
      c.area = scaled(g.area * step_);
      c.bbox = g.box;
    }
    c.sample_point = g.dimension == 2   ? sampler.inside_face(g.face)
                     : g.dimension == 1 ? sampler.middle_of_edge(g.edge)
                                        : s_.geometry.exact(s_.vertices[g.vertex].point);
    c.sample = {scaled(Twofold(c.sample_point.x)), scaled(Twofold(c.sample_point.y))};
    return c;
  }

  void add_components(Summary& r) const {
    std::vector<const Gathered*> order;
    for (const Gathered& g : parts_) {
      if (connection_.mark[g.number] != 0) order.push_back(&g);
    }
    std::sort(order.begin(), order.end(),
              [this](const Gathered* a, const Gathered* b) { return comes_before(*a, *b); });
    Sampler sampler(s_, measures_);
    Twofold area, dangling;
    Gathered all;
    for (const Gathered* g : order) {
      r.components.push_back(component(*g, sampler));
      area += g->area;
      dangling += g->dangling;
      if (!g->boxed) continue;
      extend(all, g->box.low);
      extend(all, g->box.high);
    }
    r.dangling_length = scaled(dangling);
    if (r.bounded) r.area = scaled(area * step_);
    if (r.bounded && all.boxed) r.bbox = all.box;
    for (Index k = 1; k < parts_.size(); ++k) r.holes += connection_.mark[k] == 0;
  }

  const Region& s_;
  Twofold step_;
  CellMeasures measures_;
  Connection connection_;
  std::vector<Gathered> parts_;
};

}  // namespace

Summary summarize(const Region& s, const exact::Real& step) { return Summarizer(s, step).run(); }

}  // namespace findspace::plane
