// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What a scene of the plane or of space answers at one position: whether its formula holds, and its distances. The
// verbs `check` and `measure`. Guarantee: exact, values with their bounds. Cost: that of the shapes and of the formula
// at one position; texts and pictures when they are asked for.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "formula/language/names.h"
#include "formula/planar/solve_rotation.h"
#include "io/question/answer_data.h"
#include "io/question/asked_scene.h"

namespace findspace::io {

/// Where what moves stands, in the scene's unit; in the plane turned by `degrees` first, as they are asked for.
struct PlanarPose {
  exact::RealPoint at;
  std::optional<exact::Real> degrees{};
};

/// The same for the solver of rotations, about the point that the scene names where it ranges over angles.
formula::Pose rotation_pose(const AskedScene& asked, const PlanarPose& pose);

/// What a check is asked for besides.
struct CheckWishes {
  bool nearest = true;  // the nearest feasible position, where the position is none
  exact::Real snap{};   // go to a corner, an edge, in space to the nearest feasible position, within this
};
Answer::Data check_in_plane(AskedScene asked, const PlanarPose& pose, const CheckWishes& wishes);
Answer::Data check_in_space(AskedScene asked, const space::RealVector& at, const CheckWishes& wishes);

/// The nearest feasible position alone.
Answer::Data nearest_in_plane(AskedScene asked, const exact::RealPoint& at);
Answer::Data nearest_in_space(AskedScene asked, const space::RealVector& at);
Answer::Data nearest_answer(const AskedScene& asked, formula::TriedNearest near, const distance::Coordinates& from);

/// The features that are nearest to two places, where what moves stands at `at` (feature_pair.h).
Answer::Data between_in_plane(AskedScene asked, const exact::RealPoint& at,
                              const std::array<exact::RealPoint, 2>& places);

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
std::optional<NearestPlace> nearest_place(const formula::AskedNearest& nearest);
void show_measured(Answer::Data& answer, std::shared_ptr<const std::vector<formula::DistanceAt>> distances);

}  // namespace findspace::io
