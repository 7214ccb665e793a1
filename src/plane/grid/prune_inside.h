// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Cuts away what of a reduced convolution lies in cells that are certainly inside the sum (inner_mask.h), where jagged
// polygons make far more crossings than the sum has vertices. Guarantee: what is cut away lies in the open sum; the
// curves are cut on grid lines. Cost: curves * cells along each, and the mask. Keywords: pruning, hole filter.
#pragma once

#include "plane/grid/reduced_convolution.h"

namespace findspace::plane {

/// Of the curves of a convolution: how many, how long in all, and how far they reach.
struct CurveExtent {
  std::size_t count = 0;
  double length = 0, width = 0, height = 0;
};

/// Of segments placed at random (Buffon).
double estimated_crossings(const CurveExtent& curves);
/// Whether cutting pays: an estimated number of crossings well above the number of curves.
bool pruning_pays(const CurveExtent& curves);

/// For the curves of the convolution of a and b.
InnerMask mask_for(const CurveExtent& curves, const GridOperand& a, const GridOperand& b);
/// Where cutting the curves pays.
std::optional<InnerMask> mask_that_pays(const ReducedConvolution& convolution, const GridOperand& a,
                                        const GridOperand& b);
/// Does the segment lie in marked cells?
bool lies_in(const InnerMask& mask, const LatticeEdge& segment);
/// By the mask of the convolution, which is then done with.
ReducedConvolution prune_inside(ReducedConvolution convolution);

}  // namespace findspace::plane
