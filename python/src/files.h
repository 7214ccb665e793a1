// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Words of files in Python.
#pragma once

#include <pybind11/pybind11.h>

#include <string>

#include "findspace/files.h"

namespace findspace::python {

namespace py = pybind11;

/// 'R12' or '2000'; ValueError for another.
DxfVersion dxf_version(const std::string& word);

}  // namespace findspace::python
