// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Surfaces as STEP (ISO 10303-21, AP214): each connected piece is a faceted solid of flat faces, each label a product
// of its own with the pieces that bear it, where they stand; several are an assembly of the title. Guarantee: vertices
// keep every bit; the unit is the scene's. Cost: linear. Keywords: CAD export, faceted B-rep, product.
#pragma once

#include <string>
#include <string_view>

#include "io/mesh/write_mesh.h"

namespace findspace::io {

/// `unit`: um mm cm m in mil; empty counts as mm. Error(kUnsupported) for faces of fewer than three corners.
std::string step_text(const Surface& surface, std::string_view title, std::string_view unit);

}  // namespace findspace::io
