// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A shape of a scene as a point set: what the verb `describe` prints, as an answer. Guarantee: exact in the plane, and
// in space where it is made of boxes or is one convex set; else on lines (ray_map.h). Cost: that of making the set.
// Keywords: inspect, volume, area.
#pragma once

#include <findspace/scene.h>
#include <findspace/shape.h>

#include <string>

#include "io/question/answer_data.h"
#include "io/question/asked_scene.h"

namespace findspace::io {

/// Of the plane: `shape` is the one of that name.
Answer::Data described_in_plane(const AskedScene& asked, const std::string& name, const Shape& shape);
Answer::Data described_in_space(AskedScene asked, const std::string& name, const ShapeQuestion& question);

}  // namespace findspace::io
