// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Reads boards of KiCad 5 to 9 (.kicad_pcb). What is kept is in board.h. Guarantee: a board or an Error with the place
// "name:line:column"; coordinates are exact on KiCad's own grid at multiples of 90 degrees, other footprints put their
// points on it once, and a note says so. Source: KiCad developer documentation, "Board file format".
#pragma once

#include <string>
#include <string_view>

#include "io/board/board.h"
#include "io/board/sexpr.h"

namespace findspace::io {

Board read_board(std::string_view text, const std::string& name);

/// The reference of a footprint: the text of its property or of its fp_text.
std::string reference_of(const Sexpr& footprint);
bool is_footprint(const Sexpr& item);

/// The names of all footprints in the order of the file: references, where those that several may share ("REF**", or
/// none) are numbered. Throws Error(kGeometry) where another reference stands twice.
std::vector<std::string> part_names(const std::vector<Sexpr>& footprints);

}  // namespace findspace::io
