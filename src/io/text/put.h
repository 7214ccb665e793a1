// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Text made piece by piece: put(out, "{} {}\n", a, b) appends what fmt makes of a and b to the string.
#pragma once

#include <fmt/core.h>

#include <string>

namespace findspace::io {

/// The formatter itself: compiled once, since each file that has it takes two seconds longer to compile.
void put_formatted(std::string& out, fmt::string_view format, fmt::format_args arguments);

template <class... Args>
void put(std::string& out, fmt::format_string<Args...> format, Args&&... arguments) {
  put_formatted(out, format, fmt::make_format_args(arguments...));
}

}  // namespace findspace::io
