// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Solids from STEP and IGES files, where libfindspace_cad.so is installed (cad_model.h says why that is a library of
// its own). A solid of planes is the closed surface of the vertices that the file states, on the grid. A ball, a
// capsule or a box with all edges rounded is the hull of balls. Every other one is a mesh: within the tolerance of the
// rules for curves (ReadContext::drawing), near the true solid, inside or outside it (sided_mesh.h). Guarantee: the
// bound is proved for every point, up to how well the file's faces meet; nothing is rounded silently. Cost: that of
// Open CASCADE, and the proof of the side. Keywords: CAD import, B-rep, assembly.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "io/text/read_context.h"
#include "space/polytope/solid.h"

namespace findspace::io {

struct CadPart {
  std::string name;  // of the product, else of its place in the assembly
  space::Solid solid{};
  std::vector<space::Solid> balls{};  // where there are any: it is the hull of these, and `solid` is empty
};

/// Which parts are wanted: all, those of a part, an assembly or a place of that name, or one of them by its number from
/// 0.
struct CadChoice {
  std::optional<std::string> id{};
  std::optional<std::size_t> index{};
  bool balls = true;  // whether a part may come as balls, or all as meshes
};

/// `ending`: ".step", ".stp", ".iges", ".igs". `scale`: how many of the scene's unit a millimetre is. Throws Error:
/// kUnsupported without the library or for a face without a proved bound, kSyntax, kGeometry for what is not closed.
std::vector<CadPart> read_cad(const std::string& bytes, const std::string& ending, ReadContext& context,
                              const exact::Real& scale, const CadChoice& choice = {});

/// Whether files with that ending (small letters) are read so.
bool is_cad_ending(std::string_view ending);

/// Whether the library that reads them is there.
bool has_cad();

}  // namespace findspace::io
