// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What sets of boxes make: overlays, sums, images, the points nearest to and farthest from a place. Guarantee: exact.
// Keywords: Minkowski sum, Boolean operations, common refinement.
#pragma once

#include "space/box/box_complex.h"

namespace findspace::space {

BoxComplex mirrored(const BoxComplex& set);
BoxComplex translated(const BoxComplex& set, const RealVector& by);

/// Marks computed from those of several complexes over their common grid.
BoxComplex overlay(std::span<const BoxComplex* const> sets, const std::function<Mark(std::span<const Mark>)>& combine);
/// Of sets, painted on one grid.
BoxComplex united(std::span<const BoxComplex* const> sets);
/// {a + b}; sets.
BoxComplex sum(const BoxComplex& a, const BoxComplex& b);

/// The point of the closed set nearest to p; the squared distance of the farthest one. Nothing if empty (or unbounded).
std::optional<RealVector> nearest(std::span<const IntervalBox> boxes, const RealVector& p);
std::optional<RealVector> farthest(std::span<const IntervalBox> boxes, const RealVector& p);

}  // namespace findspace::space
