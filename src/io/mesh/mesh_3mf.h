// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// 3MF: the core part of the format (3MF Core Specification 1.3): the meshes of the objects that are built, components
// and transforms included, with the unit that the file states. What extensions add is passed over; a file that requires
// one is refused. Guarantee: coordinates and transforms are decimals, taken exactly. Errors: Error(kFile) for what is
// no package, kSyntax and kBadValue for what is not a model, with the element. Keywords: additive manufacturing, OPC.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "io/mesh/read_mesh_ply.h"
#include "io/mesh/write_mesh.h"

namespace findspace::io {

/// The model in a package.
struct Model3mf {
  std::string xml;
  exact::Real millimetres;  // of the file's unit
};
Model3mf open_3mf(std::string_view bytes, ReadContext& context);
void read_3mf(const Model3mf& model, MeshBuilder& out);

/// An object a kind, an item a copy. `unit` as scenes name it; empty: millimetres.
std::string text_3mf(const Assembly& assembly, std::string_view title, std::string_view unit);

}  // namespace findspace::io
