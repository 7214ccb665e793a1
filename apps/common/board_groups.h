// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The groups of parts that --group names: "power=U3,C7,C8".
#pragma once

#include <findspace/board.h>

#include <vector>

#include "common/options.h"

namespace findspace::app {

/// Throws Error(kUsage).
std::vector<BoardGroup> asked_groups(const Options& options);

}  // namespace findspace::app
