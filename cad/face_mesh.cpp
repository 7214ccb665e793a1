// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "face_mesh.h"

#include <BRep_Tool.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>

#include "problem.h"

namespace findspace::cad {

Handle(Geom_Surface) surface_of(const TopoDS_Face& face) {
  Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
  if (surface.IsNull()) return surface;
  while (const auto trimmed = Handle(Geom_RectangularTrimmedSurface)::DownCast(surface))
    surface = trimmed->BasisSurface();
  return surface;
}

SolidCorners::SolidCorners(const TopoDS_Shape& solid) {
  TopExp::MapShapes(solid, TopAbs_VERTEX, vertices_);
  TopExp::MapShapes(solid, TopAbs_EDGE, edges_);
}

int SolidCorners::at_vertex(const TopoDS_Vertex& vertex) {
  const auto [at, fresh] = at_vertex_.emplace(vertices_.FindIndex(vertex), 0);
  if (fresh) at->second = add(BRep_Tool::Pnt(vertex));
  return at->second;
}

int SolidCorners::at_edge(const FaceMesh& f, int edge, double place, double t, const std::array<double, 2>& uv) {
  const auto [at, fresh] = at_edge_.emplace(std::pair{edge, place}, 0);
  if (!fresh) return at->second;
  double from = 0, to = 0;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(TopoDS::Edge(edges_(edge)), from, to);
  at->second = add(curve.IsNull() ? f.surface->Value(uv[0], uv[1]) : curve->Value(t));
  return at->second;
}

int SolidCorners::add(const gp_Pnt& p) {
  places_.push_back({p.X(), p.Y(), p.Z()});
  return int(places_.size()) - 1;
}

int add_node(FaceMesh& f, const std::array<double, 2>& uv, int corner) {
  f.at.push_back(uv);
  f.corner.push_back(corner);
  f.pole.push_back(-1);
  return int(f.at.size()) - 1;
}

signed char free_parameter(const FaceMesh& f, std::size_t node) {
  gp_Pnt p;
  gp_Vec du, dv;
  f.surface->D1(f.at[node][0], f.at[node][1], p, du, dv);
  return du.SquareMagnitude() <= dv.SquareMagnitude() ? 0 : 1;
}

Slack slack_of(const FaceMesh& f, const EdgePart& part, int a, int b) {
  if (!f.bounds) return {};
  const Handle(Geom2d_Curve)& curve = f.curves.at(part.edge).first;
  const auto chord = chord_bound(curve, part.t0, part.t1);
  if (!chord) fail(io::CadFault::kUnsupported, f.name() + " has an edge of a kind that has no proved bound here");
  const auto off = [&](int node, double t) {
    const gp_Pnt2d p = curve->Value(t);
    const int free = f.pole[std::size_t(node)];  // is no way off
    const auto& at = f.at[std::size_t(node)];
    return Slack{free == 0 ? 0 : std::abs(at[0] - p.X()), free == 1 ? 0 : std::abs(at[1] - p.Y())};
  };
  const Slack x = off(a, part.t0), y = off(b, part.t1);
  return {(*chord)[0] + std::max(x.u, y.u), (*chord)[1] + std::max(x.v, y.v)};
}

}  // namespace findspace::cad
