// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A loaded scene of the plane. With an angle it is the scene with the moving shape rotated, its corners put on the
// grid; the last angle is kept, as a page's slider asks about one after another. With an instant of a motion distances
// without inf or sup are those of this time. Guarantee: as of the verbs.
#pragma once

#include <optional>
#include <string>

#include "serve/loaded.h"

namespace findspace::app {

class LoadedPlane final : public Loaded {
 public:
  explicit LoadedPlane(const Scene& scene);

  std::string map_json(const RegionQuery& query) const override;
  std::string check_json(const Spot& spot, const CheckQuestion& question) const override;
  std::string nearest_json(const Spot& spot) const override;
  std::string measure_json(const Spot& spot) const override;
  std::string angles_json(const Spot& spot) const override;
  std::string instants_json(const Spot& spot) const override;
  std::string between_json(const Spot& spot, const Point& from, const Point& to) const override;

 private:
  /// A scene with the moving shape rotated.
  struct Rotated {
    Number degrees;
    Scene scene;
  };

  std::string drawing_of(const std::string& shape) const override;
  void forget_answers() override;

  /// What is asked where the moving shape is rotated, or stands as it is drawn.
  const Scene& rotated(const std::optional<Number>& degrees) const;
  /// Of all shapes that are looked at.
  const std::optional<Bounds>& extent() const;
  std::string drawing_json(const Region& region) const;
  std::string brief_json(const RegionBounds& region) const;

  mutable std::optional<Scene> upright_;  // rotated by 0
  mutable std::optional<Rotated> rotated_;
  mutable std::optional<std::optional<Bounds>> extent_;
};

}  // namespace findspace::app
