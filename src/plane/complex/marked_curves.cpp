// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/complex/marked_curves.h"

#include <utility>

namespace findspace::plane {
namespace {

using Fault = CurveFault;

Fault at_vertex(const Arrangement& a, Index v) {
  const exact::Point& p = a.geometry.points[a.vertex_point[v]];
  return {p.x, p.y};
}

Fault at_edge(const Arrangement& a, Index e) {
  Fault p = at_vertex(a, a.edges[e].v0), q = at_vertex(a, a.edges[e].v1);
  return {(p.x + q.x) / 2, (p.y + q.y) / 2};
}

/// Every vertex is one of the points given, and one only.
std::optional<Fault> shared_point(const Arrangement& a, const std::vector<char>& used) {
  std::vector<char> taken(a.vertex_count(), 0);
  for (Index p = 0; p < used.size(); ++p) {
    if (!used[p]) continue;
    if (taken[a.point_vertex[p]]++) return at_vertex(a, a.point_vertex[p]);
  }
  for (Index v = 0; v < a.vertex_count(); ++v) {
    if (!taken[v]) return at_vertex(a, v);
  }
  return std::nullopt;
}

/// No point lies inside a piece and no two pieces run along each other.
std::optional<Fault> shared_curve(const Arrangement& a) {
  for (Index i = 0; i < a.pieces.size(); ++i) {
    if (a.chain_start[i + 1] - a.chain_start[i] != 1) return at_vertex(a, a.edges[a.chain[a.chain_start[i]]].v1);
  }
  for (Index e = 0; e < a.edge_count(); ++e) {
    if (a.cover_start[e + 1] - a.cover_start[e] != 1) return at_edge(a, e);
  }
  return std::nullopt;
}

/// Marks of faces, each decided by all curves around it.
class FaceMarks {
 public:
  FaceMarks(const Arrangement& a, Mark far_away) : marks(a.face_count, far_away), known_(a.face_count, 0) {
    known_[0] = 1;
  }

  /// False where the face has been decided another mark.
  bool tell(Index face, Mark mark) {
    if (!known_[face]) marks[face] = mark;
    known_[face] = 1;
    return marks[face] == mark;
  }

  std::vector<Mark> marks;

 private:
  std::vector<char> known_;
};

}  // namespace

void MarkedCurves::mark(const Sides& sides) {
  for (std::size_t k = sides_.size(); k < curves.pieces.size(); ++k) {
    sides_.push_back(curves.forward[k] ? sides : Sides{sides.on, sides.right, sides.left});
  }
}

std::optional<Fault> MarkedCurves::mark_cells(const Arrangement& a, Marks& marks) const {
  FaceMarks faces(a, far_away_);
  marks.edges.assign(a.edge_count(), 0);
  marks.vertices.assign(a.vertex_count(), 0);
  for (Index i = 0; i < a.pieces.size(); ++i) {
    Index e = a.chain[a.chain_start[i]];
    marks.edges[e] = marks.vertices[a.edges[e].v0] = marks.vertices[a.edges[e].v1] = sides_[i].on;
    if (!faces.tell(a.face[2 * e], sides_[i].left) || !faces.tell(a.face[2 * e + 1], sides_[i].right))
      return at_edge(a, e);
  }
  for (const Isolated& p : isolated_) {
    Index v = a.point_vertex[p.at.point];
    if (!faces.tell(a.isolated_face[v], p.around)) return at_vertex(a, v);
    marks.vertices[v] = p.at.mark;
  }
  for (const MarkedPoint& p : vertices_) marks.vertices[a.point_vertex[p.point]] = p.mark;
  marks.faces = std::move(faces.marks);
  return std::nullopt;
}

std::variant<CellComplex, Fault> MarkedCurves::complex() && {
  std::vector<char> used(curves.geometry.points.size(), 0);
  for (const Piece& p : curves.pieces) used[p.p0] = used[p.p1] = 1;
  std::vector<Index> lonely;
  for (const Isolated& p : isolated_) {
    lonely.push_back(p.at.point);
    used[p.at.point] = 1;
  }
  Arrangement a = arrange(std::move(curves.geometry), std::move(curves.pieces), lonely);
  Marks marks;
  std::optional<Fault> fault = shared_point(a, used);
  if (!fault) fault = shared_curve(a);
  if (!fault) fault = mark_cells(a, marks);
  if (fault) return *fault;
  return extract(std::move(a), marks);
}

}  // namespace findspace::plane
