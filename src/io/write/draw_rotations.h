// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A set of angles as a dial: a ring with the angles that belong in colour, full and hollow dots at ends that belong and
// do not, dots for single angles, degrees counted counter-clockwise from the right. Keywords: polar plot, angular
// intervals.
#pragma once

#include <string>
#include <vector>

#include "io/write/write_rotations.h"

namespace findspace::io {

/// A picture of the scene (SVG) with the dial beside it.
std::string rotations_svg(const std::string& scene, const std::vector<DegreeInterval>& angles);

}  // namespace findspace::io
