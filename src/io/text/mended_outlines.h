// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Outlines of drawings that touch, or cross themselves and each other by a little (plane/build/mended_rings.h): how
// little that is, by the rules of the drawing, and what is said of it. Where nothing is asked for it is what rounding
// does: four grid steps, with curves twice their tolerance. --join allows its width, and --mend states the width alone:
// 0 refuses every crossing. Never silent: a note counts the places. Keywords: self-intersection, polygon repair.
#pragma once

#include <optional>
#include <vector>

#include "findspace/error.h"
#include "io/text/read_context.h"
#include "plane/build/mended_rings.h"

namespace findspace::io {

/// Closed chains with arcs in place of their curves.
struct Outlines {
  std::vector<plane::Contour> contours;
  std::vector<std::optional<bool>> material_left{};  // of each, where the side of its curves relies on it
  std::vector<bool> is_hole{};                       // of each, where that is known
  bool curved = false;
};

/// Throws `fault`, which says why the outlines are not valid as they are, where they are not mended; it then names the
/// --join (--mend) that would do, or the tolerance where curves are too near to each other for it.
plane::MendedRings mended_outlines(const Outlines& outlines, const Error& fault, ReadContext& context,
                                   const std::string& name);

}  // namespace findspace::io
