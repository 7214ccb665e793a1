// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// 3D shapes that come from files; the other 3D kinds are rows of the table in scene_space.cpp (see scene_shapes.h).
#pragma once

#include <filesystem>

#include "io/read/read_file.h"
#include "io/scene/scene_shapes.h"

namespace findspace::io {

/// The solid that the closed mesh in an .stl, .obj, .off, .ply, .3mf or .glb file encloses, the solids of a CAD file,
/// or a height field (.asc). For the kind "file" (scene_primitives.cpp).
plane::ShapePtr build_space_file(ShapeReader& reader, const std::filesystem::path& path, const FileChoice& choice,
                                 const JsonValue& at, const Label& label);

}  // namespace findspace::io
