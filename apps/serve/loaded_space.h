// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A loaded scene in space: its shapes, and the region of its formula, exactly where it is made of boxes or is one
// convex polytope, else on lines along all three axes. Guarantee: as of the verbs; a surface found on lines has its
// corners on the true frontier. Refused: angles, motions, distances between features.
#pragma once

#include <optional>
#include <string>

#include "serve/loaded.h"
#include "serve/space_drawing.h"

namespace findspace::app {

class LoadedSpace final : public Loaded {
 public:
  explicit LoadedSpace(const Scene& scene);

  std::string map_json(const RegionQuery& query) const override;
  std::string check_json(const Spot& spot, const CheckQuestion& question) const override;
  std::string nearest_json(const Spot& spot) const override;
  std::string measure_json(const Spot& spot) const override;
  std::string angles_json(const Spot& spot) const override;
  std::string instants_json(const Spot& spot) const override;
  std::string between_json(const Spot& spot, const Point& from, const Point& to) const override;

 private:
  std::string drawing_of(const std::string& shape) const override;
  const SpaceWindow& window() const;

  mutable std::optional<SpaceWindow> window_;  // of drawings
};

}  // namespace findspace::app
