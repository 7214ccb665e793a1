// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Meshes from files: STL (ASCII and binary), OBJ, OFF, PLY (ASCII, and binary of either byte order), by the ending.
// Vertices are put on the grid (decimals exactly, binary floats as the exact values they are), equal ones joined, and
// the surface cleaned (space/mesh.h): it must be closed. What was changed is told in the context's notes. Errors:
// Error(kFile) missing or truncated, kSyntax with the line, kGeometry not closed (with its open edges).
#pragma once

#include <filesystem>
#include <string>

#include "io/read_context.h"
#include "space/solid.h"

namespace findspace::io {

/// Throws Error, placed at the file. `scale`: how many of the scene's unit make one of the file's numbers.
space::Mesh read_mesh(const std::filesystem::path& path, ReadContext& context, const exact::Real& scale = 1);

/// The mesh in `bytes`, read as a file with that ending (".stl", ".obj", ".off", ".ply"), not yet cleaned.
space::Mesh parse_mesh(const std::string& bytes, const std::string& ending, ReadContext& context,
                       const exact::Real& scale = 1);

}  // namespace findspace::io
