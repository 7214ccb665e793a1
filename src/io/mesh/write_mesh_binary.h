// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Surfaces as binary files: PLY with doubles (polygons kept, every bit of the vertices), and GLB (glTF 2.0: triangles,
// single floats, in metres with y upwards, as that format wants it). Guarantee: the same bytes on every machine.
#pragma once

#include <string>
#include <string_view>

#include "io/mesh/write_mesh.h"

namespace findspace::io {

std::string ply_text(const Surface& surface, std::string_view title);
/// A mesh a kind, a node a copy. `unit` as scenes name it; empty: metres.
std::string glb_text(const Assembly& assembly, std::string_view title, std::string_view unit);

}  // namespace findspace::io
