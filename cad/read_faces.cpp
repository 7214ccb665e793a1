// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "read_faces.h"

#include <BRep_CurveRepresentation.hxx>
#include <BRep_TEdge.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Plane.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <set>

#include "problem.h"

namespace findspace::cad {
namespace {

using io::CadFault;

/// Whether it lies between inside and outside; what is drawn within a solid or face does not.
bool bounds_it(const TopoDS_Shape& part) {
  return part.Orientation() == TopAbs_FORWARD || part.Orientation() == TopAbs_REVERSED;
}

/// A seam has two: that which runs with the edge's curve in the plane of parameters.
Handle(Poly_PolygonOnTriangulation) polygon_of(const TopoDS_Edge& edge, const Handle(Poly_Triangulation) & proposed,
                                               const Handle(Geom2d_Curve) & curve) {
  Handle(Poly_PolygonOnTriangulation) best;
  double least = 0;
  const auto take = [&](const Handle(Poly_PolygonOnTriangulation) & next) {
    if (next.IsNull()) return;
    const bool known = !curve.IsNull() && next->HasParameters();
    const double off = known ? proposed->UVNode(next->Node(1)).Distance(curve->Value(next->Parameter(1))) : 0;
    if (!best.IsNull() && off >= least) return;
    best = next;
    least = off;
  };
  for (const Handle(BRep_CurveRepresentation) & one : Handle(BRep_TEdge)::DownCast(edge.TShape())->Curves()) {
    if (!one->IsPolygonOnTriangulation() || one->Triangulation() != proposed) continue;
    take(one->PolygonOnTriangulation());
    if (one->IsPolygonOnClosedTriangulation()) take(one->PolygonOnTriangulation2());
  }
  return best;
}

/// Nodes of one pole become one, and triangles that are no more than a side then are dropped.
void join_poles(FaceMesh& f) {
  std::set<int> poles;
  for (std::size_t k = 0; k < f.at.size(); ++k)
    if (f.pole[k] >= 0) poles.insert(f.corner[k]);
  for (std::size_t k = 0; k < f.at.size(); ++k)  // the end of a seam is there too
    if (f.pole[k] < 0 && poles.count(f.corner[k]) > 0) f.pole[k] = free_parameter(f, k);
  std::map<int, int> first;
  std::vector<int> to(f.at.size());
  for (std::size_t k = 0; k < f.at.size(); ++k)
    to[k] = f.pole[k] < 0 ? int(k) : first.emplace(f.corner[k], int(k)).first->second;
  if (first.empty()) return;
  std::vector<Triangle> kept;
  for (Triangle t : f.triangles) {
    for (int& v : t) v = to[std::size_t(v)];
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) kept.push_back(t);
  }
  f.triangles = std::move(kept);
  std::map<Segment, EdgePart> parts;
  for (const auto& [segment, part] : f.boundary) {
    const Segment joined{to[std::size_t(segment.first)], to[std::size_t(segment.second)]};
    if (joined.first != joined.second) parts.emplace(joined, part);
  }
  f.boundary = std::move(parts);
}

/// Inner sides of triangles run both ways, the others are the boundary.
void check_chain(const FaceMesh& f) {
  std::map<Segment, int> balance;
  const auto count = [&](int a, int b, int by) { balance[std::minmax(a, b)] += a < b ? by : -by; };
  for (const auto& t : f.triangles)
    for (std::size_t i = 0; i < 3; ++i) count(t[i], t[(i + 1) % 3], 1);
  for (const auto& [segment, part] : f.boundary) count(segment.first, segment.second, -1);
  for (const auto& [segment, left] : balance)
    if (left != 0) fail(CadFault::kUnsupported, f.name() + " could not be meshed by Open CASCADE up to its edges");
}

/// The nodes and triangles that Open CASCADE proposes.
void take_nodes(FaceMesh& f, const Handle(Poly_Triangulation) & proposed) {
  for (int k = 1; k <= proposed->NbNodes(); ++k) {
    const gp_Pnt2d uv = proposed->UVNode(k);
    f.at.push_back({uv.X(), uv.Y()});
  }
  f.corner.assign(f.at.size(), -1);
  f.pole.assign(f.at.size(), -1);
  for (int k = 1; k <= proposed->NbTriangles(); ++k) {
    Triangle n{};
    proposed->Triangle(k).Get(n[0], n[1], n[2]);
    f.triangles.push_back({n[0] - 1, n[1] - 1, n[2] - 1});
  }
}

/// The sides along an edge, in the direction of the face.
void take_sides(FaceMesh& f, const TopoDS_Edge& edge, const Handle(Poly_PolygonOnTriangulation) & polygon, int use) {
  for (int k = 1; k < polygon->NbNodes(); ++k) {
    int a = polygon->Node(k) - 1, b = polygon->Node(k + 1) - 1;
    EdgePart part{use, double(k), double(k + 1), polygon->Parameter(k), polygon->Parameter(k + 1), {}};
    if (edge.Orientation() == TopAbs_REVERSED) {
      std::swap(a, b);
      std::swap(part.place0, part.place1);
      std::swap(part.t0, part.t1);
    }
    part.slack = slack_of(f, part, a, b);
    if (!f.boundary.emplace(Segment{a, b}, part).second) fail(CadFault::kGeometry, f.name() + " has an edge twice");
  }
}

void take_edge(FaceMesh& f, const TopoDS_Edge& edge, const Handle(Poly_Triangulation) & proposed,
               SolidCorners& corners) {
  double from = 0, to = 0;
  const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, f.face, from, to);
  const Handle(Poly_PolygonOnTriangulation) polygon = polygon_of(edge, proposed, curve);
  if (polygon.IsNull() || polygon->NbNodes() < 2 || !polygon->HasParameters() || curve.IsNull())
    fail(CadFault::kUnsupported, f.name() + " has an edge that could not be meshed by Open CASCADE");
  const TopoDS_Vertex first = TopExp::FirstVertex(edge), last = TopExp::LastVertex(edge);
  if (first.IsNull() || last.IsNull()) fail(CadFault::kGeometry, f.name() + " has an edge without end points");
  const bool point = BRep_Tool::Degenerated(edge);
  const int count = polygon->NbNodes(), index = corners.number_of(edge), use = int(f.curves.size());
  f.curves[use] = {curve, index};
  for (int k = 1; k <= count; ++k) {
    const auto node = std::size_t(polygon->Node(k)) - 1;
    f.corner[node] = point || k == 1 ? corners.at_vertex(first)
                     : k == count    ? corners.at_vertex(last)
                                     : corners.at_edge(f, index, k, polygon->Parameter(k), f.at[node]);
    if (point) f.pole[node] = free_parameter(f, node);
  }
  take_sides(f, edge, polygon, use);
}

