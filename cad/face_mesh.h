// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The faces of a solid while they are meshed: of each one its triangles in the plane of its parameters, and the parts
// of its edges, which it shares with the faces across them. SolidCorners holds the corners of the solid, each once for
// all faces that meet there. Keywords: B-rep, parametric mesh.
#pragma once

#include <Geom2d_Curve.hxx>
#include <Geom_Surface.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <array>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "deviation.h"
#include "io/cad/cad_model.h"

namespace findspace::cad {

/// Without the trims around it; null where the face has none.
Handle(Geom_Surface) surface_of(const TopoDS_Face& face);

/// Lengths in the plane of parameters.
struct Slack {
  double u = 0, v = 0;
};

/// A part of an edge of the solid as a side of a triangle. Places along the edge are counted by the nodes of its first
/// polygon, and halved from there, so that they are the same for both faces.
struct EdgePart {
  int edge = 0;
  double place0 = 0, place1 = 0, t0 = 0, t1 = 0;  // t: parameters of the curve
  Slack slack{};
};

/// Two nodes of a face, in the order in which it runs.
using Segment = std::pair<int, int>;

using Triangle = std::array<int, 3>;

/// One face, its triangles in the plane of parameters, counter-clockwise there.
struct FaceMesh {
  int number = 0;
  TopoDS_Face face;  // forward
  bool reversed = false;
  Handle(Geom_Surface) surface;
  std::unique_ptr<const SurfaceBounds> bounds;  // null: flat
  std::vector<std::array<double, 2>> at;        // of each node
  std::vector<int> corner;                      // of the solid
  std::vector<signed char> pole;                // -1, or which parameter is free there
  std::vector<Triangle> triangles;
  std::map<Segment, EdgePart> boundary;
  std::map<int, std::pair<Handle(Geom2d_Curve), int>> curves;  // of edge parts, by use

  std::string name() const { return "face " + std::to_string(number) + " (" + kind_of(surface) + ")"; }
};

class SolidCorners {
 public:
  explicit SolidCorners(const TopoDS_Shape& solid);

  int number_of(const TopoDS_Edge& edge) const { return edges_.FindIndex(edge); }
  int at_vertex(const TopoDS_Vertex& vertex);
  /// The corner at a place of an edge: on its curve, else on the face that asks first.
  int at_edge(const FaceMesh& f, int edge, double place, double t, const std::array<double, 2>& uv);
  int add(const gp_Pnt& p);
  const std::vector<io::CadPlace>& places() const { return places_; }

 private:
  TopTools_IndexedMapOfShape vertices_, edges_;
  std::map<int, int> at_vertex_;
  std::map<std::pair<int, double>, int> at_edge_;
  std::vector<io::CadPlace> places_;
};

/// Another node, and its number.
int add_node(FaceMesh& f, const std::array<double, 2>& uv, int corner);

/// The parameter along which the surface stands still at a node.
signed char free_parameter(const FaceMesh& f, std::size_t node);

/// How far the boundary curve is from its chord, in parameters.
Slack slack_of(const FaceMesh& f, const EdgePart& part, int a, int b);

}  // namespace findspace::cad
