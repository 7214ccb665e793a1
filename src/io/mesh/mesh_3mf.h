// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// 3MF: the core part of the format (3MF Core Specification 1.3): the meshes of the objects that are built, components
// and transforms included, with the unit that the file states. What extensions add is passed over; a file that requires
// one is refused. Guarantee: coordinates and transforms are decimals, taken exactly; the unpacked text is never whole
// in memory. Errors: Error(kFile) for what is no package, kSyntax and kBadValue for what is not a model, with the
// element. Keywords: additive manufacturing, OPC.
#pragma once

#include <string>
#include <string_view>

#include "io/mesh/read_mesh.h"
#include "io/mesh/write_mesh.h"

namespace findspace::io {

/// Where a package holds its model, unless it says so.
inline constexpr const char* kModel3mf = "3D/3dmodel.model";
/// What the relation to the model is called.
inline constexpr const char* kModelType3mf = "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel";

/// All that is built, not yet cleaned.
space::Mesh read_3mf(std::string_view bytes, ReadContext& context, const MeshScale& scale);

/// An object a kind, an item a copy. `unit` as scenes name it; empty: millimetres.
std::string text_3mf(const Assembly& assembly, std::string_view title, std::string_view unit);

}  // namespace findspace::io
