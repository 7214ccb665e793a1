// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Scenes that are asked otherwise than their files say: with another question, or with what moves rotated. Guarantee:
// exact; in space what has to be put on the grid is in the notes of the scene. Throws Error(kUnsupported) where the
// dimension or a motion forbids it, kBadValue for a range that only a file states. Cost: a copy of the scene, whose
// shapes are shared.
#pragma once

#include <findspace/scene.h>

#include <string>

#include "exact/number/real.h"
#include "io/scene/scene.h"
#include "space/shape/rotation.h"

namespace findspace {

struct Rotation::Data {
  std::string text;
  space::Rotation rotation;
  bool whole = false;  // it has its point; else it is about the scene's
};

namespace io {

/// The scene of positions in which what moves is rotated; in space, and in the plane by an angle about the point of
/// "free".
Scene rotated_scene(Scene scene, const Rotation::Data& given);
Scene turned_scene(Scene scene, const exact::Real& degrees);
Scene asking_scene(Scene scene, const findspace::Scene::Question& question);

}  // namespace io
}  // namespace findspace
