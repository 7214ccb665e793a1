// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// SupportingCurves and points of a geometry translated by an exact real vector, appended to another geometry in their
// order: crossings stay crossings of the moved supporting curves with the same root. Guarantee: exact. Cost: linear.
#pragma once

#include "plane/base/real_vector.h"
#include "plane/complex/cell_complex.h"

namespace findspace::plane {

/// Appends `from` + `by`; returns the index of its first point (its first supporting curve was the number of
/// supporting curves before).
Index append_moved(exact::Geometry& to, const exact::Geometry& from, const RealVector& by);

}  // namespace findspace::plane
