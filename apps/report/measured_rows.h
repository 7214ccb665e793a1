// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Which distances the options of `measure` ask for.
#pragma once

#include <string>
#include <vector>

#include "common/options.h"
#include "formula/language/names.h"
#include "formula/language/position_answers.h"

namespace findspace::app {

/// The kinds that a measurement has to compute; none: all. Throws Error(kUsage) for an unknown --only.
std::vector<formula::Kind> wanted_kinds(const Options& options);
/// Those of --only; all without it.
std::vector<formula::DistanceAt> only_wanted(std::vector<formula::DistanceAt> distances, const Options& options);
/// Whether every distance that is there is printed.
inline bool shows_all(const Options& options) { return options.all || !options.only.empty(); }

}  // namespace findspace::app
