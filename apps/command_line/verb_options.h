// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The options that each verb has, in groups as its --help shows them. docs/commands.md is their manual.
#pragma once

#include <string_view>

namespace CLI {
class App;
}

namespace findspace::app {

struct Options;

/// The group of what most runs need.
inline constexpr const char* kCommon = "Common";

/// Gives `command` the options of the verb, which are written to `options`, and the examples at its end.
void add_options(CLI::App& command, std::string_view verb, Options& options);

}  // namespace findspace::app
