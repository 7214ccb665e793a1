// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/query/topology.h"

#include <algorithm>
#include <utility>

#include "plane/complex/simplify.h"

namespace findspace::plane {
namespace {

struct Extremes {
  Mark least, greatest;
  void see(Mark m) {
    least = std::min(least, m);
    greatest = std::max(greatest, m);
  }
};

Extremes star_of_edge(const CellComplex& c, Index e) {
  Extremes x{c.edges[e].mark, c.edges[e].mark};
  x.see(c.faces[c.face(2 * e)].mark);
  x.see(c.faces[c.face(2 * e + 1)].mark);
  return x;
}

Extremes star_of_vertex(const CellComplex& c, Index v) {
  const Vertex& vertex = c.vertices[v];
  Extremes x{vertex.mark, vertex.mark};
  if (vertex.out == kNone) {
    x.see(c.faces[vertex.face].mark);
    return x;
  }
  Index h = vertex.out;
  do {
    x.see(c.edges[h / 2].mark);
    x.see(c.faces[c.face(h)].mark);
    h = c.clockwise(h);
  } while (h != vertex.out);
  return x;
}

void set_marks(Region& s, const std::vector<Mark>& edges, const std::vector<Mark>& vertices) {
  for (Index e = 0; e < s.edges.size(); ++e) s.edges[e].mark = edges[e];
  for (Index v = 0; v < s.vertices.size(); ++v) s.vertices[v].mark = vertices[v];
}

/// Whether fit(mark, around) holds for every vertex or edge and each edge or face around it. What holds on the way from
/// a vertex to an edge and from there to a face holds from the vertex to the face.
template <class Fit>
bool marks_fit(const Region& s, Fit fit) {
  for (Index e = 0; e < s.edges.size(); ++e) {
    const Edge& edge = s.edges[e];
    if (!fit(edge.mark, s.faces[s.face(2 * e)].mark) || !fit(edge.mark, s.faces[s.face(2 * e + 1)].mark) ||
        !fit(s.vertices[edge.v0].mark, edge.mark) || !fit(s.vertices[edge.v1].mark, edge.mark))
      return false;
  }
  return std::all_of(s.vertices.begin(), s.vertices.end(),
                     [&](const Vertex& v) { return v.out != kNone || fit(v.mark, s.faces[v.face].mark); });
}

bool marks_are(const Region& s, const std::vector<Mark>& edges, const std::vector<Mark>& vertices) {
  for (Index e = 0; e < s.edges.size(); ++e) {
    if (s.edges[e].mark != edges[e]) return false;
  }
  for (Index v = 0; v < s.vertices.size(); ++v) {
    if (s.vertices[v].mark != vertices[v]) return false;
  }
  return true;
}

/// Marks of cl(int S). A vertex or an edge is in the closure of the interior exactly when a face of its star is in S:
/// the interior's edges and vertices have only such faces around them.
void mark_regularized(const Region& s, std::vector<Mark>& edges, std::vector<Mark>& vertices) {
  edges.assign(s.edges.size(), 0);
  vertices.assign(s.vertices.size(), 0);
  for (Index h = 0; h < s.half_edges.size(); ++h) {
    if (s.faces[s.face(h)].mark == 0) continue;
    edges[h / 2] = 1;
    vertices[s.origin(h)] = vertices[s.target(h)] = 1;
  }
  for (Index v = 0; v < s.vertices.size(); ++v) {
    if (s.vertices[v].out == kNone) vertices[v] = s.faces[s.vertices[v].face].mark;
  }
}

bool all_marks_are(const Region& s, Mark mark) {
  return !any_mark(s, [mark](Mark m) { return m != mark; });
}

}  // namespace

bool has_mark(const CellComplex& c, Mark wanted) {
  return any_mark(c, [wanted](Mark m) { return m == wanted; });
}

StarMarks star_marks(const CellComplex& c) {
  StarMarks marks;
  for (auto* of_edges : {&marks.edge_least, &marks.edge_greatest}) of_edges->reserve(c.edges.size());
  for (auto* of_vertices : {&marks.vertex_least, &marks.vertex_greatest}) of_vertices->reserve(c.vertices.size());
  for (Index e = 0; e < c.edges.size(); ++e) {
    Extremes x = star_of_edge(c, e);
    marks.edge_least.push_back(x.least);
    marks.edge_greatest.push_back(x.greatest);
  }
  for (Index v = 0; v < c.vertices.size(); ++v) {
    Extremes x = star_of_vertex(c, v);
    marks.vertex_least.push_back(x.least);
    marks.vertex_greatest.push_back(x.greatest);
  }
  return marks;
}

Region interior(Region s) {
  StarMarks marks = star_marks(s);
  set_marks(s, marks.edge_least, marks.vertex_least);
  return simplify(std::move(s));
}

Region closure(Region s) {
  if (is_closed(s)) return s;
  StarMarks marks = star_marks(s);
  set_marks(s, marks.edge_greatest, marks.vertex_greatest);
  return simplify(std::move(s));
}

Region boundary(Region s) {
  StarMarks marks = star_marks(s);
  for (Face& f : s.faces) f.mark = 0;
  for (Index e = 0; e < s.edges.size(); ++e) s.edges[e].mark = Mark(marks.edge_greatest[e] - marks.edge_least[e]);
  for (Index v = 0; v < s.vertices.size(); ++v) {
    s.vertices[v].mark = Mark(marks.vertex_greatest[v] - marks.vertex_least[v]);
  }
  return simplify(std::move(s));
}

Region regularize(Region s) {
  std::vector<Mark> edges, vertices;
  mark_regularized(s, edges, vertices);
  set_marks(s, edges, vertices);
  return simplify(std::move(s));
}

Region complement(Region s) {
  for (Face& f : s.faces) f.mark = Mark(1 - f.mark);
  for (Edge& e : s.edges) e.mark = Mark(1 - e.mark);
  for (Vertex& v : s.vertices) v.mark = Mark(1 - v.mark);
  return s;
}

bool is_open(const Region& s) {
  return marks_fit(s, [](Mark mark, Mark around) { return mark <= around; });
}

bool is_closed(const Region& s) {
  return marks_fit(s, [](Mark mark, Mark around) { return mark >= around; });
}

bool is_regular(const Region& s) {
  std::vector<Mark> edges, vertices;
  mark_regularized(s, edges, vertices);
  return marks_are(s, edges, vertices);
}

bool is_empty(const Region& s) { return all_marks_are(s, 0); }
bool is_whole(const Region& s) { return all_marks_are(s, 1); }
bool is_bounded(const Region& s) { return s.faces[0].mark == 0; }

}  // namespace findspace::plane
