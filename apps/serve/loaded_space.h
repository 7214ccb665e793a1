// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A loaded scene in space: its shapes, and the region of its formula, exactly where it is made of boxes or is one
// convex polytope, else on lines along all three axes. Guarantee: as of the verbs; a surface found on lines has its
// corners on the true frontier. Refused: angles, motions, explanations, distances between features.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "formula/solid/solve_region.h"
#include "formula/solid/solve_space.h"
#include "serve/loaded.h"
#include "serve/space_drawing.h"

namespace findspace::app {

class LoadedSpace final : public Loaded {
 public:
  explicit LoadedSpace(io::Scene scene);

  std::string map_json(const RegionQuery& query) const override;
  std::string check_json(const Spot& spot, const CheckQuery& query) const override;
  std::string measure_json(const Spot& spot) const override;
  std::string explain_json(const std::optional<Spot>& spot) const override;
  std::string angles_json(const Spot& spot) const override;
  std::string instants_json(const Spot& spot) const override;
  std::string between_json(const Spot& spot, const std::array<exact::RealPoint, 2>& places) const override;

 private:
  std::string drawing_of(const std::string& shape) const override;
  formula::TriedNearest nearest(const Spot& spot) const override;
  void forget_answers() override { region_.reset(); }
  const formula::SpaceRegion& region() const;
  SpaceWindow window() const;
  formula::SpaceRegion solved(const formula::Formula& formula, const std::string& apply) const;
  formula::TriedNearest nearest(const space::RealVector& at) const;
  std::string map_of_line(const RegionQuery& query, const formula::Formula& formula) const;

  std::shared_ptr<const formula::SpaceSolver> solver_;
  mutable std::optional<SpaceWindow> window_;           // of drawings
  mutable std::optional<formula::SpaceRegion> region_;  // of the formula
};

}  // namespace findspace::app