/// The face without its mesh.
FaceMesh bare_face(const TopoDS_Face& given, int number) {
  FaceMesh f;
  f.number = number;
  f.face = TopoDS::Face(given.Oriented(TopAbs_FORWARD));
  f.reversed = given.Orientation() == TopAbs_REVERSED;
  f.surface = surface_of(given);
  if (f.surface.IsNull()) fail(CadFault::kUnsupported, f.name() + " could not be meshed by Open CASCADE");
  if (!Handle(Geom_Plane)::DownCast(f.surface).IsNull()) return f;
  f.bounds = SurfaceBounds::of(f.surface);
  if (!f.bounds)
    fail(CadFault::kUnsupported, f.name() + " has no proved bound here; give the part as a mesh (STL, 3MF) instead");
  return f;
}

FaceMesh read_face(const TopoDS_Face& given, int number, SolidCorners& corners) {
  FaceMesh f = bare_face(given, number);
  TopLoc_Location placed;
  const Handle(Poly_Triangulation) proposed = BRep_Tool::Triangulation(f.face, placed);
  if (proposed.IsNull() || !proposed->HasUVNodes() || proposed->NbTriangles() == 0)
    fail(CadFault::kUnsupported, f.name() + " could not be meshed by Open CASCADE");
  take_nodes(f, proposed);
  for (TopExp_Explorer at(f.face, TopAbs_EDGE); at.More(); at.Next())
    if (bounds_it(at.Current())) take_edge(f, TopoDS::Edge(at.Current()), proposed, corners);
  check_chain(f);
  for (std::size_t k = 0; k < f.at.size(); ++k)
    if (f.corner[k] < 0) f.corner[k] = corners.add(proposed->Node(int(k) + 1).Transformed(placed));
  join_poles(f);
  return f;
}

}  // namespace

std::vector<FaceMesh> read_faces(const TopoDS_Shape& solid, SolidCorners& corners) {
  std::vector<FaceMesh> faces;
  int number = 0;
  for (TopExp_Explorer at(solid, TopAbs_FACE); at.More(); at.Next()) {
    ++number;
    if (bounds_it(at.Current())) faces.push_back(read_face(TopoDS::Face(at.Current()), number, corners));
  }
  return faces;
}

}  // namespace findspace::cad
