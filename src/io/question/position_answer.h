// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What a scene of the plane or of space answers at one position: whether its formula holds, and its distances. The
// verbs `check` and `measure`. Guarantee: exact, values with their bounds. Cost: that of the shapes and of the formula
// at one position; texts and pictures when they are asked for.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "formula/language/names.h"
#include "io/question/answer_data.h"
#include "io/question/asked_scene.h"

namespace findspace::io {

/// Where what moves stands, in the scene's unit; in the plane turned by `degrees` first.
struct PlanarPose {
  exact::RealPoint at;
  std::optional<exact::Real> degrees{};
};

Answer::Data check_in_plane(AskedScene asked, const PlanarPose& pose);
Answer::Data check_in_space(AskedScene asked, const space::RealVector& at);

/// Which distances are wanted: the kinds; none: all.
struct WantedDistances {
  std::vector<formula::Kind> kinds{};
  bool told = false;  // they are told as they are, not only the usual ones and those of the formula
};
/// By their words. Throws Error(kUnknownName).
WantedDistances wanted_distances(const std::vector<std::string>& words);

Answer::Data measure_in_plane(AskedScene asked, const PlanarPose& pose, const WantedDistances& wanted);
Answer::Data measure_in_space(AskedScene asked, const space::RealVector& at, const WantedDistances& wanted);

/// The values behind a check and a measurement (Answer::check and so on).
void show_check(Answer::Data& answer, std::shared_ptr<const formula::Check> check, formula::AskedNearest nearest);
void show_measured(Answer::Data& answer, std::shared_ptr<const std::vector<formula::DistanceAt>> distances);

}  // namespace findspace::io
