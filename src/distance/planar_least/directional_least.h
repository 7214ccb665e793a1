// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The least value over all positions of a distance along a direction, and where it is taken. It is set by two places of
// one line along the direction: half their distance (both ways) or all of it (one way). Such lines pass a vertex or a
// place of an arc with the direction's tangent, or the two places lie on curves with parallel tangents there. All those
// lengths are candidates; the sign maps at candidates tell which one is the least value: below it there is nothing,
// below the next one something. Guarantee: exact. These distances jump, so the value may be an infimum that no position
// takes (then `at` is empty); it may be -infinity (then nothing `exists`). Cost: a section for each vertex and a pair
// of arcs each, and log2 of that many sign maps. Source: distances.md 7.1. Keywords: longest chord, argmin.
#pragma once

#include "distance/planar/directional.h"
#include "distance/planar_least/extremum.h"

namespace findspace::distance {

/// Of DirectionalSigned, or DirectionalFarthest if `farthest`, of the same base map.
Extremum least_directional(const plane::SignMap& base, const TranslationDirection& direction, bool farthest);

}  // namespace findspace::distance
