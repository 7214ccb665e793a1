// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Curves before they are arranged, given to the observer of this thread (stage_observer.h). Guarantee: for pictures;
// arcs are polygons. Cost: none without an observer. Keywords: debug dump.
#pragma once

#include <span>

#include "plane/complex/arrangement.h"

namespace findspace::plane {

void observe_pieces(const char* stage, const char* title, const exact::Geometry& geometry,
                    std::span<const Piece> pieces);

}  // namespace findspace::plane
