// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Meshes from files: STL (ASCII and binary), OBJ, OFF, PLY (ASCII, and binary of either byte order), 3MF, GLB, and the
// solids of STEP and IGES (io/cad) as one mesh, by the ending. Vertices are put on the grid (decimals exactly, binary
// floats as the exact values they are), equal ones joined, and the surface cleaned (space/mesh/mesh.h): it must be
// closed. What was changed is decided in the context's notes. Errors: Error(kFile) missing or truncated, kSyntax with
// the line, kGeometry not closed (with its open edges).
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "io/text/read_context.h"
#include "space/polytope/solid.h"

namespace findspace::io {

/// How many of the scene's unit make one of the file's numbers, given its millimetres where the file states a unit.
using MeshScale = std::function<exact::Real(const std::optional<exact::Real>& millimetres)>;

/// Throws Error, placed at the file.
space::Mesh read_mesh(const std::filesystem::path& path, ReadContext& context, const MeshScale& scale);

/// The mesh in `bytes`, read as a file with that ending (".stl", ".obj", ".off", ".ply", ".3mf", ".glb", ".step"), not
/// yet cleaned.
space::Mesh parse_mesh(const std::string& bytes, const std::string& ending, ReadContext& context,
                       const MeshScale& scale);

}  // namespace findspace::io
