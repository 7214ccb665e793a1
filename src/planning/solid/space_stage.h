// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The world as one body of a placement sees it when its turn comes: what stands still, the bodies placed before it at
// their places, itself at the origin and free to move; and the formula of all conditions that count for it, in the
// names of this world. Distances between bodies that all stand are constants. Guarantee: exact. A body that stands off
// the grid has no surfaces for rays: Error(kUnsupported) says so where they are asked for.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "formula/solid/solve_rays.h"
#include "planning/solid/space_problem.h"

namespace findspace::planning {

class SpaceStage {
 public:
  /// Keeps a reference to the problem. `others` by body; that of `body` itself is passed over.
  SpaceStage(const SpaceProblem& problem, const SpacePoses& others, std::size_t body, std::size_t angle);

  const formula::Formula& formula() const { return formula_; }
  const std::vector<std::string>& moving() const { return moving_; }
  const exact::Real& step() const { return problem_.step; }
  int lines() const { return problem_.lines; }

  /// A shape of this world as the scene has it, and where it stands.
  struct Standing {
    std::string shape;
    space::RealVector at{};
  };
  const Standing& standing(const std::string& name) const { return standing_.at(name); }
  const formula::SpaceShape& built(const std::string& name) const { return problem_.built.at(standing(name).shape); }

  formula::SpaceWorld world(const std::vector<std::string>& moving) const;
  formula::SpaceWorld world() const { return world(moving_); }
  formula::RayWorld rays() const;

 private:
  using Names = std::vector<std::string>;

  void add_shapes(std::size_t body, const SpacePose& pose);
  bool counts(const std::vector<std::size_t>& bodies, const SpacePoses& others) const;
  formula::Formula bound(const Condition& condition) const;
  Names names(const Names& wanted, const Roles& roles) const;
  formula::Node bound_node(const formula::Node& node, const Condition& condition,
                           std::vector<formula::Atom>& atoms) const;
  bool moves(const Names& names) const;

  const SpaceProblem& problem_;
  std::size_t body_;
  std::map<std::string, Standing> standing_;  // by the name in this world
  std::map<std::size_t, Names> of_body_;      // names in this world, in the order of Body::shapes
  Names moving_;
  formula::Formula formula_;
};

}  // namespace findspace::planning
