// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The feasible region of a formula. All sign maps of the formula are laid over each other once; every vertex, edge and
// face of the overlay gets the truth of the formula (decision 1). Guarantee: the exact set, slots, points, open and
// closed boundaries included; where distances are known between bounds only, an inner and an outer set. Cost: one
// convolution a pair of shapes, one more for each level other than 0, one overlay; of many levels of one distance
// those that matter, which are not searched for crossings. Keywords: feasible region, configuration space, formula.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "formula/planar/prepared_world.h"
#include "formula/planar/region_bounds.h"

namespace findspace::formula {

/// In grid steps. Throws Error(kUnsupported) where it is known between bounds only.
plane::SignMap sign_map(const PreparedWorld& world, const SignMap& wanted);

/// The same map, given to the observer of this thread (stage_observer.h), if there is one.
plane::SignMap observed(const SignMap& wanted, plane::SignMap map);
/// Those of a formula, in order.
std::vector<plane::SignMap> sign_maps(const PreparedWorld& world, const Formula& formula);
/// {p : the formula holds at p}, of its sign maps in order. The overlay and the region are given to the observer.
plane::Region region_of(const Formula& formula, std::vector<plane::SignMap> maps);

using MakeSignMap = std::function<plane::SignMap(const SignMap&)>;
/// {p : the formula holds at p} of a formula that compares one distance with several levels, by those alone at which
/// its truth changes; nothing for another one, or where an observer is to see all sign maps. `make` gives levels of one
/// function.
std::optional<plane::Region> region_of_levels(const Formula& formula, const MakeSignMap& make);
/// The same, also where a distance with many levels is one of several.
std::optional<plane::Region> region_by_levels(const PreparedWorld& world, const Formula& formula);

/// Why the region of the formula is known between bounds only, if it is.
std::optional<exact::Refusal> between_bounds(const PreparedWorld& world, const Formula& formula);
/// {p : the formula holds at p}. Throws Error(kUnsupported) where it is known between bounds only.
plane::Region feasible(const PreparedWorld& world, const Formula& formula);
/// For shapes that rotate in time and distances in rotation, over the time of a motion too: positions that certainly
/// and that possibly belong to feasible(formula).
RegionBounds feasible_bounds(const PreparedWorld& world, const Formula& formula);

}  // namespace findspace::formula
