// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Layouts of solids as files: JSON with exact numbers, which read_solid_layout reads back; an assembly for mesh
// formats; a picture. Faults of a layout as sentences.
#pragma once

#include <string>

#include "io/mesh/write_mesh.h"
#include "io/nesting/write_layout.h"
#include "packing/solid_proof/verify_solids.h"

namespace findspace::io {

std::string layout_json(const packing::SolidProblem& problem, const packing::SolidLayout& layout,
                        const LayoutFacts& facts);
/// A surface a part, in units, and its copies where they stand. Balls become inscribed polyhedra.
Assembly layout_assembly(const packing::SolidProblem& problem, const packing::SolidLayout& layout);
/// A part about its origin, not turned, in units. Balls become inscribed polyhedra.
Surface part_surface(const packing::SolidProblem& problem, std::size_t part);
/// What a kind of container holds, in units.
Surface container_surface(const packing::SolidProblem& problem, std::size_t kind);
/// A view from above, with the container.
std::string layout_svg(const packing::SolidProblem& problem, const packing::SolidLayout& layout,
                       const LayoutFacts& facts);

/// "bracket#3"
std::string item_name(const packing::SolidProblem& problem, const packing::SolidLayout& layout, std::size_t item);
std::string fault_text(const packing::SolidProblem& problem, const packing::SolidLayout& layout,
                       const packing::SolidFault& fault);

}  // namespace findspace::io
