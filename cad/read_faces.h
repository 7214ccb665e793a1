// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The faces of a solid that Open CASCADE has meshed, as it proposed them; refused where a proposal does not run along
// the edges. Cost: linear, with a logarithm. Keywords: B-rep, triangulation.
#pragma once

#include <vector>

#include "face_mesh.h"

namespace findspace::cad {

/// The corners that they have are added. Throws Problem.
std::vector<FaceMesh> read_faces(const TopoDS_Shape& solid, SolidCorners& corners);

}  // namespace findspace::cad
