// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Which lines a map of space is taken on: how many or how far apart, along which axis, or along all three.
#pragma once

#include <findspace/scene.h>

#include <optional>

#include "common/session.h"

namespace findspace::app {

/// What --resolution, --step, --axis, --axes and --side ask for; nothing without the first two. Throws Error(kUsage).
std::optional<MapLines> asked_lines(const Session& session);

/// Throws Error(kUsage) where one of these options was given: the verb's question has no lines in space.
void refuse_lines(const Options& options, const char* because);

}  // namespace findspace::app
