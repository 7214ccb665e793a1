// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Packing in space and its check, for the verbs `pack` and `verify`.
#pragma once

#include <string>

#include "common/options.h"
#include "common/reporter.h"

namespace findspace::app {

/// `text`: of the problem.
Outcome run_pack_solids(const Options& options, const std::string& text, Reporter& reporter);
/// `layout`, `problem`: the texts of the two files.
Outcome run_verify_solids(const Options& options, const std::string& layout, const std::string& problem);

}  // namespace findspace::app
