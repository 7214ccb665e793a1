// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The verbs describe and convert for 3D scenes: the same options and the same results as in
// the plane, one dimension higher. Each is called by its verb once the scene is read and known to be 3D.
#pragma once

#include "common/session.h"
#include "io/question/space_shapes.h"

namespace findspace::app {

Outcome describe_space(const Session& session, const std::string& shape);
Outcome convert_space(const Session& session, const std::string& shape);

}  // namespace findspace::app
