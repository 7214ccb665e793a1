// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A solid of Open CASCADE as triangles with proved bounds. Its mesher proposes; what is promised is checked here: in
// the plane of parameters of each face the triangles and the boundary polygon are the same chain (every inner edge runs
// both ways), corners on shared edges are one corner for both faces, and the bound of each triangle is that of
// deviation.h, with the distance of its corners from the surface and of the boundary curve from its chord. At a pole,
// where a whole line of parameters is one point, each triangle takes that point at the parameter in its middle.
// Faces on planes keep the vertices of the file. Cost: that of the mesher, a few times where its first proposal is too
// coarse. Keywords: tessellation, B-rep.
#pragma once

#include <TopoDS_Shape.hxx>

#include "io/cad/cad_model.h"

namespace findspace::cad {

/// The solid with B-spline faces cut along their creases, where it has such.
TopoDS_Shape smooth_faces(const TopoDS_Shape& solid);

/// Throws Problem.
io::CadMesh mesh_of(const TopoDS_Shape& solid, double tolerance, std::size_t most);

struct Problem {
  io::CadProblem what;
};
[[noreturn]] void fail(io::CadFault fault, const std::string& message);

}  // namespace findspace::cad
