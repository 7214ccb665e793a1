// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Options of questions as a value of Python, or as its words beside the other arguments of a call.
#pragma once

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <optional>
#include <string>

#include "findspace/options.h"

namespace findspace::python {

namespace py = pybind11;

/// 'time', 'memory' or 'cancelled'.
inline const char* limit_name(Limit limit) {
  return limit == Limit::kTime ? "time" : limit == Limit::kMemory ? "memory" : "cancelled";
}
inline std::optional<std::string> limit_name(const std::optional<Limit>& limit) {
  return limit ? std::optional<std::string>(limit_name(*limit)) : std::nullopt;
}

/// What was given, or made of the words; a TypeError for both, and for a word that is none.
Options options_of(const std::optional<Options>& given, const py::kwargs& words);

}  // namespace findspace::python
