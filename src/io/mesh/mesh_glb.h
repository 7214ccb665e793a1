// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// GLB, the binary form of glTF 2.0 (Khronos): the triangles, strips and fans of what the file's scene shows, where its
// nodes place them, with z upwards instead of y. Materials, skins, morph targets and animations change nothing here;
// points and lines are passed over with a note. Guarantee: numbers of the binary chunk and of transforms are taken
// exactly, and a quaternion is the rotation of its direction. Cost: linear in the file and in what nodes repeat, which
// counts as work. Errors: Error(kFile) for what is cut off, kBadValue for what is no model, kUnsupported for files
// beside it and for extensions that pack meshes. Keywords: glTF, scene graph, assembly.
#pragma once

#include <string>

#include "io/mesh/read_mesh_ply.h"

namespace findspace::io {

void read_glb(const std::string& bytes, ReadContext& context, MeshBuilder& out);

}  // namespace findspace::io
