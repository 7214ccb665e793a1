// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "brep_mesh.h"

#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <Geom_BSplineSurface.hxx>
#include <ShapeUpgrade_ShapeDivideContinuity.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <map>
#include <utility>

#include "face_promise.h"
#include "read_faces.h"
#include "refine_faces.h"

namespace findspace::cad {
namespace {

using io::CadFace;
using io::CadMesh;
using io::CadPlace;

/// The flat face as one polygon, where one circuit bounds it.
bool ring(const FaceMesh& f, CadMesh& out) {
  std::map<int, int> next;
  for (const auto& [segment, part] : f.boundary)
    if (!next.emplace(f.corner[std::size_t(segment.first)], f.corner[std::size_t(segment.second)]).second) return false;
  std::vector<int> corners;
  for (auto at = next.begin(); at != next.end() && corners.size() <= next.size(); at = next.find(at->second)) {
    if (!corners.empty() && at == next.begin()) break;
    corners.push_back(at->first);
  }
  if (corners.size() != next.size()) return false;
  if (f.reversed) std::reverse(corners.begin(), corners.end());
  out.faces.push_back({std::move(corners), f.number, true, 0, {}});
  return true;
}

CadMesh handed_over(const std::vector<FaceMesh>& faces, const std::vector<CadPlace>& places) {
  CadMesh out;
  out.places = places;
  const bool all_flat = std::all_of(faces.begin(), faces.end(), [](const FaceMesh& f) { return !f.bounds; });
  for (const FaceMesh& f : faces) {
    if (all_flat && ring(f, out)) continue;
    for (const auto& t : f.triangles) {
      const Promise p = promise_of(f, t, places);
      CadFace face{{f.corner[std::size_t(t[0])], f.corner[std::size_t(t[1])], f.corner[std::size_t(t[2])]},
                   f.number,
                   !f.bounds,
                   p.bound,
                   p.even ? even_direction(f.surface) : CadPlace{}};
      if (f.reversed) std::swap(face.corners[1], face.corners[2]);
      out.faces.push_back(std::move(face));
    }
  }
  for (const CadFace& f : out.faces) out.bound = std::max(out.bound, f.bound);
  return out;
}

bool has_free_forms(const TopoDS_Shape& solid) {
  for (TopExp_Explorer f(solid, TopAbs_FACE); f.More(); f.Next()) {
    const std::string kind = kind_of(surface_of(TopoDS::Face(f.Current())));
    if (kind != "plane" && kind != "cylinder" && kind != "cone" && kind != "sphere" && kind != "torus") return true;
  }
  return false;
}

}  // namespace

TopoDS_Shape smooth_faces(const TopoDS_Shape& solid) {
  bool creased = false;
  for (TopExp_Explorer f(solid, TopAbs_FACE); f.More() && !creased; f.Next()) {
    const auto spline = Handle(Geom_BSplineSurface)::DownCast(surface_of(TopoDS::Face(f.Current())));
    creased = !spline.IsNull() && !(spline->IsCNu(1) && spline->IsCNv(1));
  }
  if (!creased) return solid;
  ShapeUpgrade_ShapeDivideContinuity divide(solid);
  divide.SetSurfaceCriterion(GeomAbs_C1);
  divide.SetPCurveCriterion(GeomAbs_C0);
  divide.SetBoundaryCriterion(GeomAbs_C0);
  return divide.Perform() ? divide.Result() : solid;
}

/// The mesher's own search for nodes within faces makes fewer triangles, but on free forms it may not end.
io::CadMesh mesh_of(const TopoDS_Shape& solid, double tolerance, std::size_t most) {
  constexpr double kPart = 0.5;  // the bound counts a side's error twice: along the face, and from it
  IMeshTools_Parameters asked;
  asked.Deflection = tolerance * kPart;
  asked.Angle = 0.8;
  asked.InParallel = Standard_False;
  asked.ControlSurfaceDeflection = !has_free_forms(solid);
  asked.InternalVerticesMode = Standard_False;
  BRepTools::Clean(solid);
  const BRepMesh_IncrementalMesh mesher(solid, asked);
  SolidCorners corners(solid);
  std::vector<FaceMesh> faces = read_faces(solid, corners);
  refine_faces(faces, corners, tolerance, most);
  return handed_over(faces, corners.places());
}

}  // namespace findspace::cad
