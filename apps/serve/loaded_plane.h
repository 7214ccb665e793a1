// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A loaded scene of the plane: its shapes as exact sets, and the region of its formula, made once. With an angle the
// moving shape is rotated as `check --angle` rotates it; the last angle is kept, as a page's slider asks about one
// after another. With an instant of a motion distances without inf or sup are those of this time. Guarantee: as of the
// verbs.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "formula/planar/solve.h"
#include "plane/build/transform.h"
#include "serve/loaded.h"
#include "serve/region_answers.h"

namespace findspace::app {

class LoadedPlane final : public Loaded {
 public:
  explicit LoadedPlane(io::Scene scene);

  std::string map_json(const RegionQuery& query) const override;
  std::string check_json(const Spot& spot, const CheckQuery& query) const override;
  std::string measure_json(const Spot& spot) const override;
  std::string explain_json(const std::optional<Spot>& spot) const override;
  std::string angles_json(const Spot& spot) const override;
  std::string instants_json(const Spot& spot) const override;
  std::string between_json(const Spot& spot, const std::array<exact::RealPoint, 2>& places) const override;

 private:
  /// The world with the moving shape rotated.
  struct Rotated {
    exact::Real degrees;
    std::shared_ptr<const formula::Solver> solver;
    plane::Rounding rounding;
    mutable std::shared_ptr<const RegionAnswers> answers;  // of the formula
  };

  std::string drawing_of(const std::string& shape) const override;
  formula::TriedNearest nearest(const Spot& spot) const override;
  void forget_answers() override;

  const formula::Solver& solver() const { return *upright_.solver; }
  const Rotated& rotated(const std::optional<exact::Real>& degrees) const;
  const RegionAnswers& answers(const Rotated& rotated) const;
  std::shared_ptr<const RegionAnswers> solved(const formula::Solver& solver, const formula::Formula& formula) const;
  std::string brief_json(const RegionAnswers& answers) const;
  exact::RealPoint about() const;
  bool is_rotating(const formula::Formula& formula) const;
  formula::Check check(const Spot& spot, const exact::RealPoint& at) const;
  formula::TriedNearest nearest(const Rotated& rotated, const exact::RealPoint& at) const;
  std::string drawing_json(const plane::Region& region) const;

  Rotated upright_;
  mutable std::optional<Rotated> rotated_;
};

}  // namespace findspace::app
