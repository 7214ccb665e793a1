// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The files that results go to, by their endings. Guarantee: all or none are written.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "common/options.h"

namespace findspace::app {

/// How a verb writes its result in one format, e.g. {".svg", ...}.
using Writers = std::map<std::string, std::function<std::string()>>;
/// The same for results that are too long for memory.
using Streams = std::map<std::string, std::function<void(const TextSink&)>>;

/// Throws Error(kUsage) where an output has an ending that is not among the formats, or is the input itself. Of a team
/// all call it, and all throw what the leader finds: only that one has outputs.
void check_outputs(const Options& options, const std::vector<std::string>& formats);

/// Makes all texts first, then writes them: a failure leaves no file.
void write_outputs(const Options& options, const Writers& writers, const Streams& streams = {});

}  // namespace findspace::app
