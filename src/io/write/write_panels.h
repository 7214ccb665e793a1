// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Several pictures as panels of one: rows of drawings beside each other, as many a row as make the whole about as wide
// as it is high. Each keeps its own title, axes and legend. Guarantee: deterministic text. Keywords: small multiples,
// contact sheet, SVG.
#pragma once

#include <string>
#include <vector>

#include "io/write/write_svg.h"

namespace findspace::io {

/// The pictures' `panel` must differ.
std::string panels_svg(const std::string& title, const std::vector<SvgDrawing>& panels);

}  // namespace findspace::io
