// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The beginning of what several processes do together: where one cannot begin, none does, so that none waits for it.
#pragma once

#include <functional>

#include "common/options.h"

namespace findspace::app {

/// Every process of a team calls it. Throws what `begin` throws here, or Error(kFile) where it throws in another
/// process. After it all have begun.
void begin_together(const Options& options, const std::function<void()>& begin);

}  // namespace findspace::app
