// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The longest stretch of a direction in int E where no cover says it, as of unions of round parts and of solids that
// round ones are cut out of: B runs through it where all that it covers on its way fits at one position. So lengths are
// halved between one at which that fits and one at which it does not. Guarantee: as the search that is asked; lengths
// are decided to 2^-14 of the longest that boxes allow, unless it does not tell. Cost: some fifteen searches for a fit.
// Keywords: directional clearance, longest chord, swept volume.
#pragma once

#include <cstdint>
#include <functional>

#include "distance/answer/answer.h"
#include "distance/search/position_set.h"
#include "space/body/body_boxes.h"

namespace findspace::distance {

/// Whether a body fits somewhere with clearance, and where.
struct SweptFit {
  enum class Found { kSomewhere, kNowhere, kUnknown } found = Found::kUnknown;
  space::Vector at{};
};
/// Of a set of positions, next to a place, by so many cells at most.
SweptFit any_fit(const PositionSet& fits, const space::Vector& near, long cells);
/// Of a body in steps that are finer by that factor.
using FitSearch = std::function<exact::Tried<SweptFit>(const space::Body& swept, std::int64_t finer)>;

/// The least value of eta1 along the direction, of any length: `within` holds A. Nothing where B fits nowhere.
TriedAnswer least_of_swept_fits(const space::Body& b, const space::Bounds3& within, const space::RealVector& direction,
                                bool both_ways, const FitSearch& search);

}  // namespace findspace::distance
