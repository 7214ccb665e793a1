// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Bodies, unions of open convex sets and sets of boxes, given to the observer of this thread (stage_observer.h).
// Guarantee: for pictures. Parts without their radii; of a ball an octahedron in it; of a long list the first sets.
// Cost: none without an observer. Keywords: debug dump.
#pragma once

#include <string>

#include "space/body/body.h"
#include "space/body/open_union.h"
#include "space/box/box_complex.h"

namespace findspace::space {

/// The convex parts.
void observe_body(const std::string& title, const Body& body);
/// The bounded sets.
void observe_union(const std::string& title, const OpenUnion& sets);
/// The bounded boxes of the cells whose mark is not that of cell (0, 0, 0), which is far from all.
void observe_boxes(const char* stage, const std::string& title, const BoxComplex& set);

}  // namespace findspace::space
