// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Pictures of the stages of a computation (stage_observer.h) in the plane, in grid steps: every face, edge and vertex
// of a subdivision in the colour of its mark, with true arcs; polygons in outline. The mark of the unbounded face is
// white. Cost: linear. Keywords: debug dump.
#pragma once

#include <string>

#include "plane/base/stage_observer.h"
#include "plane/complex/cell_complex.h"

namespace findspace::io {

std::string stage_svg(const std::string& title, const plane::CellComplex& cells);
std::string stage_svg(const std::string& title, const plane::StageDrawing& drawing);

}  // namespace findspace::io
