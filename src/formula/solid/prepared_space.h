// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The shapes of a world of solids in pairs, each made when first asked for and kept, and what is known of one distance:
// its value at a position, its least value, its signs everywhere or along a line. Positions are in grid steps.
// Guarantee: exact, or a refusal with the distance's name. Threads: any number. Internal to solve_space.h.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "formula/solid/solve_rays.h"
#include "formula/solid/solve_space.h"
#include "formula/solid/space_pair.h"

namespace findspace::formula {

struct PreparedSpace {
  explicit PreparedSpace(SpaceWorld of) : world(std::move(of)) {}

  struct Named {
    std::shared_ptr<const SpacePair> pair;
    distance::Which which;
  };
  /// The pair of a plain distance.
  exact::Tried<Named> named(const Distance& distance) const;

  SpaceWorld world;

 private:
  using Names = std::pair<std::vector<std::string>, std::vector<std::string>>;  // moving, fixed
  mutable std::mutex guard_;
  mutable std::map<Names, std::shared_ptr<const SpacePair>> pairs_;
};

exact::Tried<std::optional<distance::Answer>> value_at(const PreparedSpace& prepared, const Distance& distance,
                                                       const space::RealVector& p);
exact::Tried<distance::BoxMaps::Least> least(const PreparedSpace& prepared, const Distance& distance);
/// As SpaceSolver::try_nearly_least.
exact::Tried<std::optional<distance::Answer>> nearly_least(const PreparedSpace& prepared, const Distance& distance);
exact::Tried<space::BoxComplex> sign_map(const PreparedSpace& prepared, const SignMap& map);
/// The signs of one sign map along a line, as SpaceSolver::feasible_on.
exact::Tried<LineSigns> signs_on(const PreparedSpace& prepared, const SignMap& map, const SpaceLine& line);

// Along a direction: solve_space_line.cpp.
exact::Tried<std::optional<distance::Answer>> directional_value(const PreparedSpace& prepared, const Distance& distance,
                                                                const space::RealVector& p);
exact::Tried<space::BoxComplex> directional_map(const PreparedSpace& prepared, const SignMap& map);
/// Nothing where it is undefined or -infinity; refused but of boxes along an axis.
exact::Tried<std::optional<distance::BoxMaps::Least>> directional_least(const PreparedSpace& prepared,
                                                                        const Distance& distance);
exact::Tried<std::optional<distance::Answer>> directional_nearly_least(const PreparedSpace& prepared,
                                                                       const Distance& distance);
/// Whether the value at p is the least.
exact::Tried<bool> takes_least(const PreparedSpace& prepared, const Distance& distance,
                               const std::optional<distance::Answer>& v, const space::RealVector& p);

}  // namespace findspace::formula
