// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A set of the plane from its exact boundary as write_cells.h writes it: the shape kind "cells", and the member "exact"
// of a result in a file. Nothing is rounded: a set written on another grid keeps its exact place. Guarantee: the cells
// are checked: curves that cross where they have no vertex, vertices off their curves and sides that disagree are
// refused with a place. Cost: one arrangement.
#pragma once

#include "io/text/scene_reader.h"

namespace findspace::io {

/// `scale`: how many of the scene's unit make one of the value's, where it states no unit itself.
plane::ShapePtr read_cells(const SceneReader& json, const JsonValue& value, const Label& label,
                           const exact::Real& scale = 1);

}  // namespace findspace::io
